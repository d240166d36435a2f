#include "perception/set_aside.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/random.hpp"

namespace scanchor {
namespace {

Eigen::Vector3d direction(SequentialRandom& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

PointCloud with_sensor_at(const Eigen::Vector3d& position) {
  PointCloud cloud;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  cloud.sensor_poses.push_back(pose);
  return cloud;
}

TEST(SetAside, CountsEachCauseOnce) {
  SequentialRandom random(1);
  const Eigen::Vector3d sensor(1, 2, 3);
  PointCloud cloud = with_sensor_at(sensor);
  const auto put = [&](int count, double low, double high) {
    for (int i = 0; i < count; ++i)
      cloud.points.push_back(sensor + random.uniform(low, high) * direction(random));
  };
  put(5000, 1.0, 8.0);      // surfaces
  put(600, 0.15, 0.35);     // the scanner's own body
  put(300, 29.9995, 30.0);  // nothing seen
  for (int i = 0; i < 7; ++i)
    cloud.points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  cloud.points.emplace_back(0, std::numeric_limits<double>::infinity(), 0);
  const UsablePoints usable = set_aside(cloud, -1.0);
  EXPECT_EQ(usable.set_aside.not_finite, 8U);
  EXPECT_EQ(usable.set_aside.scanner_body, 600U);
  EXPECT_EQ(usable.set_aside.out_of_range, 300U);
  EXPECT_EQ(usable.index.size(), 5000U);
  EXPECT_TRUE(std::is_sorted(usable.index.begin(), usable.index.end()));
}

// Beams that half hit the body's edge return from between it and the room.
TEST(SetAside, MixedPixelsDoNotHideTheBody) {
  SequentialRandom random(4);
  PointCloud cloud = with_sensor_at({0, 0, 0});
  for (int i = 0; i < 2000; ++i)
    cloud.points.push_back(random.uniform(0.10, 0.18) * direction(random));
  for (int i = 0; i < 60; ++i)
    cloud.points.push_back(random.uniform(0.18, 1.0) * direction(random));
  for (int i = 0; i < 8000; ++i)
    cloud.points.push_back(random.uniform(1.0, 6.0) * direction(random));
  const UsablePoints usable = set_aside(cloud, -1.0);
  EXPECT_GE(usable.set_aside.scanner_body, 2000U);
  EXPECT_LE(usable.set_aside.scanner_body, 2040U);
  EXPECT_LT(usable.body_radius, 0.6);
}

TEST(SetAside, WithoutASensorOnlyNumbersThatAreNone) {
  SequentialRandom random(2);
  PointCloud cloud;
  for (int i = 0; i < 100; ++i) cloud.points.push_back(0.2 * direction(random));
  EXPECT_EQ(set_aside(cloud, -1.0).index.size(), 100U);
}

TEST(SetAside, ATableRightBeforeTheScannerIsNoBody) {
  SequentialRandom random(3);
  PointCloud cloud = with_sensor_at({0, 0, 0});
  // Ranges without a gap from 0.3 m on.
  for (int i = 0; i < 5000; ++i)
    cloud.points.push_back(random.uniform(0.3, 5.0) * direction(random));
  EXPECT_EQ(set_aside(cloud, -1.0).set_aside.scanner_body, 0U);
  EXPECT_GT(set_aside(cloud, 0.5).set_aside.scanner_body, 100U);  // told, it obeys
}

TEST(SetAside, AWallAtTheLargestRangeStays) {
  PointCloud cloud = with_sensor_at({0, 0, 0});
  for (int i = -50; i <= 50; ++i) {
    for (int j = -50; j <= 50; ++j) cloud.points.emplace_back(5.0, 0.05 * i, 0.05 * j);
  }
  EXPECT_EQ(set_aside(cloud, -1.0).set_aside.out_of_range, 0U);
}

TEST(SetAside, EmptyAndAllNaN) {
  EXPECT_TRUE(set_aside(PointCloud{}, -1.0).index.empty());
  PointCloud cloud = with_sensor_at({0, 0, 0});
  cloud.points.assign(3, Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(set_aside(cloud, -1.0).set_aside.not_finite, 3U);
}

}  // namespace
}  // namespace scanchor
