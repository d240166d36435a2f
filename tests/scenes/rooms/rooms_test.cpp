#include "scenes/rooms/rooms.hpp"

#include <gtest/gtest.h>

#include "scenes/pose.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

TEST(Rooms, DoorsFillTheirOpenings) {
  for (const Side side : {Side::south, Side::east, Side::north, Side::west}) {
    for (const bool outwards : {false, true}) {
      Scene scene;
      SequentialRandom random(3);
      RoomPlan plan = plan_room(random, {}, {4, 3}, {5, 4}, 2.5, 2.8);
      add_door(scene, plan, random, side, 1.5, "open", outwards);
      build_plan(scene, plan);
      const Instance& door = scene.instances.back();
      ASSERT_EQ(door.kind, "door");
      testing::expect_no_close_faces(scene, "room with a door");
      // The leaf stands in the room, or outside.
      const Eigen::AlignedBox3d bounds = world_bounds(door);
      const Eigen::Vector3d inside = plan.door_frames[0] * Eigen::Vector3d(0, -0.5, 1.0);
      EXPECT_EQ(bounds.exteriorDistance(inside) < 0.45, !outwards) << static_cast<int>(side);
    }
  }
}

TEST(Rooms, SidesTurnWithTheDoor) {
  RoomPlan plan;
  EXPECT_EQ(plan.turned(Side::north), Side::north);
  plan.door_side = Side::north;
  EXPECT_EQ(plan.turned(Side::north), Side::south);
  EXPECT_EQ(plan.turned(Side::east), Side::west);
  plan.door_side = Side::east;
  EXPECT_EQ(plan.turned(Side::south), Side::east);
}

TEST(Rooms, WindowsKeepClearOfEachOther) {
  Scene scene;
  SequentialRandom random(8);
  RoomPlan plan = plan_room(random, {}, {6, 4}, {7, 5}, 2.6, 2.8);
  add_windows(scene, plan, random, Side::north, 9);
  ASSERT_GE(plan.shell.openings.size(), 2U);
  for (std::size_t i = 1; i < plan.shell.openings.size(); ++i) {
    EXPECT_GT(plan.shell.openings[i].opening.low.x(),
              plan.shell.openings[i - 1].opening.high.x() + 0.1);
  }
  build_plan(scene, plan);
  testing::expect_no_close_faces(scene, "room with windows");
}

TEST(Rooms, ChairsFaceTheirTable) {
  Scene scene;
  SequentialRandom random(2);
  RoomPlan plan = plan_room(random, {}, {6, 5}, {6, 5}, 2.6, 2.8);
  add_door(scene, plan, random, Side::south, 1.0);
  build_plan(scene, plan);
  Placer placer(scene, plan.shell, {}, random);
  const auto table = placer.put(placer.make("table", "four legs", {{"width", 1.6}, {"depth", 0.9}}),
                                pose_at({3, 2.5, 0}, 0.4));
  ASSERT_TRUE(table.has_value());
  for (int side = 0; side < 4; ++side) {
    const auto chair = chair_at(placer, *table, side, 0.0, "four legs");
    ASSERT_TRUE(chair.has_value()) << side;
    const Eigen::Isometry3d& pose = scene.instances[*chair].T_world_instance;
    const Eigen::Vector3d to =
        scene.instances[*table].T_world_instance.translation() - pose.translation();
    // The sitter looks along -y of the chair.
    EXPECT_GT((-pose.linear().col(1)).dot(to.normalized()), 0.8) << side;
  }
}

TEST(Rooms, ABlockedDoorIsNotWalkable) {
  Scene scene;
  SequentialRandom random(2);
  RoomPlan plan = plan_room(random, {}, {5, 4}, {5, 4}, 2.6, 2.8);
  add_door(scene, plan, random, Side::south, 2.5, "closed");
  build_plan(scene, plan);
  Placer placer(scene, plan.shell, {}, random);
  EXPECT_TRUE(walkable(placer, plan));
  const auto& entrance = plan.entrances.front();
  placer.put(placer.make("pallet", "euro"), pose_at({entrance.x(), entrance.y() + 0.1, 0}), false);
  EXPECT_FALSE(walkable(placer, plan));
}

}  // namespace
}  // namespace scanchor
