#include "scenes/collide.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "scenes/pose.hpp"
#include "scenes/shell.hpp"

namespace scanchor {
namespace {

Instance box_thing(std::int32_t id, const Eigen::Vector3d& size, const Eigen::Isometry3d& pose) {
  Instance instance;
  instance.id = id;
  instance.kind = "box";
  instance.parts.push_back(box_part("box", 0, {0, 0, 0}, size));
  instance.T_world_instance = pose;
  return instance;
}

OrientedBox random_box(SequentialRandom& random) {
  OrientedBox box;
  box.center = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  box.axes = rotation_about(2, random.uniform(-3, 3)) * rotation_about(0, random.uniform(-3, 3));
  box.half = {random.uniform(0.05, 0.7), random.uniform(0.05, 0.7), random.uniform(0.05, 0.7)};
  return box;
}

// Oracle: a grid of points of one box, asked whether they lie in the other.
TEST(Collide, BoxesOverlapWhereTheySharePoints) {
  SequentialRandom random(5);
  int overlapping = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const OrientedBox a = random_box(random);
    const OrientedBox b = random_box(random);
    bool shared = false;
    for (int i = 0; i <= 10 && !shared; ++i) {
      for (int j = 0; j <= 10 && !shared; ++j) {
        for (int k = 0; k <= 10 && !shared; ++k) {
          const Eigen::Vector3d unit(i / 5.0 - 1, j / 5.0 - 1, k / 5.0 - 1);
          const Eigen::Vector3d p = a.center + a.axes * unit.cwiseProduct(a.half);
          shared = ((b.axes.transpose() * (p - b.center)).cwiseAbs() - b.half).maxCoeff() <= 0;
        }
      }
    }
    if (shared) {
      ++overlapping;
      EXPECT_TRUE(boxes_near(a, b, 0.0));
    } else if (boxes_near(a, b, -0.15)) {
      ADD_FAILURE() << "deep overlap without a shared grid point";
    }
    EXPECT_EQ(boxes_near(a, b, 0.01), boxes_near(b, a, 0.01));
  }
  EXPECT_GT(overlapping, 20);
  EXPECT_LT(overlapping, 180);
}

TEST(Collide, InterpenetrationsAreNamed) {
  Scene scene;
  scene.instances.push_back(box_thing(1, {1, 1, 1}, pose_at({0, 0, 0})));
  scene.instances.push_back(box_thing(2, {1, 1, 1}, pose_at({0.999, 0, 0})));
  scene.instances.push_back(box_thing(3, {1, 1, 1}, pose_at({3, 0, 0})));
  EXPECT_EQ(interpenetrations(scene, 0.0005).size(), 1U);
  EXPECT_EQ(interpenetrations(scene, 0.002).size(), 0U);
  EXPECT_EQ(interpenetrations(scene, 0.0005)[0], "box 1 'box' and box 2 'box'");
}

TEST(Collide, CloseParallelFacesAreFound) {
  Scene scene;
  scene.instances.push_back(box_thing(1, {1, 1, 0.1}, pose_at({0, 0, 0})));
  scene.instances.push_back(box_thing(2, {0.5, 0.5, 0.1}, pose_at({0, 0, 0.1005})));
  auto pairs = close_parallel_faces(scene, 0.001);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_NEAR(pairs[0].distance, 0.0005, 1e-9);
  EXPECT_FALSE(pairs[0].same_side);
  scene.instances[1].T_world_instance = pose_at({0, 0, 0.102});
  EXPECT_TRUE(close_parallel_faces(scene, 0.001).empty());
  // Beside each other they share a plane but nothing overlaps.
  scene.instances[1].T_world_instance = pose_at({0.76, 0, 0});
  EXPECT_TRUE(close_parallel_faces(scene, 0.001).empty());
  // Flush tops of things that run into each other tie for every ray from above.
  scene.instances[1].T_world_instance = pose_at({0.6, 0, 0});
  pairs = close_parallel_faces(scene, 0.001);
  ASSERT_FALSE(pairs.empty());
  EXPECT_TRUE(pairs[0].same_side);
  // Crossing at an angle they do not.
  scene.instances[1].T_world_instance = pose_at({0, 0, 0.05}, rotation_about(0, 0.3));
  EXPECT_TRUE(close_parallel_faces(scene, 0.001).empty());
}

TEST(Collide, AWallOfBoxesCutsTheFloorInTwo) {
  Scene scene;
  add_plain_room(scene, {4, 3, 2.5});
  const Eigen::AlignedBox2d room(Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 3));
  const FloorGrid empty = walkable_floor(scene, room, 0.2, {0.5, 0.5});
  EXPECT_DOUBLE_EQ(empty.reachable_share(), 1.0);
  EXPECT_TRUE(empty.is_reachable({3.5, 2.5}));
  EXPECT_FALSE(empty.is_free({0.1, 1.0})) << "walls keep the radius off";
  scene.instances.push_back(box_thing(20, {0.3, 3, 1}, pose_at({2, 1.5, 0.5})));
  const FloorGrid cut = walkable_floor(scene, room, 0.2, {0.5, 0.5});
  EXPECT_FALSE(cut.is_reachable({3.5, 2.5}));
  EXPECT_FALSE(cut.is_free({2.0, 1.5}));
  EXPECT_NEAR(cut.reachable_share(), 0.5, 0.05);
  // Above people's heads it is in nobody's way.
  scene.instances.back().T_world_instance = pose_at({2, 1.5, 2.45});
  EXPECT_DOUBLE_EQ(walkable_floor(scene, room, 0.2, {0.5, 0.5}).reachable_share(), 1.0);
}

}  // namespace
}  // namespace scanchor
