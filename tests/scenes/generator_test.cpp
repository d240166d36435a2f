#include "scenes/generator.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/parallel.hpp"
#include "scenes/truth.hpp"
#include "tests/scenes/support/room_laws.hpp"

namespace scanchor {
namespace {

RoomOptions of(const std::string& family) {
  RoomOptions options;
  options.family = family;
  return options;
}

/// Every family under many seeds and settings.
class EveryFamily : public ::testing::TestWithParam<std::string> {
 protected:
  static constexpr std::uint64_t seeds = 10;
  static constexpr std::uint64_t many = 50;  // five hundred rooms in all
  static RoomOptions options(std::uint64_t seed) {
    RoomOptions options = of(GetParam());
    // Corners of the settings, in turn.
    options.clutter = seed % 3 == 0 ? 1.0 : seed % 3 == 1 ? 0.5 : 0.0;
    options.unusual_sizes = seed % 4 == 3 ? 0.3 : 0.0;
    options.out_of_square_deg = seed % 5 == 4 ? 6.0 : 2.0;
    return options;
  }
};

// bench/laws_bench asks the same of thousands.
TEST_P(EveryFamily, KeepsTheLawsOfRooms) {
  for (std::uint64_t seed = 0; seed < many; ++seed) {
    const GeneratedRoom room = furnish_room(options(seed), seed);
    EXPECT_TRUE(room.complete) << room.scene.name;
    for (const auto& line : testing::broken_laws(room.scene, false)) ADD_FAILURE() << line;
  }
}

// What lies starts a few millimetres above a face that will carry it; what is fixed stands on the
// floor or on something, or hangs.
TEST_P(EveryFamily, LooseThingsStartJustAboveASupport) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Scene scene = generate_room(options(seed), seed);
    for (const auto& thing : scene.instances) {
      if (!thing.loose) continue;
      const Eigen::AlignedBox3d bounds = world_bounds(thing);
      double best = 1e9;
      for (const auto& other : scene.instances) {
        if (&other == &thing) continue;
        for (const auto& part : other.parts) {
          const Eigen::Isometry3d T = other.T_world_instance * part.T_instance_part;
          for (const auto& face : part.faces) {
            if (!face.planar || (T.linear() * face.normal).z() < 0.99) continue;
            const Eigen::Vector3d local =
                T.inverse() *
                Eigen::Vector3d(bounds.center().x(), bounds.center().y(), (T * face.center).z());
            const Eigen::Vector3d d = local - face.center;
            const double u = std::abs(d.dot(face.axis));
            const double v = std::abs(d.dot(face.normal.cross(face.axis)));
            if (u > 0.5 * face.size.x() || v > 0.5 * face.size.y()) continue;
            const double gap = bounds.min().z() - (T * face.center).z();
            if (gap > -1e-6) best = std::min(best, gap);
          }
        }
      }
      EXPECT_LT(best, 0.006) << scene.name << ": " << thing.kind << " " << thing.id;
      EXPECT_GT(best, 0.0009) << scene.name << ": " << thing.kind << " " << thing.id;
    }
  }
}

TEST_P(EveryFamily, GivesTheSameBytesOnOneAndTwoThreads) {
  std::vector<std::string> one(6);
  std::vector<std::string> two(6);
  const std::string family = GetParam();
  const auto fill = [&](std::vector<std::string>& hashes, int threads) {
    const ThreadLimit limit(threads);
    parallel_blocks(hashes.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        hashes[i] = sha256(scene_to_json(generate_room(of(family), i)).dump());
    });
  };
  fill(one, 1);
  fill(two, 2);
  EXPECT_EQ(one, two);
  EXPECT_EQ(std::set<std::string>(one.begin(), one.end()).size(), one.size()) << "seeds differ";
}

INSTANTIATE_TEST_SUITE_P(Generator, EveryFamily, ::testing::ValuesIn(room_families()),
                         [](const auto& family) {
                           std::string name = family.param;
                           for (char& c : name) c = c == ' ' || c == '-' ? '_' : c;
                           return name;
                         });

