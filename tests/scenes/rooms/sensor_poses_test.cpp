#include <gtest/gtest.h>

#include <cmath>

#include "scenes/collide.hpp"
#include "scenes/generator.hpp"
#include "scenes/rooms/rooms.hpp"

namespace scanchor {
namespace {

TEST(BlockedView, OfAWallInFrontIsItsSolidAngle) {
  // A wall 0.5 m in front that fills the view to 1 m of range: cone of acos(0.5 / 1) about the
  // axis.
  const OrientedBox wall{{0.55, 0, 0}, Eigen::Matrix3d::Identity(), {0.05, 9, 9}};
  const double share = blocked_view({wall}, Eigen::Vector3d::Zero(), {1, 0}, 1.0);
  // Counted over a fine grid: elevation within 45 degrees, and cos(turn) cos(elevation) > 0.5.
  double hit = 0.0;
  double total = 0.0;
  for (int i = 0; i < 900; ++i) {
    const double elevation = (-45.0 + 90.0 * (i + 0.5) / 900) * M_PI / 180;
    for (int k = 0; k < 1800; ++k) {
      const double turn = (-90.0 + 180.0 * (k + 0.5) / 1800) * M_PI / 180;
      total += std::cos(elevation);
      if (std::cos(turn) * std::cos(elevation) > 0.5) hit += std::cos(elevation);
    }
  }
  EXPECT_NEAR(share, hit / total, 0.03);
  EXPECT_EQ(blocked_view({wall}, Eigen::Vector3d::Zero(), {-1, 0}, 1.0), 0.0);
  EXPECT_EQ(blocked_view({wall}, Eigen::Vector3d::Zero(), {1, 0}, 0.4), 0.0);
}

TEST(BlockedView, TurnsWithTheLook) {
  const OrientedBox box{{0.0, 0.6, 0}, Eigen::Matrix3d::Identity(), {0.1, 0.1, 0.1}};
  const double ahead = blocked_view({box}, Eigen::Vector3d::Zero(), {0, 1}, 1.0);
  EXPECT_GT(ahead, 0.0);
  EXPECT_LT(ahead, 0.1);
  EXPECT_EQ(blocked_view({box}, Eigen::Vector3d::Zero(), {0, -1}, 1.0), 0.0);
}

TEST(SensorPoses, HaveAClearView) {
  for (const std::string family : {"office", "meeting room", "laboratory", "living room"}) {
    int clear = 0;
    for (std::uint64_t seed = 60; seed < 66; ++seed) {
      RoomOptions options;
      options.family = family;
      const Scene scene = generate_room(options, seed);
      std::vector<OrientedBox> boxes;
      for (const auto& instance : scene.instances) {
        for (const auto& box : part_boxes(instance)) boxes.push_back(box);
      }
      ASSERT_FALSE(scene.sensor_poses.empty());
      const auto& pose = scene.sensor_poses.front();
      const Eigen::Vector3d x = pose.linear().col(0);
      const double blocked = blocked_view(boxes, pose.translation(), x.head<2>(), 1.0);
      EXPECT_LT(blocked, 0.25) << family << " " << seed;
      if (blocked < 0.05) ++clear;
    }
    EXPECT_GE(clear, 5) << family;
  }
}

}  // namespace
}  // namespace scanchor
