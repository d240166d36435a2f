#include "results/sweep_plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"

namespace scanchor {
namespace {

SweepResult made_up(const std::string& method, std::size_t axes) {
  SweepResult sweep;
  sweep.method = method;
  sweep.axes.push_back({"lidar.range_sigma", {0.0, 0.02}});
  if (axes == 2) sweep.axes.push_back({"lidar.lines", {50, 100, 200}});
  const std::size_t count = axes == 2 ? 6 : 2;
  for (std::size_t n = 0; n < count; ++n) {
    SweepPoint point;
    point.values = {sweep.axes[0].values[axes == 2 ? n / 3 : n]};
    if (axes == 2) point.values.push_back(sweep.axes[1].values[n % 3]);
    SceneRow row;
    row.score.protocol = protocol_stamp(point.run.protocol);
    row.score.objects.classes.resize(class_list().size());
    row.score.objects.classes[8] = {100, static_cast<std::int64_t>(90 - 10 * n), 0, 0};
    point.run.pooled = row.score;
    point.run.rows.push_back(row);
    point.intervals.emplace_back("objects.f1", Interval{0.1, 0.95});
    sweep.points.push_back(point);
  }
  return sweep;
}

TEST(SweepPlots, CurvesNameMetricAndAxis) {
  const std::string svg = to_svg(sweep_plot(made_up("default/default/office", 1)));
  EXPECT_THAT(svg, testing::HasSubstr("Scores over lidar.range_sigma"));
}

TEST(SweepPlots, MethodsAreNamedShort) {
  const std::string svg = to_svg(methods_plot(
      {made_up("default/default/office", 1), made_up("paper/paper/office", 1)}, "objects.f1"));
  EXPECT_THAT(svg, testing::HasSubstr(">default<"));
  EXPECT_THAT(svg, testing::HasSubstr(">paper<"));
}

TEST(SweepPlots, TimesAreThoseOfOneScan) {
  SweepResult sweep = made_up("default/default/office", 1);
  for (auto& point : sweep.points) {
    point.run.pooled.scans = 4;
    point.run.times.perceive = 0.8;
  }
  const std::string svg = to_svg(times_plot({sweep}));
  EXPECT_THAT(svg, testing::HasSubstr("ms a scan"));
  EXPECT_THAT(svg, testing::HasSubstr(">200<")) << "the axis ends where the curve does";
  EXPECT_THAT(svg, testing::HasSubstr(">reasoning<"));
  EXPECT_THROW(times_plot({made_up("default", 2)}), Error);
}

TEST(SweepPlots, AMapShowsTheValueOfEachCell) {
  // F1 = 2 found / (found + 100): 0.95 for the first cell, 0.57 for the last.
  const std::string svg = to_svg(sweep_map(made_up("default", 2), "objects.f1"));
  EXPECT_THAT(svg, testing::HasSubstr(">0.95<"));
  EXPECT_THAT(svg, testing::HasSubstr(">0.57<"));
}

TEST(SweepPlots, AnotherNumberOfAxesIsRefused) {
  EXPECT_THROW(sweep_map(made_up("default", 1), "objects.f1"), Error);
  EXPECT_THROW(sweep_plot(made_up("default", 2)), Error);
}

TEST(SweepPlots, FilesFollowTheAxes) {
  const auto folder = std::filesystem::temp_directory_path() / "scanchor-sweep-plots";
  std::filesystem::remove_all(folder);
  EXPECT_EQ(write_sweep_plots(folder, {made_up("default", 1)}, {"objects.f1"}).size(), 2U);
  EXPECT_EQ(write_sweep_plots(folder, {made_up("default", 1), made_up("paper", 1)}, {"objects.f1"})
                .size(),
            3U);
  const auto maps = write_sweep_plots(folder, {made_up("paper/paper/office", 2)}, {"objects.f1"});
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_EQ(maps.front().filename(), "map-paper.svg");
  std::filesystem::remove_all(folder);
}

TEST(SweepPlots, TheRankingShowsLossesInPoints) {
  EffectCost cost;
  cost.option = "lidar.loss";
  cost.from = 0;
  cost.to = 0.3;
  cost.before = 0.8;
  cost.after = 0.7;
  EXPECT_THAT(to_svg(ranking_plot({cost}, "objects.f1")),
              testing::HasSubstr("lidar.loss 0 to 0.3"));
}

}  // namespace
}  // namespace scanchor
