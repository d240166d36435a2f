#include "reasoning/reason.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/random.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

using test::labels;
using Labels = std::vector<std::string>;

std::vector<test::Plate> office_plates() {
  auto plates = test::paper_room();
  for (const auto& board : test::shelf_boards(4)) plates.push_back(board);
  return plates;
}
const Labels office_labels = {"floor",   "wall",    "wall",  "wall",  "wall",  "ceiling", "desk",
                              "monitor", "monitor", "shelf", "shelf", "shelf", "shelf"};

TEST(Reason, NamesThePapersRoom) {
  const auto labelling =
      reason(test::make_surfaces(test::paper_room()), test::shipped("paper"), {});
  EXPECT_EQ(labels(labelling), (Labels{"floor", "unknown", "unknown", "unknown", "unknown",
                                       "unknown", "desk", "screen", "screen"}));
  EXPECT_NEAR(labelling.up.z(), 1.0, 1e-6);
  EXPECT_LT(labelling.up_sigma, 0.02);
}

TEST(Reason, NamesTheOffice) {
  const auto labelling = reason(test::make_surfaces(office_plates()), test::shipped("office"), {});
  EXPECT_EQ(labels(labelling), office_labels);
  EXPECT_EQ(test::count_things(labelling, "shelf"), 1);
  EXPECT_EQ(test::count_things(labelling, "monitor"), 2);
}

TEST(Reason, DeskTopThatIsHalfInTheShadow) {
  auto plates = office_plates();
  plates[6].fill = 0.6;
  plates[6].length = 1.2;
  plates[6].center.x() -= 0.2;
  plates[6].hidden = 0.4;
  EXPECT_EQ(reason(test::make_surfaces(plates), test::shipped("office"), {}).entities[6].label,
            "desk");
}

TEST(Reason, OrderOfTheSurfacesDoesNotMatter) {
  SequentialRandom random(4);
  auto plates = office_plates();
  const auto surfaces = test::make_surfaces(plates);
  const auto ontology = test::shipped("office");
  const auto first = reason(surfaces, ontology, {});
  for (int round = 0; round < 5; ++round) {
    std::vector<std::size_t> order(plates.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    std::vector<test::Plate> shuffled;
    for (const auto i : order) shuffled.push_back(plates[i]);
    const auto again = reason(test::make_surfaces(shuffled), ontology, {});
    for (std::size_t i = 0; i < order.size(); ++i) {
      EXPECT_EQ(labels(again)[i], labels(first)[order[i]]);
      EXPECT_NEAR(again.entities[i].probability, first.entities[order[i]].probability, 1e-6);
    }
  }
}

TEST(Reason, FrameDoesNotMatterWhenUpIsGiven) {
  SequentialRandom random(8);
  const auto surfaces = test::make_surfaces(office_plates());
  const auto ontology = test::shipped("office");
  for (int i = 0; i < 5; ++i) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
            .normalized()
            .toRotationMatrix();
    T.translation() = Eigen::Vector3d(random.uniform(-50, 50), 3, -7);
    ReasonOptions options;
    const Eigen::Vector3d up = T.linear().col(2);
    options.up =
        std::to_string(up.x()) + "," + std::to_string(up.y()) + "," + std::to_string(up.z());
    EXPECT_EQ(labels(reason(test::moved(surfaces, T), ontology, options)), office_labels);
  }
}

TEST(Reason, TiltedGravityIsMended) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() =
      Eigen::AngleAxisd(radians(3.5), Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  EXPECT_EQ(labels(reason(test::moved(test::make_surfaces(office_plates()), T),
                          test::shipped("office"), {})),
            office_labels);
}

// Honest answers to what cannot be known.

TEST(Reason, EmptyInputIsAnEmptyAnswer) {
  for (const auto* mode : {"default", "paper"}) {
    ReasonOptions options;
    options.mode = mode;
    EXPECT_TRUE(reason(Surfaces{}, test::shipped("office"), options).entities.empty());
  }
}

