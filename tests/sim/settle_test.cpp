#include "sim/settle.hpp"

#include <gtest/gtest.h>

#include "tests/sim/support/boxes.hpp"

namespace scanchor {
namespace {

using testing::at;
using testing::box_instance;

Scene table_room() {
  Scene scene = testing::empty_scene();
  testing::add_room(scene, {4, 4, 3});
  scene.instances.push_back(
      box_instance(20, {1.6, 0.8, 0.04}, at(2, 2, 0.72)));  // a board, top at 0.74
  return scene;
}

double lowest(const Instance& instance) {
  double z = 1e9;
  for (const Part& part : instance.parts) {
    for (const auto& v : part.vertices) {
      z = std::min(z, (instance.T_world_instance * part.T_instance_part * v).z());
    }
  }
  return z;
}

/// Corners of one box inside another, as depth: an oracle that knows nothing of Bullet.
double corner_depth(const Instance& a, const Instance& b) {
  Eigen::AlignedBox3d box;
  for (const auto& v : b.parts[0].vertices) box.extend(v);
  double deepest = 0.0;
  for (const auto& v : a.parts[0].vertices) {
    const Eigen::Vector3d p = b.T_world_instance.inverse() * (a.T_world_instance * v);
    const double inside = (p - box.min()).cwiseMin(box.max() - p).minCoeff();
    deepest = std::max(deepest, inside);
  }
  return deepest;
}

TEST(Settle, BoxComesToRestOnTheTable) {
  Scene scene = table_room();
  scene.instances.push_back(
      box_instance(30, {0.3, 0.2, 0.15}, at(2, 2, 0.74 + 0.075 + 0.02), true));
  const SettleReport report = settle(scene, {});
  EXPECT_TRUE(report.settled) << (report.problems.empty() ? "" : report.problems[0]);
  EXPECT_EQ(report.loose, 1U);
  EXPECT_NEAR(lowest(scene.instances.back()), 0.74, 0.001);
  EXPECT_LE(report.deepest_penetration, 0.001);
  EXPECT_LT(report.simulated_time, 2.0) << "stops when all is at rest";
}

TEST(Settle, FallsToTheFloorBesideTheTable) {
  Scene scene = table_room();
  scene.instances.push_back(box_instance(30, {0.3, 0.2, 0.15}, at(0.5, 2, 0.8), true));
  const SettleReport report = settle(scene, {});
  EXPECT_TRUE(report.settled);
  EXPECT_NEAR(lowest(scene.instances.back()), 0.0, 0.001);
}

TEST(Settle, StackStandsWithinAMillimetre) {
  Scene scene = table_room();
  double z = 0.74;
  for (int i = 0; i < 4; ++i) {
    z += 0.005 + 0.05;
    scene.instances.push_back(box_instance(30 + i, {0.3, 0.25, 0.1}, at(2 + 0.01 * i, 2, z), true));
    z += 0.05;
  }
  const SettleReport report = settle(scene, {});
  EXPECT_TRUE(report.settled) << (report.problems.empty() ? "" : report.problems[0]);
  const std::size_t n = scene.instances.size();
  for (std::size_t i = n - 4; i < n; ++i) {
    EXPECT_LE(corner_depth(scene.instances[i], scene.instances[i - 1]), 0.001);
    EXPECT_NEAR(lowest(scene.instances[i]), 0.74 + 0.1 * static_cast<double>(i + 4 - n), 0.002);
  }
}

TEST(Settle, ManySmallThingsDoNotInterpenetrate) {
  Scene scene = table_room();
  SequentialRandom random(17);
  const std::size_t first = scene.instances.size();
  for (int i = 0; i < 25; ++i) {
    Eigen::Isometry3d pose = at(1.3 + 0.3 * (i % 5), 1.7 + 0.14 * (i / 5), 0.74 + 0.06);
    pose.linear() =
        Eigen::AngleAxisd(random.uniform(0, 3), Eigen::Vector3d::UnitZ()).toRotationMatrix();
    scene.instances.push_back(box_instance(
        30 + i, {random.uniform(0.03, 0.12), random.uniform(0.03, 0.1), random.uniform(0.01, 0.1)},
        pose, true));
  }
  const SettleReport report = settle(scene, {});
  EXPECT_TRUE(report.settled) << (report.problems.empty() ? "" : report.problems[0]);
  for (std::size_t i = first; i < scene.instances.size(); ++i) {
    for (std::size_t j = 0; j < scene.instances.size(); ++j) {
      if (i == j) continue;
      EXPECT_LE(corner_depth(scene.instances[i], scene.instances[j]), 0.001) << i << " in " << j;
    }
  }
}

TEST(Settle, HullStandsOnItsBase) {
  Scene scene = table_room();
  // A pyramid is no box: it collides as a hull, and the margin must not lift it.
  Instance pyramid = box_instance(30, {0.2, 0.2, 0.2}, at(2, 2, 0.86), true);
  Part& part = pyramid.parts[0];
  for (auto& v : part.vertices) {
    if (v.z() > 0) v.head<2>() *= 0.2;
  }
  scene.instances.push_back(pyramid);
  const SettleReport report = settle(scene, {});
  EXPECT_TRUE(report.settled) << (report.problems.empty() ? "" : report.problems[0]);
  EXPECT_NEAR(lowest(scene.instances.back()), 0.74, 0.001);
}

TEST(Settle, SameSceneSameBits) {
  const auto once = [] {
    Scene scene = table_room();
    for (int i = 0; i < 6; ++i) {
      Eigen::Isometry3d pose = at(2 + 0.05 * i, 2, 0.9 + 0.12 * i);
      pose.linear() =
          Eigen::AngleAxisd(0.4 * i, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
      scene.instances.push_back(box_instance(30 + i, {0.2, 0.1, 0.1}, pose, true));
    }
    settle(scene, {});
    return scene;
  };
  const Scene a = once();
  const Scene b = once();
  for (std::size_t i = 0; i < a.instances.size(); ++i) {
    EXPECT_EQ(a.instances[i].T_world_instance.matrix(), b.instances[i].T_world_instance.matrix());
  }
}

TEST(Settle, WhatStandsOnTheEdgeTopples) {
  Scene scene = table_room();
  // Two thirds of it lie beyond the edge of the board at x = 2.8.
  scene.instances.push_back(box_instance(30, {0.3, 0.2, 0.1}, at(2.85, 2, 0.80), true));
  settle(scene, {});
  EXPECT_LT(lowest(scene.instances.back()), 0.3);
}

TEST(Settle, ReportsWhatFallsOut) {
  Scene scene = testing::empty_scene();
  scene.bounds = Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 4, 3));
  scene.instances.push_back(box_instance(1, {1, 1, 0.1}, at(2, 2, -0.05)));
  scene.instances.push_back(box_instance(2, {0.2, 0.2, 0.2}, at(0.5, 0.5, 1), true));
  SettleOptions options;
  options.maximum_time = 1.0;
  const SettleReport report = settle(scene, options);
  EXPECT_FALSE(report.settled);
  ASSERT_EQ(report.problems.size(), 1U);
  EXPECT_EQ(report.problems[0], "box 2 fell out of the room");
}

TEST(Settle, ReportsWhatStillMoves) {
  Scene scene = table_room();
  scene.instances.push_back(box_instance(30, {0.2, 0.2, 0.2}, at(0.5, 0.5, 2.5), true));
  SettleOptions options;
  options.maximum_time = 0.3;
  const SettleReport report = settle(scene, options);
  EXPECT_FALSE(report.settled);
  ASSERT_EQ(report.problems.size(), 1U);
  EXPECT_NE(report.problems[0].find("still moves"), std::string::npos);
}

TEST(Settle, NothingLooseIsSettledAsItIs) {
  Scene scene = table_room();
  const Eigen::Matrix4d before = scene.instances.back().T_world_instance.matrix();
  const SettleReport report = settle(scene, {});
  EXPECT_TRUE(report.settled);
  EXPECT_EQ(report.simulated_time, 0.0);
  EXPECT_EQ(scene.instances.back().T_world_instance.matrix(), before);
}

TEST(Settle, OptionsAreDescribed) {
  SettleOptions options;
  OptionList list;
  options.describe(list);
  list.set("rest_speed", "0.02");
  EXPECT_EQ(options.rest_speed, 0.02);
}

}  // namespace
}  // namespace scanchor
