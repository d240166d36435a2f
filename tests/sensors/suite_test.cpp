#include "sensors/suite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/error.hpp"

namespace scanchor {
namespace {

Suite suite_of(int scenes) {
  Suite suite;
  suite.scenes = scenes;
  return suite;
}

TEST(Suite, TasksHaveNamesAsSemanticKittiSpellsThem) {
  const auto tasks = scene_tasks(suite_of(101));
  EXPECT_EQ(tasks[0].name, "00");
  EXPECT_EQ(tasks[9].name, "09");
  EXPECT_EQ(tasks[100].name, "100");
}

TEST(Suite, ALongerSuiteBeginsWithTheShorterOne) {
  Suite suite = suite_of(17);
  suite.families = {{"office", 2.5}, {"b", 1.0}, {"c", 0.3}};
  suite.vary = {{"room.clutter", 0.1, 0.9}};
  const auto few = scene_tasks(suite);
  suite.scenes = 60;
  const auto many = scene_tasks(suite);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].seed, many[i].seed);
    EXPECT_EQ(few[i].room.family, many[i].room.family);
    EXPECT_EQ(few[i].split, many[i].split);
    EXPECT_EQ(few[i].room.clutter, many[i].room.clutter);
  }
}

TEST(Suite, EveryPrefixHoldsTheMixWithinOne) {
  Suite suite = suite_of(400);
  suite.families = {{"a", 5.0}, {"b", 3.0}, {"none", 0.0}, {"c", 2.0}};
  std::map<std::string, int> families;
  std::map<std::string, std::map<std::string, int>> splits;
  int n = 0;
  for (const auto& task : scene_tasks(suite)) {
    ++n;
    ++families[task.room.family];
    ++splits[task.room.family][task.split];
    EXPECT_LE(std::abs(families["a"] - 0.5 * n), 1.0);
    EXPECT_LE(std::abs(families["c"] - 0.2 * n), 1.0);
    const int own = families[task.room.family];
    EXPECT_LE(std::abs(splits[task.room.family]["train"] - 0.7 * own), 1.0)
        << "each family has its own parts";
  }
  EXPECT_EQ(families["none"], 0);
}

TEST(Suite, EachSceneHasItsOwnSeed) {
  std::set<std::uint64_t> seeds;
  Suite suite = suite_of(300);
  for (suite.seed = 1; suite.seed <= 3; ++suite.seed) {
    for (const auto& task : scene_tasks(suite)) seeds.insert(task.seed);
  }
  EXPECT_EQ(seeds.size(), 900U);
}

TEST(Suite, VariationsAreUniformAndWithinTheirBounds) {
  Suite suite = suite_of(2000);
  suite.vary = {{"room.clutter", 0.2, 0.6}, {"lidar.lines", 10, 12}};
  double sum = 0.0;
  std::map<int, int> lines;
  for (const auto& task : scene_tasks(suite)) {
    EXPECT_GE(task.room.clutter, 0.2);
    EXPECT_LE(task.room.clutter, 0.6);
    sum += task.room.clutter;
    ++lines[task.lidar.lines];
  }
  EXPECT_NEAR(sum / 2000, 0.4, 3.3 * 0.4 / std::sqrt(12.0 * 2000));
  EXPECT_EQ(lines.size(), 3U);
}

TEST(Suite, OptionsAreSetFromText) {
  Suite suite;
  set_suite_option(suite, "seed", "9");
  set_suite_option(suite, "scenes", "3");
  set_suite_option(suite, "lidar.preset", "utm-30lx");
  set_suite_option(suite, "lidar.lines", "77");
  set_suite_option(suite, "room.family", room_families().back());
  EXPECT_EQ(suite.seed, 9U);
  EXPECT_EQ(suite.lidar.beams_per_line, lidar_preset("utm-30lx").beams_per_line);
  EXPECT_EQ(suite.lidar.lines, 77);
  ASSERT_EQ(scene_tasks(suite).size(), 3U);
  EXPECT_EQ(scene_tasks(suite)[2].room.family, room_families().back());
  EXPECT_THROW(set_suite_option(suite, "lidar.lnes", "7"), Error);
  EXPECT_THROW(set_suite_option(suite, "scenes", "0"), Error);
}

TEST(Suite, NoFamilyIsAnError) {
  Suite suite = suite_of(1);
  suite.families = {{"office", 0.0}};
  EXPECT_THROW((void)scene_tasks(suite), Error);
}

TEST(Suite, ShardsCoverEachSceneOnce) {
  for (int scene = 0; scene < 20; ++scene) {
    int owners = 0;
    for (int i = 1; i <= 3; ++i) owners += parse_shard(std::to_string(i) + "/3").has(scene) ? 1 : 0;
    EXPECT_EQ(owners, 1);
  }
  for (const char* bad : {"", "1", "0/3", "4/3", "1/0", "a/3", "1/3x", "-1/3", "1/"}) {
    EXPECT_THROW((void)parse_shard(bad), Error) << bad;
  }
}

}  // namespace
}  // namespace scanchor
