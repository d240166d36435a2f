#include "reasoning/places.hpp"

#include <gtest/gtest.h>

#include "core/json.hpp"
#include "tests/reasoning/support/labelled.hpp"

namespace scanchor {
namespace {

using test::Named;
using Status = Answer::Status;

/// A floor of 6 x 5 m, a desk 1.6 x 0.8 m at (0, 1) 74 cm high, and an upright cabinet front at
/// (2, 2) that looks to -y; the sensor stands at the origin.
std::vector<Named> room_with_desk() {
  return {{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 6.0, 5.0}, "floor"},
          {{{0, 1, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.6, 0.8}, "desk"},
          {{{2, 2, 0.6}, {0, -1, 0}, {0, 0, 1}, 1.2, 0.8}, "cabinet"}};
}

struct AskedPlace {
  PlaceAnswer answer;
  std::string text;
  nlohmann::ordered_json json;
};

AskedPlace ask_place(const std::string& question, const std::vector<Named>& named,
                     const std::vector<std::pair<int, Ring>>& holes = {}) {
  auto scene = test::labelled(named);
  for (const auto& [surface, hole] : holes)
    scene.surfaces.surfaces[static_cast<std::size_t>(surface)].polygons[0].holes.push_back(hole);
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  const auto parsed = parse_place_question(question, test::office());
  AskedPlace asked;
  asked.answer = find_places(*parsed, scene.surfaces, scene.labelling, things);
  asked.text = places_text(asked.answer, things);
  asked.json = places_to_json(asked.answer, things);
  return asked;
}

TEST(Places, AnEmptyDeskIsFreeInItsMiddle) {
  const AskedPlace asked = ask_place("free place of 30 x 40 cm on a desk", room_with_desk());
  ASSERT_EQ(asked.answer.status, Status::ok) << asked.text;
  const FoundPlace& place = asked.answer.places.at(0);
  EXPECT_NEAR((place.T_cloud_place.translation() - Eigen::Vector3d(0, 1, 0.74)).norm(), 0.0, 0.02);
  EXPECT_EQ(asked.json["kind"], "free_place");
  EXPECT_EQ(asked.json["places"][0]["corners"].size(), 4u);
  EXPECT_NEAR(place.margin, 0.25, 0.005) << "0.8 m less 30 cm, both sides";
  EXPECT_NEAR(place.unseen, 0.0, 1e-12);
}

TEST(Places, KeepsClearOfWhatStandsThere) {
  auto things = room_with_desk();
  // A box at the right half, a lamp hung 30 cm above the left quarter, a picture too high to
  // matter.
  things.push_back({{{0.45, 1, 0.84}, {0, -1, 0}, {1, 0, 0}, 0.6, 0.2}, "box"});
  things.push_back({{{-0.7, 1, 1.04}, {0, 0, 1}, {0, 1, 0}, 0.8, 0.2}, "unknown"});
  things.push_back({{{-0.3, 1, 1.6}, {0, 0, 1}, {1, 0, 0}, 0.5, 0.4}, "unknown"});
  const AskedPlace asked = ask_place("free place of 60 x 40 cm on a desk", things);
  ASSERT_EQ(asked.answer.status, Status::ok) << asked.text;
  const FoundPlace& place = asked.answer.places.at(0);
  Eigen::AlignedBox3d corners;
  for (const double u : {-0.5, 0.5}) {
    for (const double v : {-0.5, 0.5})
      corners.extend(place.T_cloud_place *
                     Eigen::Vector3d(u * place.size.x(), v * place.size.y(), 0));
  }
  EXPECT_GE(corners.min().x(), -0.6 - 1e-6);
  EXPECT_LE(corners.max().x(), 0.8 + 1e-6);
  EXPECT_TRUE(corners.max().x() <= 0.15 + 1e-6 || corners.min().y() >= 1.0 - 1e-6 ||
              corners.max().y() <= 1.0 + 1e-6)
      << "beside, behind or in front of the box, and not across its front";
  // The free strip is 75 cm wide at most: a place of 90 x 50 fits nowhere.
  EXPECT_EQ(ask_place("free place of 90 x 50 cm on a desk", things).answer.status,
            Status::not_found);
}

TEST(Places, TellsSeenFromUnseen) {
  // The middle of the desk lies in a shadow: strips of 20 cm remain at its ends.
  const Ring shadow = {{-0.6, -0.4}, {-0.6, 0.4}, {0.6, 0.4}, {0.6, -0.4}};
  EXPECT_EQ(ask_place("free place of 15 x 30 cm on a desk", room_with_desk(), {{1, shadow}})
                .answer.status,
            Status::ok);
  const AskedPlace larger =
      ask_place("free place of 30 x 40 cm on a desk", room_with_desk(), {{1, shadow}});
  EXPECT_EQ(larger.answer.status, Status::not_seen) << larger.text;
  ASSERT_EQ(larger.answer.places.size(), 1u);
  EXPECT_GT(larger.answer.places[0].unseen, 0.9);
  EXPECT_NE(larger.text.find("not seen"), std::string::npos) << larger.text;
}

TEST(Places, ARobotStandsBeforeTheFront) {
  const AskedPlace asked =
      ask_place("where could a robot stand in front of the cabinet?", room_with_desk());
  ASSERT_EQ(asked.answer.status, Status::ok) << asked.text;
  const FoundPlace& place = asked.answer.places.at(0);
  EXPECT_NEAR((place.T_cloud_place.translation() - Eigen::Vector3d(2, 1.35, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((place.T_cloud_place.linear().col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-6)
      << "it looks at the cabinet";
  EXPECT_NEAR(place.distance, 0.65, 1e-9);
}

TEST(Places, ARobotGivesWay) {
  auto things = room_with_desk();
  things.push_back({{{2, 1.3, 0.2}, {0, -1, 0}, {1, 0, 0}, 0.3, 0.3}, "box"});
  const AskedPlace asked = ask_place("where could a robot stand in front of the cabinet", things);
  ASSERT_FALSE(asked.answer.places.empty()) << asked.text;
  const Eigen::Vector3d at = asked.answer.places[0].T_cloud_place.translation();
  // Distance to the box, a wall 30 cm wide at y = 1.3, and to the cabinet's front at y = 2.
  const double aside = std::max(0.0, std::abs(at.x() - 2.0) - 0.15);
  EXPECT_GE(std::hypot(aside, at.y() - 1.3), 0.3 - 1e-6);
  EXPECT_LE(at.y(), 2.0 - 0.3 + 1e-6);
  EXPECT_LE(std::abs(at.x() - 2.0), 0.4 + 1e-6);
  // Walls before all of it.
  things.push_back({{{2, 1.7, 0.5}, {0, -1, 0}, {1, 0, 0}, 3.0, 1.0}, "wall"});
  things.push_back({{{2, 0.6, 0.5}, {0, -1, 0}, {1, 0, 0}, 3.0, 1.0}, "wall"});
  things.push_back({{{2, 1.0, 0.5}, {0, -1, 0}, {1, 0, 0}, 3.0, 1.0}, "wall"});
  EXPECT_EQ(ask_place("where could a robot stand in front of the cabinet", things).answer.status,
            Status::not_found);
}

TEST(Places, WithoutAFloorThereIsAnError) {
  auto things = room_with_desk();
  things[0].label = "unknown";
  EXPECT_THROW(ask_place("place to stand in front of the cabinet", things), std::exception);
}

TEST(Places, WithoutTheThingThereIsItsMiss) {
  const AskedPlace asked = ask_place("free place of 10 x 10 cm on a window", room_with_desk());
  EXPECT_EQ(asked.answer.status, Status::not_found);
  EXPECT_TRUE(asked.answer.places.empty());
  EXPECT_NE(asked.text.find("not found"), std::string::npos) << asked.text;
}

}  // namespace
}  // namespace scanchor
