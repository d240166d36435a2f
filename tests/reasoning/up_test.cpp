#include "reasoning/up.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/random.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

double off_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

TEST(Up, FloorAndWallsMendATiltedGuess) {
  SequentialRandom random(2);
  const auto room = test::make_surfaces(test::paper_room());
  for (int i = 0; i < 30; ++i) {
    const double turn = radians(4.0) * random.uniform();
    const Eigen::Vector3d axis =
        Eigen::Vector3d(random.normal(), random.normal(), 0.0).normalized();
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = Eigen::AngleAxisd(turn, axis).toRotationMatrix();
    const auto up = find_up(test::moved(room, T), "0,0,1", radians(3.0));
    EXPECT_LT(off_deg(up.up, T.linear().col(2)), 0.3) << "tilted by " << degrees(turn);
    EXPECT_LT(up.sigma, radians(0.6));
    EXPECT_GT(up.supports, 4);
  }
}

TEST(Up, StaysWhereItWasWithoutEvidence) {
  const auto up = find_up(Surfaces{}, "0,0,2", radians(3.0));
  EXPECT_LT(off_deg(up.up, Eigen::Vector3d::UnitZ()), 1e-6);
  EXPECT_NEAR(up.sigma, radians(3.0), 1e-6);
}

TEST(Up, AutoFindsItInAnyPose) {
  SequentialRandom random(9);
  auto plates = test::paper_room();
  for (int i = 0; i < 3; ++i)
    plates.push_back({{-1.5 + i, -1.0, 0.74}, {0, 0, 1}, {1, 0, 0}, 0.9, 0.8});
  auto room = test::make_surfaces(plates);
  room.sensor_positions = {Eigen::Vector3d(0, 0, 1.4)};
  for (int i = 0; i < 20; ++i) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() =
        Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
            .normalized()
            .toRotationMatrix();
    const auto up = find_up(test::moved(room, T), "auto", 0.1);
    EXPECT_LT(off_deg(up.up, T.linear().col(2)), 1.0);
  }
}

TEST(Up, UpsideDownIsNoticed) {
  auto room = test::make_surfaces(test::paper_room());
  room.sensor_positions = {Eigen::Vector3d(0, 0, 1.4)};
  EXPECT_GT(find_up(room, "0,0,1", 0.03).upright, 0.9);
  auto plates = test::paper_room();
  for (int i = 0; i < 4; ++i)
    plates.push_back({{-1.5 + i, -1.0, 0.74}, {0, 0, 1}, {1, 0, 0}, 0.9, 0.9});
  auto full = test::make_surfaces(plates);
  full.sensor_positions = {Eigen::Vector3d(0, 0, 1.4)};
  EXPECT_LT(find_up(full, "0,0,-1", 0.03).upright, 0.3);
}

TEST(Up, HighRacksAreNotUpsideDown) {
  // An aisle between racks of 4 m: most boards hang above the scanner and are seen from below, but
  // cartons and posts stand on the floor.
  std::vector<test::Plate> plates = {{{4, 0, 0}, {0, 0, 1}, {1, 0, 0}, 12, 4},        // floor
                                     {{4, 0, 5}, {0, 0, -1}, {1, 0, 0}, 12, 4},       // ceiling
                                     {{4, 2.2, 2.5}, {0, -1, 0}, {1, 0, 0}, 12, 5}};  // wall
  for (int i = 0; i < 5; ++i) {
    for (const double z : {1.8, 2.8, 3.8})
      plates.push_back({{2.0 * i, 1.5, z}, {0, 0, -1}, {1, 0, 0}, 1.8, 0.9});
    for (int k = 0; k < 6; ++k)
      plates.push_back({{2.0 * i + 0.3 * k - 0.9, 1.2, 0.2}, {0, -1, 0}, {1, 0, 0}, 0.4, 0.4});
    plates.push_back({{2.0 * i + 1.0, 1.2, 2.0}, {0, -1, 0}, {0, 0, 1}, 4.0, 0.1});
  }
  auto aisle = test::make_surfaces(plates);
  aisle.sensor_positions = {Eigen::Vector3d(0, 0, 1.4)};
  EXPECT_GT(find_up(aisle, "0,0,1", 0.03).upright, 0.9);
  EXPECT_LT(find_up(aisle, "0,0,-1", 0.03).upright, 0.5);
}

TEST(Up, RefusesWhatIsNoDirection) {
  EXPECT_THROW(find_up(Surfaces{}, "upwards", 0.03), Error);
  EXPECT_THROW(find_up(Surfaces{}, "0,0,0", 0.03), Error);
  EXPECT_THROW(find_up(Surfaces{}, "0,0,1,2", 0.03), Error);
}

}  // namespace
}  // namespace scanchor