// With optimisation, without, with sanitizers: every build asks for the same bytes. A change of
// what rooms hold changes these; say so in the CHANGELOG.
TEST(Generator, TheBytesAreThoseOfEveryBuild) {
  const std::map<std::string, std::string> expected = {
      {"office", "cde816fdf19e13b7"},        {"open-plan office", "79ceeab78b0d90c7"},
      {"meeting room", "fdebe583311474bb"},  {"laboratory", "67caca089c14fdab"},
      {"storage aisle", "2f2f7f3ac079b1c8"}, {"kitchen", "94587ee75be76873"},
      {"living room", "9af05a3ae34ded35"},   {"bedroom", "35a14775ae872636"},
      {"corridor", "9f870da603d6ac6e"},      {"floor", "8625dcb90f729edb"}};
  for (const auto& family : room_families()) {
    std::string all;
    for (std::uint64_t seed = 60; seed < 63; ++seed)
      all += scene_to_json(generate_room(of(family), seed)).dump();
    EXPECT_EQ(sha256(all).substr(0, 16), expected.at(family)) << family;
  }
}

TEST(Generator, OfficesHaveWhatTheDemoLooksFor) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Scene scene = generate_room({}, seed);
    std::map<std::string, int> count;
    for (const auto& instance : scene.instances)
      ++count[std::string(class_info(instance.class_id).name)];
    EXPECT_GE(count["desk"], 1) << seed;
    EXPECT_GE(count["monitor"], 2) << seed;
    EXPECT_GE(count["shelf"], 1) << seed;
    EXPECT_GE(count["chair"], 1) << seed;
    EXPECT_GE(count["cabinet"], 1) << seed;
    EXPECT_EQ(count["floor"], 1) << seed;
    EXPECT_EQ(count["wall"], 4) << seed;
    EXPECT_EQ(count["ceiling"], 1) << seed;
    EXPECT_LT(triangle_count(scene), 12000U) << seed;
  }
}

// Screens look at the chair of their desk.
TEST(Generator, MonitorsFaceTheChair) {
  int looked = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = generate_room({}, seed);
    for (const auto& monitor : scene.instances) {
      if (monitor.kind != "monitor") continue;
      const Eigen::Vector3d front = -monitor.T_world_instance.linear().col(1);
      double best = 1e9;
      double cosine = 0.0;
      for (const auto& chair : scene.instances) {
        if (chair.kind != "chair") continue;
        Eigen::Vector3d to =
            chair.T_world_instance.translation() - monitor.T_world_instance.translation();
        to.z() = 0;
        if (to.norm() < best) {
          best = to.norm();
          cosine = front.dot(to.normalized());
        }
      }
      if (best > 1.5) continue;
      ++looked;
      EXPECT_GT(cosine, 0.6) << scene.name;
    }
  }
  EXPECT_GT(looked, 20);
}

TEST(Generator, ClutterAndSizeScaleDoWhatTheySay) {
  double empty = 0;
  double full = 0;
  double small = 0;
  double large = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    RoomOptions options;
    options.clutter = 0.0;
    empty += static_cast<double>(generate_room(options, seed).instances.size());
    options.clutter = 1.0;
    full += static_cast<double>(generate_room(options, seed).instances.size());
    options.size_scale = 1.3;
    large += generate_room(options, seed).bounds.sizes().x();
    options.size_scale = 1.0;
    small += generate_room(options, seed).bounds.sizes().x();
  }
  EXPECT_GT(full, empty + 100);
  EXPECT_GT(large, 1.2 * small);
}

TEST(Generator, ARoomThatLacksSomethingSaysSo) {
  RoomOptions small = of("meeting room");
  small.size_scale = 0.5;  // no table with chairs around fits
  int incomplete = 0;
  for (std::uint64_t seed = 60; seed < 63; ++seed) {
    const GeneratedRoom room = furnish_room(small, seed);
    incomplete += room.complete ? 0 : 1;
    EXPECT_EQ(room.complete, room.tries < most_tries);
  }
  EXPECT_GE(incomplete, 2);
  const GeneratedRoom usual = furnish_room(of("kitchen"), 61);
  EXPECT_TRUE(usual.complete);
  EXPECT_EQ(scene_to_json(usual.scene), scene_to_json(generate_room(of("kitchen"), 61)));
  // From the try after it on, another room comes.
  const GeneratedRoom next = furnish_room(of("kitchen"), 61, usual.tries);
  EXPECT_GT(next.tries, usual.tries);
  EXPECT_NE(scene_to_json(next.scene), scene_to_json(usual.scene));
}

TEST(Generator, UnknownFamilyIsASuggestion) {
  try {
    generate_room(of("ofice"), 1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_usage);
    EXPECT_NE(std::string(error.what()).find("'office'"), std::string::npos);
  }
}

}  // namespace
}  // namespace scanchor
