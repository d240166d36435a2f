#include "results/plot_frame.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"

namespace scanchor {
namespace {

TEST(PlotFrame, TicksAreRoundAndInside) {
  EXPECT_EQ(plot_ticks(0, 1, 5), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
  for (const auto& [low, high] :
       {std::pair(-3.7, 12.1), std::pair(1e-4, 3e-4), std::pair(900.0, 1e6)}) {
    const auto ticks = plot_ticks(low, high, 6);
    EXPECT_GE(ticks.size(), 3u);
    EXPECT_LE(ticks.size(), 8u);
    EXPECT_GE(ticks.front(), low);
    EXPECT_LE(ticks.back(), high * (1 + 1e-9));
  }
  EXPECT_TRUE(plot_ticks(1, 1, 5).empty());
}

TEST(PlotFrame, RangesOfAnything) {
  double low = 0;
  double high = 0;
  plot_range({}, low, high);
  EXPECT_LT(low, high);
  plot_range({5, 5, std::numeric_limits<double>::quiet_NaN()}, low, high);
  EXPECT_LT(low, 5);
  EXPECT_GT(high, 5);
  plot_range({-2, 7}, low, high);
  EXPECT_EQ(low, -2);
  EXPECT_EQ(high, 7);
}

TEST(PlotFrame, PutsValuesWhereTheyBelong) {
  PlotOptions options;
  options.x_high = 10;
  options.y_high = 1;
  const PlotFrame frame = plot_frame(options, 0);
  EXPECT_DOUBLE_EQ(frame.x(0), frame.left);
  EXPECT_DOUBLE_EQ(frame.x(10), frame.right);
  EXPECT_DOUBLE_EQ(frame.y(0), frame.bottom);
  EXPECT_DOUBLE_EQ(frame.y(1), frame.top);
}

TEST(PlotFrame, LogarithmicAxis) {
  PlotOptions options;
  options.x_log = true;
  options.x_low = 1;
  options.x_high = 100;
  options.y_high = 1;
  const PlotFrame frame = plot_frame(options, 0);
  EXPECT_NEAR(frame.x(10), (frame.left + frame.right) / 2, 1e-9);
  options.x_low = 0;
  EXPECT_THROW(plot_frame(options, 0), Error);
}

TEST(PlotFrame, ShortNumbers) {
  EXPECT_EQ(plot_number(0.30000000000000004), "0.3");
  EXPECT_EQ(plot_number(1e-17), "0");
  EXPECT_EQ(plot_number(1500), "1500");
}

}  // namespace
}  // namespace scanchor
