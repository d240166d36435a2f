#include "results/plot.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.hpp"
#include "results/paint.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::size_t shapes_with(const VectorPicture& picture, Color stroke, bool closed) {
  std::size_t n = 0;
  for (const auto& item : picture.items) {
    const auto* shape = std::get_if<VectorShape>(&item);
    n += shape != nullptr && shape->closed == closed &&
                 (closed ? shape->fill : shape->stroke) == stroke
             ? 1
             : 0;
  }
  return n;
}

TEST(Plot, ACurveRunsThroughItsPoints) {
  PlotOptions options;
  options.x_high = 10;
  options.y_high = 1;
  const VectorPicture picture =
      plot_lines({{"f1", {0, 5, 10}, {1, 0.5, 0}, {}, {}, true, false}}, options);
  const VectorShape* curve = nullptr;
  for (const auto& item : picture.items) {
    const auto* shape = std::get_if<VectorShape>(&item);
    if (shape != nullptr && shape->paths[0].size() == 3 && !shape->closed) curve = shape;
  }
  ASSERT_NE(curve, nullptr);
  const Path& path = curve->paths[0];
  EXPECT_NEAR(path[1].x(), (path[0].x() + path[2].x()) / 2, 1e-9);
  EXPECT_NEAR(path[1].y(), (path[0].y() + path[2].y()) / 2, 1e-9);
  EXPECT_LT(path[0].y(), path[2].y());
}

TEST(Plot, AGapStaysAGapAndABandIsDrawn) {
  PlotOptions options;
  const VectorPicture picture = plot_lines({{"a",
                                             {0, 1, 2, 3, 4},
                                             {1, 2, nan, 2, 1},
                                             {0, 1, nan, 1, 0},
                                             {2, 3, nan, 3, 2},
                                             false,
                                             false}},
                                           options);
  EXPECT_EQ(shapes_with(picture, palette(0), false), 3u);  // two pieces and the legend's sample
  EXPECT_EQ(shapes_with(picture, with_alpha(palette(0), 46), true), 1u);
}

TEST(Plot, ColumnsMustFit) {
  EXPECT_THROW(plot_lines({{"a", {0, 1}, {1}, {}, {}, true, false}}, {}), Error);
  EXPECT_THROW(plot_map({{0, 1}, {0}, {{1}}, "", 0, 0}, {}), Error);
  EXPECT_THROW(plot_bars({"a"}, {{"s", {1, 2}}}, {}), Error);
  EXPECT_THROW(plot_confusion({"a", "b"}, {{1}}, {}), Error);
}

TEST(Plot, AMapShowsItsExtremesInTheMapsColours) {
  PlotMap map{{1, 2}, {1, 2}, {{0, 0.5}, {nan, 1}}, "F1", 0, 1};
  const Image image = to_image(plot_map(map, {}));
  EXPECT_GT(samples::count(image, color_map(ColorMap::cividis, 0.0)), 5000u);
  EXPECT_GT(samples::count(image, color_map(ColorMap::cividis, 1.0)), 5000u);
}

TEST(Plot, BarsHaveTheHeightOfTheirValues) {
  PlotOptions options;
  options.y_high = 10;
  const VectorPicture picture = plot_bars({"scan", "planes"}, {{"", {5, 10}}}, options);
  std::vector<double> heights;
  for (const auto& item : picture.items) {
    const auto* shape = std::get_if<VectorShape>(&item);
    if (shape != nullptr && shape->fill == palette(0))
      heights.push_back(shape->paths[0][2].y() - shape->paths[0][1].y());
  }
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_NEAR(heights[1], 2 * heights[0], 1e-9);
}

TEST(Plot, ReliabilityAndConfusionAreDrawnFromNothingToo) {
  EXPECT_FALSE(plot_reliability({}, {}).items.empty());
  EXPECT_FALSE(plot_reliability({{0.8, 0.7, 0.6, 0.8, 40}}, {}).items.empty());
  EXPECT_FALSE(plot_confusion({}, {}, {}).items.empty());
  const VectorPicture matrix = plot_confusion({"desk", "chair"}, {{9, 1}, {0, 0}}, {});
  EXPECT_EQ(shapes_with(matrix, mix(paper_white, palette(0), 0.06 + 0.94 * 0.9), true), 1u);
}

}  // namespace
}  // namespace scanchor
