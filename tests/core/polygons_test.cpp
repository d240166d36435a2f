#include "core/polygons.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

Ring2 rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

TEST(Polygons, AreaIsSignedByTheTurn) {
  EXPECT_DOUBLE_EQ(area_of(rectangle(0, 0, 2, 3)), 6.0);
  EXPECT_DOUBLE_EQ(area_of({{0, 0}, {0, 3}, {2, 3}, {2, 0}}), -6.0);
  EXPECT_EQ(area_of({{0, 0}, {1, 1}}), 0.0);
  EXPECT_EQ(area_of({}), 0.0);
}

TEST(Polygons, ClipKeepsTheLeftHalf) {
  Ring2 ring = rectangle(0, 0, 2, 2);
  clip(ring, {0.5, 0}, {0.5, 1});
  EXPECT_DOUBLE_EQ(area_of(ring), 1.0) << "left of the upward line x = 0.5";
  clip(ring, {0.5, 3}, {1, 3});
  EXPECT_DOUBLE_EQ(area_of(ring), 0.0) << "nothing lies above y = 3";
}

TEST(Polygons, DilationByAnOctagonLiesAroundTheCircle) {
  const double r = 0.3;
  const double area = area_of(dilated(rectangle(0, 0, 2, 1), r));
  const double round = 2.0 + r * 6.0 + pi * r * r;
  EXPECT_GT(area, round);
  EXPECT_LT(area, 2.0 + r * 6.0 + 1.06 * pi * r * r);
  EXPECT_EQ(dilated(rectangle(0, 0, 2, 1), 0.0).size(), 4U);
}

// Against counting random points.
TEST(Polygons, OverlapShareAgreesWithSampling) {
  SequentialRandom random(11);
  for (int round = 0; round < 20; ++round) {
    const Ring2 a = rectangle(0, 0, random.uniform(0.5, 2), random.uniform(0.5, 2));
    const double t = random.uniform(0, 3), x = random.uniform(-0.5, 1.5);
    Ring2 b = rectangle(-0.6, -0.4, 0.6, 0.4);
    for (auto& p : b)
      p = {x + std::cos(t) * p.x() - std::sin(t) * p.y(),
           0.7 + std::sin(t) * p.x() + std::cos(t) * p.y()};
    int inside = 0;
    constexpr int samples = 20000;
    for (int i = 0; i < samples; ++i) {
      const Eigen::Vector2d p(random.uniform(0, a[2].x()), random.uniform(0, a[2].y()));
      bool in = true;
      for (std::size_t k = 0; k < 4; ++k) in = in && cross2(b[(k + 1) % 4] - b[k], p - b[k]) >= 0;
      inside += in ? 1 : 0;
    }
    EXPECT_NEAR(overlap_share(a, b), static_cast<double>(inside) / samples, 0.015);
  }
  EXPECT_EQ(overlap_share({}, rectangle(0, 0, 1, 1)), 0.0);
}

TEST(Polygons, HullLeavesOutWhatLiesInsideOrOnEdges) {
  EXPECT_EQ(convex_hull({{0, 0}, {1, 0}, {0.5, 0}, {1, 1}, {0, 1}, {0.4, 0.6}, {1, 1}}).size(), 4U);
  EXPECT_EQ(convex_hull({{0, 0}}).size(), 1U);
  const Ring2 hull = convex_hull({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0.5, 0}});
  EXPECT_EQ(hull.size(), 4U);
  EXPECT_NEAR(area_of(hull), 1.0, 1e-12);
}

}  // namespace
}  // namespace scanchor
