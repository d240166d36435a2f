#include "scenes/shell.hpp"

#include <gtest/gtest.h>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

TEST(Shell, TruthFacesAreTheWholeRectangles) {
  Scene scene;
  add_plain_room(scene, {6, 5, 2.8});
  ASSERT_EQ(scene.instances.size(), 6U);
  const Face* floor = testing::find_face(scene.instances[0].parts[0], "top");
  EXPECT_NEAR(floor->area, 30.0, 1e-12);
  EXPECT_NEAR(floor->center.z(), 0.0, 1e-12);
  const Face* ceiling = testing::find_face(scene.instances[1].parts[0], "bottom");
  EXPECT_NEAR(ceiling->center.z(), 2.8, 1e-12);
  testing::expect_no_close_faces(scene, "shell");
  for (int i = 2; i < 6; ++i) {
    const WorldFace wall = world_face(scene, {i, 0, 0});
    // Every wall looks at the middle of the room.
    EXPECT_GT(wall.normal.dot(Eigen::Vector3d(3, 2.5, 1.4) - wall.center), 1.0);
    EXPECT_NEAR(wall.size.y(), 2.8, 1e-12);
  }
}

TEST(Shell, SideFramesLookOutwards) {
  RoomShell room;
  room.low = {1, 2};
  room.high = {5, 9};
  for (const Side side : {Side::south, Side::east, Side::north, Side::west}) {
    const Eigen::Isometry3d frame = side_frame(room, side);
    EXPECT_NEAR(frame.linear().determinant(), 1.0, 1e-12);
    const Eigen::Vector3d inside = frame * Eigen::Vector3d(0.5 * side_length(room, side), -0.1, 0);
    EXPECT_GT(inside.x(), 1.0);
    EXPECT_LT(inside.x(), 5.0);
    EXPECT_GT(inside.y(), 2.0);
    EXPECT_LT(inside.y(), 9.0);
  }
}

TEST(Shell, OpeningsAreTakenOffTheWallAndDoorsGetThresholds) {
  Scene scene;
  RoomShell room;
  room.openings.push_back({Side::east, {{1.0, 0.0}, {1.9, 2.0}, 0.12}});
  room.openings.push_back({Side::east, {{2.5, 0.9}, {3.5, 2.1}, 0.24}});
  room.openings.push_back({Side::north, {{1.0, 0.0}, {1.9, 2.0}, 0.0}});
  add_shell(scene, room);
  const WorldFace east = world_face(scene, {3, 0, 0});
  EXPECT_NEAR(east.area, 4.0 * 2.6 - 0.9 * 2.0 - 1.2, 1e-9);
  EXPECT_NEAR(east.size.prod(), 4.0 * 2.6, 1e-9);
  ASSERT_EQ(scene.instances[0].parts.size(), 2U)
      << "the opening without depth belongs to somebody else";
  EXPECT_EQ(scene.instances[4].parts[0].faces.size(), 1U);
  testing::expect_no_close_faces(scene, "shell with openings");
}

TEST(Shell, IdsContinue) {
  Scene scene;
  add_plain_room(scene, {2, 2, 2});
  add_plain_room(scene, {2, 2, 2});
  EXPECT_EQ(scene.instances.back().id, 12);
  EXPECT_EQ(next_id(scene), 13);
}

}  // namespace
}  // namespace scanchor
