#include "scenes/placer.hpp"

#include <gtest/gtest.h>

#include "scenes/pose.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

class PlacerTest : public ::testing::Test {
 protected:
  PlacerTest() {
    room.high = {5, 4};
    room.height = 2.6;
    options.out_of_square_deg = 0.0;
    add_shell(scene, room);
  }
  Scene scene;
  RoomShell room;
  RoomOptions options;
  SequentialRandom random{1};
};

TEST_F(PlacerTest, BacksGoToTheWall) {
  Placer placer(scene, room, options, random);
  for (const Side side : {Side::south, Side::east, Side::north, Side::west}) {
    const auto index =
        placer.put_at_wall(placer.make("cabinet", "low", {{"width", 1.0}}), side, 0.5, 0.02);
    ASSERT_TRUE(index.has_value());
    const Instance& thing = scene.instances[*index];
    // Seen from the side: turned as the side is, its back 2 cm from the wall, which is y = 0 there.
    const Eigen::Isometry3d T = side_frame(room, side).inverse() * thing.T_world_instance;
    EXPECT_NEAR(T.linear()(1, 1), 1.0, 1e-12);
    double back = -1e9;
    for (const auto& part : thing.parts) {
      for (const auto& v : part.vertices)
        back = std::max(back, (T * (part.T_instance_part * v)).y());
    }
    EXPECT_NEAR(back, -0.02, 1e-9);
  }
}

TEST_F(PlacerTest, NothingIsPutIntoAnotherThingOrOutOfTheRoom) {
  Placer placer(scene, room, options, random);
  const Instance desk = placer.make("desk", "panel legs", {{"width", 1.6}, {"depth", 0.8}});
  ASSERT_TRUE(placer.put(desk, pose_at({2.5, 2, 0})).has_value());
  EXPECT_FALSE(placer.put(desk, pose_at({2.9, 2, 0})).has_value());
  EXPECT_FALSE(placer.put(desk, pose_at({4.5, 2, 0})).has_value());
  EXPECT_FALSE(placer.put(desk, pose_at({2.5, 2.8005, 0})).has_value()) << "nearer than 1 mm";
  EXPECT_TRUE(placer.put(desk, pose_at({2.5, 2.802, 0})).has_value());
}

TEST_F(PlacerTest, KeptFreeZonesStayFree) {
  Placer placer(scene, room, options, random);
  placer.keep_free(pose_at({2.5, 2, 0}), {-0.5, -0.5}, {0.5, 0.5});
  const Instance bin = placer.make("waste bin");
  EXPECT_FALSE(placer.put(bin, pose_at({2.5, 2, 0.003})).has_value());
  EXPECT_TRUE(placer.put(bin, pose_at({2.5, 2, 0.003}), false).has_value());
}

TEST_F(PlacerTest, SurfacesKnowWhatIsAboveThem) {
  Placer placer(scene, room, options, random);
  const auto shelf = placer.put(
      placer.make("shelf", "with sides", {{"boards", 4}, {"spacing", 0.4}}), pose_at({2.5, 2, 0}));
  ASSERT_TRUE(shelf.has_value());
  const auto surfaces = placer.surfaces(*shelf);
  ASSERT_EQ(surfaces.size(), 4U);
  for (std::size_t i = 0; i + 1 < 4; ++i) {
    EXPECT_LT(surfaces[i].center.z(), surfaces[i + 1].center.z());
    EXPECT_GT(surfaces[i].clearance, 0.36);
    EXPECT_LT(surfaces[i].clearance, 0.4);
  }
  EXPECT_DOUBLE_EQ(surfaces[3].clearance, 2.0);
  // What goes on a board lies on it, 3 mm up, within its edges.
  const auto box = placer.put_somewhere_on(
      surfaces[1], placer.make("box", "parcel", {{"width", 0.2}, {"depth", 0.15}, {"height", 0.1}}),
      0.0, 0.1);
  ASSERT_TRUE(box.has_value());
  EXPECT_NEAR(world_bounds(scene.instances[*box]).min().z(), surfaces[1].center.z() + 0.003, 1e-9);
  // What is too tall for the compartment is refused.
  EXPECT_FALSE(
      placer
          .put_somewhere_on(
              surfaces[1],
              placer.make("box", "closed", {{"width", 0.2}, {"depth", 0.15}, {"height", 0.5}}), 0.0,
              0.1)
          .has_value());
}

TEST_F(PlacerTest, ThingsOfOneKindDiffer) {
  Placer placer(scene, room, options, random);
  const Instance a = placer.make("box", "closed");
  const Instance b = placer.make("box", "closed");
  EXPECT_NE(a.parameters.at("height"), b.parameters.at("height"));
}

}  // namespace
}  // namespace scanchor