TEST(Reason, WithoutAFloorNothingStandsOnIt) {
  // A table top of floor size above the lower ends of the walls is no floor.
  std::vector<test::Plate> plates = test::paper_room();
  plates[0] = {{0, 0, 0.74}, {0, 0, 1}, {1, 0, 0}, 3.0, 1.4};
  const auto all = labels(reason(test::make_surfaces(plates), test::shipped("office"), {}));
  EXPECT_EQ(std::count(all.begin(), all.end(), "floor"), 0);
  EXPECT_EQ(std::count(all.begin(), all.end(), "desk"), 0);
  EXPECT_EQ(std::count(all.begin(), all.end(), "wall"), 4);
}

TEST(Reason, UpsideDownIsNotNamedWithConfidence) {
  auto plates = office_plates();
  for (int i = 0; i < 4; ++i) {  // workplaces in a row
    const double x = -2.1 + 1.45 * i;
    plates.push_back({{x, 0.0, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.4, 0.75});
    plates.push_back({{x, 0.2, 1.06}, {0, 1, 0}, {1, 0, 0}, 0.54, 0.32});
  }
  auto surfaces = test::make_surfaces(plates);
  surfaces.sensor_positions = {Eigen::Vector3d(0.2, -0.8, 1.4)};
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto ontology = test::shipped("office");
  const auto upright = labels(reason(surfaces, ontology, {}));
  EXPECT_EQ(std::count(upright.begin(), upright.end(), "desk"), 5);
  for (const auto& entity : reason(test::moved(surfaces, T), ontology, {}).entities) {
    if (entity.label == "unknown") continue;
    EXPECT_LT(entity.probability, 0.6) << entity.label;
  }
  ReasonOptions options;
  options.up = "auto";
  EXPECT_EQ(labels(reason(test::moved(surfaces, T), ontology, options)), upright);
}

TEST(Reason, OneClassIsNotTheAnswerToEverything) {
  const auto ontology = parse_ontology(
      "class desk:\n    area 0.9..1.7 m2\n    extension 1.2..2 m\n    rectangular\n    "
      "horizontal\n",
      "x.sdl");
  const auto all = labels(reason(test::make_surfaces(office_plates()), ontology, {}));
  EXPECT_EQ(std::count(all.begin(), all.end(), "desk"), 1);
}

TEST(Reason, FiveThousandIdenticalSurfaces) {
  std::vector<test::Plate> plates(5000, test::desk_plate());
  const auto labelling = reason(test::make_surfaces(plates), test::shipped("office"), {});
  ASSERT_EQ(labelling.entities.size(), 5000U);
  for (const auto& entity : labelling.entities)
    EXPECT_EQ(entity.label, labelling.entities[0].label);
  EXPECT_NE(labelling.entities[0].label, "desk") << "without a floor there is no desk";
}

TEST(Reason, ContradictionsHoldForNothing) {
  const auto ontology = parse_ontology(
      "class a:\n    horizontal\n    vertical\nclass b:\n    extension at most 1 m\n    extension "
      "at least 3 m\n",
      "x.sdl");
  for (const auto& label : labels(reason(test::make_surfaces(office_plates()), ontology, {})))
    EXPECT_EQ(label, "unknown");
}

TEST(Reason, BadInputIsRefused) {
  ReasonOptions options;
  options.mode = "papre";
  EXPECT_THROW(reason(Surfaces{}, test::shipped("paper"), options), Error);
  auto surfaces = test::make_surfaces(office_plates());
  surfaces.surfaces[2].plane.normal.x() = NAN;
  EXPECT_THROW(reason(surfaces, test::shipped("paper"), {}), Error);
}

TEST(Reason, SurfacesWithoutShapeAreUnknown) {
  auto surfaces = test::make_surfaces(office_plates());
  for (auto& s : surfaces.surfaces) {
    s.polygons.clear();
    s.rectangle = {};
    s.area = {};
  }
  for (const auto& label : labels(reason(surfaces, test::shipped("office"), {})))
    EXPECT_EQ(label, "unknown");
}

}  // namespace
}  // namespace scanchor
