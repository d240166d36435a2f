#include "eval/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

// A made-up method whose recall falls from 1 as 1 - 20 sigma - 0.1 clutter, with scenes that
// differ.
RunResult made_up(const Suite& suite) {
  const double recall = 1.0 - 20.0 * suite.lidar.range_sigma - 0.1 * suite.room.clutter;
  RunResult run;
  const CounterRandom scene(3);
  for (int i = 0; i < 40; ++i) {
    SceneRow row;
    row.index = i;
    row.score.protocol = protocol_stamp(run.protocol);
    row.score.scans = 1;
    row.score.objects.classes.resize(class_list().size());
    auto& desk = row.score.objects.classes[8];
    desk.truths = 1000;
    desk.found = std::llround(
        1000 * std::clamp(recall + 0.02 * scene.normal(static_cast<std::uint64_t>(i)), 0.0, 1.0));
    run.pooled.add(row.score);
    run.rows.push_back(row);
  }
  return run;
}

Suite suite_without_clutter() {
  Suite suite;
  suite.room.clutter = 0.0;
  suite.lidar.range_sigma = 0.01;
  return suite;
}

TEST(Sweep, AxesAreReadAsWritten) {
  EXPECT_EQ(parse_axis("lidar.range_sigma=0..0.05").values.size(), 6U);
  EXPECT_EQ(parse_axis("lidar.range_sigma=0..0.05").values.back(), 0.05);
  EXPECT_NEAR(parse_axis("a=0..1/5").values[1], 0.25, 1e-12);
  EXPECT_EQ(parse_axis("a=0,0.5,2").values, (std::vector<double>{0, 0.5, 2}));
  EXPECT_EQ(parse_axis("a=3").values, (std::vector<double>{3}));
  for (const char* bad : {"a", "=1", "a=", "a=1..", "a=2..1", "a=1,x", "a=0..1/1", "a=0..1/2.5",
                          "a=0..nan", "a=1,,2"}) {
    EXPECT_THROW(parse_axis(bad), Error) << bad;
  }
}

TEST(Sweep, UnknownOptionSaysWhatWasMeant) {
  try {
    with_options(Suite{}, {{"lidar.range_sigmo", 0.1}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("lidar.range_sigma"));
  }
}

TEST(Sweep, AFixedOptionIsNoLongerDrawn) {
  Suite suite;
  suite.vary = {{"lidar.range_sigma", 0.0, 0.1}, {"room.clutter", 0.0, 1.0}};
  const Suite fixed = with_options(suite, {{"lidar.range_sigma", 0.02}});
  EXPECT_EQ(fixed.lidar.range_sigma, 0.02);
  ASSERT_EQ(fixed.vary.size(), 1U);
  EXPECT_EQ(fixed.vary[0].option, "room.clutter");
}

TEST(Sweep, MapHasAllCombinationsLastAxisFastest) {
  SweepOptions options;
  options.metrics = {"objects.recall"};
  options.replicates = 200;
  const auto result =
      sweep(suite_without_clutter(),
            {parse_axis("lidar.range_sigma=0,0.01"), parse_axis("room.clutter=0,0.5,1")}, options,
            made_up);
  ASSERT_EQ(result.points.size(), 6U);
  EXPECT_EQ(result.points[1].values, (std::vector<double>{0, 0.5}));
  EXPECT_EQ(result.points[3].values, (std::vector<double>{0.01, 0}));
  const auto& [name, interval] = result.points[4].intervals[0];
  EXPECT_EQ(name, "objects.recall");
  EXPECT_LE(interval.low, 0.75);
  EXPECT_GE(interval.high, 0.75);
}

TEST(Sweep, BreakingPointIsFoundWithItsInterval) {
  const auto found = breaking_point(suite_without_clutter(), {"lidar.range_sigma", {0.0, 0.05}},
                                    "objects.recall", 0.6, made_up, 1.0 / 64, 500);
  EXPECT_TRUE(found.breaks);
  EXPECT_NEAR(found.value, 0.02, 0.0005);  // 1 - 20 sigma = 0.6; scenes differ by 0.02 / sqrt(40)
  EXPECT_LE(found.interval.low, found.value);
  EXPECT_GE(found.interval.high, found.value);
  EXPECT_LT(found.interval.high - found.interval.low, 0.003);
  EXPECT_LE(found.runs, 9);
}

TEST(Sweep, WhatNeverOrAlwaysBreaksSaysSo) {
  const Axis narrow{"lidar.range_sigma", {0.0, 0.01}};
  EXPECT_FALSE(
      breaking_point(suite_without_clutter(), narrow, "objects.recall", 0.5, made_up, 0.1, 100)
          .breaks);
  const auto always = breaking_point(suite_without_clutter(), {"lidar.range_sigma", {0.03, 0.05}},
                                     "objects.recall", 0.6, made_up, 0.1, 100);
  EXPECT_TRUE(always.from_start);
  EXPECT_EQ(always.value, 0.03);
}

TEST(Sweep, EffectsAreRankedByTheirCost) {
  const auto costs =
      rank_effects(suite_without_clutter(),
                   {parse_axis("room.clutter=0,1"), parse_axis("lidar.range_sigma=0,0.02")},
                   "objects.recall", made_up, 300);
  ASSERT_EQ(costs.size(), 2U);
  EXPECT_EQ(costs[0].option, "lidar.range_sigma");
  EXPECT_NEAR(costs[0].after - costs[0].before, -0.4, 0.02);
  EXPECT_LT(costs[0].change.high, 0.0);
}

}  // namespace
}  // namespace scanchor
