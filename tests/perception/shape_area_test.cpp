#include "perception/shape_area.hpp"

#include <gtest/gtest.h>

#include "core/math.hpp"

namespace scanchor {
namespace {

Ring turned(const Ring& ring, double angle) {
  Ring result;
  const Eigen::Vector2d u = unit_vector(angle);
  for (const auto& p : ring)
    result.emplace_back(2.0 + u.x() * p.x() - u.y() * p.y(), 1.0 + u.y() * p.x() + u.x() * p.y());
  return result;
}

TEST(ShapeArea, AnEdgeThatWaversIsKnownBetter) {
  const Polygon square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, {}};
  const auto half_width = [&](double waver) {
    const Measured area =
        polygon_area({square}, {{{0, 0}, {1, 0}, EdgeKind::true_edge, 0.06, waver}});
    EXPECT_DOUBLE_EQ(area.value, 1.0);
    EXPECT_NEAR(area.high - area.value, area.value - area.low, 1e-12);
    return area.high - area.value;
  };
  EXPECT_NEAR(half_width(0.0), 1.96 * 0.06 / std::sqrt(12.0), 1e-4);
  EXPECT_LT(half_width(0.02), 0.4 * half_width(0.0));
}

TEST(ShapeArea, CountsWhatSticksOutOfARectangle) {
  // 4 x 2 with a tab of 0.5 x 1 beyond its right end and one of 1 x 0.25 above, a hole across the
  // right end of 0.2 x 0.5, half of it outside.
  for (const double angle : {0.0, 0.4, -1.2}) {
    const Polygon tabs{turned({{-2, -1},
                               {2, -1},
                               {2, -0.5},
                               {2.5, -0.5},
                               {2.5, 0.5},
                               {2, 0.5},
                               {2, 1},
                               {1, 1},
                               {1, 1.25},
                               {0, 1.25},
                               {0, 1},
                               {-2, 1}},
                              angle),
                       {turned({{1.9, -0.25}, {1.9, 0.25}, {2.1, 0.25}, {2.1, -0.25}}, angle)},
                       {}};
    FittedRectangle rectangle;
    rectangle.center = {2.0, 1.0};
    rectangle.angle = angle;
    rectangle.length.value = 4.0;
    rectangle.width.value = 2.0;
    EXPECT_NEAR(area_outside({tabs}, rectangle, true, false), 0.45, 1e-9);
    EXPECT_NEAR(area_outside({tabs}, rectangle, false, true), 0.25, 1e-9);
    EXPECT_NEAR(area_outside({tabs}, rectangle, true, true), 0.7, 1e-9);
    EXPECT_EQ(area_outside({tabs}, rectangle, false, false), 0.0);
    // A piece that lies apart is outside altogether.
    const Polygon apart{turned({{3, 0}, {3.5, 0}, {3.5, 0.5}, {3, 0.5}}, angle), {}, {}};
    EXPECT_NEAR(area_outside({tabs, apart}, rectangle, true, true), 0.95, 1e-9);
  }
}

TEST(ShapeArea, WhatIsDoubtfulStaysInTheUpperEnd) {
  Measured area{1.0, 0.9, 1.1, false};
  take_off(0.2, area);
  EXPECT_DOUBLE_EQ(area.value, 0.8);
  EXPECT_DOUBLE_EQ(area.low, 0.7);
  EXPECT_DOUBLE_EQ(area.high, 1.1);
  take_off(5.0, area);
  EXPECT_EQ(area.value, 0.0);
  EXPECT_EQ(area.low, 0.0);
}

}  // namespace
}  // namespace scanchor
