#include "sensors/made_room.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

SceneTask task_of(const std::string& family, std::uint64_t seed) {
  SceneTask task;
  task.name = "07";
  task.seed = seed;
  task.room.family = family;
  return task;
}

TEST(MadeRoom, IsTheGeneratorsRoomAtRest) {
  const SceneTask task = task_of("office", 60);
  RoomTimes times;
  const MadeRoom room = make_room(task, &times);
  EXPECT_TRUE(room.complete);
  EXPECT_TRUE(room.settled);
  EXPECT_TRUE(room.problems.empty());
  Scene own = furnish_room(task.room, task.seed, room.tries - 1).scene;
  EXPECT_TRUE(settle(own, task.settle).settled);
  EXPECT_EQ(scene_to_json(room.scene), scene_to_json(own));
  EXPECT_GT(times.generate, 0.0);
  EXPECT_GT(times.settle, 0.0);
}

TEST(MadeRoom, WhatDoesNotComeToRestIsMadeAnewAndCounted) {
  SceneTask task = task_of("office", 61);
  const int first = make_room(task).tries;
  task.settle.maximum_time = 0.1;  // no room is at rest so soon
  const MadeRoom room = make_room(task);
  EXPECT_FALSE(room.settled);
  EXPECT_FALSE(room.problems.empty());
  EXPECT_GE(room.tries, first + 4) << "five rooms were tried";
}

TEST(MadeRoom, WhatCannotBeFurnishedSaysSo) {
  // Half the sides of a meeting room hold no table with chairs around.
  SceneTask task = task_of("meeting room", 60);
  task.room.size_scale = 0.5;
  task.room.clutter = 1.0;
  int incomplete = 0;
  for (std::uint64_t seed = 60; seed < 64; ++seed) {
    task.seed = seed;
    try {
      const MadeRoom room = make_room(task);
      if (room.complete) continue;
      ++incomplete;
      ASSERT_FALSE(room.problems.empty());
      EXPECT_NE(room.problems.back().find("essential"), std::string::npos);
      EXPECT_GE(room.tries, most_tries);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("scene 07"), std::string::npos);
      ++incomplete;
    }
  }
  EXPECT_GE(incomplete, 2);
}

TEST(MadeRoom, ScansTakeThePosesInTurnAndSeedsOfTheirOwn) {
  Scene scene;
  for (int i = 0; i < 2; ++i) {
    scene.sensor_poses.push_back(Eigen::Isometry3d::Identity());
    scene.sensor_poses.back().translation().x() = i;
  }
  EXPECT_EQ(scan_pose(scene, 0).translation().x(), 0.0);
  EXPECT_EQ(scan_pose(scene, 1).translation().x(), 1.0);
  EXPECT_EQ(scan_pose(scene, 2).translation().x(), 0.0);
  const SceneTask task = task_of("office", 5);
  EXPECT_EQ(scan_seed(task, 2), stream_seed(5, "scan", 2));
  EXPECT_NE(scan_seed(task, 0), scan_seed(task, 1));
}

}  // namespace
}  // namespace scanchor
