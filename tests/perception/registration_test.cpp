#include "perception/registration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/parallel.hpp"
#include "sensors/merge.hpp"
#include "sensors/tilting_lidar.hpp"
#include "tests/sim/support/boxes.hpp"

namespace scanchor {
namespace {

Eigen::Isometry3d pose(double x, double y, double z, double yaw) {
  Eigen::Isometry3d T = testing::at(x, y, z);
  T.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

/// Scans of one furnished room from three places, 1 cm of range noise.
const std::vector<Scan>& scans() {
  static const std::vector<Scan> all = [] {
    const World world(testing::random_boxes(25, 51));
    LidarOptions o;
    o.lines = 120, o.beams_per_line = 240;
    std::vector<Scan> made;
    made.push_back(scan_room(world, pose(1.2, 1.1, 1.3, 0.7), o, 1));
    made.push_back(scan_room(world, pose(4.8, 3.9, 1.2, -2.4), o, 2));
    made.push_back(scan_room(world, pose(1.1, 4.0, 1.4, -0.7), o, 3));
    return made;
  }();
  return all;
}

double angle_deg(const Eigen::Isometry3d& T) {
  return degrees(Eigen::AngleAxisd(T.linear()).angle());
}

TEST(Registration, FindsTheTruePoseFromManyFirstGuesses) {
  MergeOptions error;
  error.position_sigma = 0.08;
  error.angle_sigma_deg = 2.0;
  const Eigen::Isometry3d truth = scans()[0].T_world_sensor.inverse() * scans()[1].T_world_sensor;
  for (std::size_t i = 0; i < 5; ++i) {
    const Eigen::Isometry3d guess = truth * pose_error(error, 7, i);
    const Registration r = register_clouds(scans()[0].cloud, scans()[1].cloud, guess);
    const Eigen::Isometry3d off = truth.inverse() * r.T_target_source;
    EXPECT_TRUE(r.converged);
    EXPECT_EQ(r.free_directions, 0);
    EXPECT_LT(off.translation().norm(), 0.005) << "guess " << i;
    EXPECT_LT(angle_deg(off), 0.1) << "guess " << i;
    EXPECT_GT(r.overlap, 0.3);
    EXPECT_LT(r.residual, 0.02);
  }
}

TEST(Registration, AllScansOfARoomComeTogether) {
  MergeOptions error;
  error.position_sigma = 0.06;
  error.angle_sigma_deg = 1.5;
  const MergedScan merged = merge_scans(scans(), error, 11);
  std::vector<PointCloud> clouds;
  for (const Scan& scan : scans()) clouds.push_back(scan.cloud);
  const auto poses = register_all(clouds, merged.T_first_placed);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Eigen::Isometry3d before = merged.T_first_scan[i].inverse() * merged.T_first_placed[i];
    const Eigen::Isometry3d after = merged.T_first_scan[i].inverse() * poses[i];
    EXPECT_LT(after.translation().norm(), 0.006) << i;
    EXPECT_LT(angle_deg(after), 0.12) << i;
    if (i > 0) {
      EXPECT_GT(before.translation().norm(), 0.02) << "the first guess was worse";
    }
  }
}

TEST(Registration, ALoneWallHoldsThreeDirections) {
  PointCloud wall;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 40; ++j) wall.points.emplace_back(3.0, 0.05 * i, 0.05 * j);
  }
  const Registration r = register_clouds(wall, wall, pose(0.03, 0.02, 0.0, 0.01));
  EXPECT_EQ(r.free_directions, 3);
  // Along the wall it stays as guessed, across it is put right.
  const Eigen::Vector3d moved = r.T_target_source * Eigen::Vector3d(3.0, 1.5, 1.0);
  EXPECT_NEAR(moved.x(), 3.0, 1e-4);
}

TEST(Registration, SameBitsForAnyNumberOfThreadsAndOrderOfPoints) {
  const Eigen::Isometry3d truth = scans()[0].T_world_sensor.inverse() * scans()[1].T_world_sensor;
  const Eigen::Isometry3d guess = truth * testing::at(0.05, 0.02, 0.01);
  PointCloud reversed = scans()[1].cloud;
  std::reverse(reversed.points.begin(), reversed.points.end());
  const Registration a = register_clouds(scans()[0].cloud, scans()[1].cloud, guess);
  const ThreadLimit one(1);
  const Registration b = register_clouds(scans()[0].cloud, reversed, guess);
  EXPECT_EQ(a.T_target_source.matrix(), b.T_target_source.matrix());
}

TEST(Registration, NonFinitePointsAreLeftOutAndTooFewAreBadData) {
  PointCloud cloud = scans()[0].cloud;
  cloud.points[5].x() = std::nan("");
  const Registration r = register_clouds(scans()[0].cloud, cloud, Eigen::Isometry3d::Identity());
  EXPECT_LT((r.T_target_source.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-3);
  cloud.points.resize(20);
  try {
    register_clouds(scans()[0].cloud, cloud, Eigen::Isometry3d::Identity());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
  }
}

TEST(Registration, OptionsAreDescribed) {
  RegisterOptions options;
  OptionList list;
  options.describe(list);
  list.set("reach", "0.7");
  EXPECT_EQ(options.reach, 0.7);
}

}  // namespace
}  // namespace scanchor
