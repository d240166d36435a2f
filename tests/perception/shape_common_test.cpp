#include "perception/shape_common.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

TEST(MinimumAreaRectangle, FindsATurnedBox) {
  SequentialRandom random(3);
  for (int round = 0; round < 50; ++round) {
    const double angle = random.uniform(-1.5, 1.5);
    const double length = random.uniform(0.5, 3.0);
    const double width = random.uniform(0.1, 0.95) * length;
    const Eigen::Vector2d center(random.normal(), random.normal());
    const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d v(-u.y(), u.x());
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 100; ++i)
      points.emplace_back(center + random.uniform(-0.5, 0.5) * length * u +
                          random.uniform(-0.5, 0.5) * width * v);
    for (const int i : {-1, 1}) {
      for (const int j : {-1, 1})
        points.emplace_back(center + 0.5 * i * length * u + 0.5 * j * width * v);
    }
    const FittedRectangle r = minimum_area_rectangle(points);
    EXPECT_NEAR(r.length.value, length, 1e-9);
    EXPECT_NEAR(r.width.value, width, 1e-9);
    EXPECT_NEAR(std::remainder(r.angle - angle, pi), 0.0, 1e-9);
    EXPECT_NEAR((r.center - center).norm(), 0.0, 1e-9);
    EXPECT_GE(r.angle, -0.5 * pi);
    EXPECT_LT(r.angle, 0.5 * pi);
  }
}

TEST(MinimumAreaRectangle, PointsOnALineHaveNoWidth) {
  const FittedRectangle r = minimum_area_rectangle({{0, 0}, {1, 1}, {3, 3}, {2, 2}});
  EXPECT_NEAR(r.length.value, std::sqrt(18.0), 1e-12);
  EXPECT_NEAR(r.width.value, 0.0, 1e-12);
  EXPECT_EQ(minimum_area_rectangle({}).length.value, 0.0);
  EXPECT_EQ(minimum_area_rectangle({{1, 2}, {1, 2}}).length.value, 0.0);
}

TEST(Eccentricity, OfCircleLineAndEllipse) {
  std::vector<Eigen::Vector2d> circle;
  std::vector<Eigen::Vector2d> ellipse;
  for (int i = 0; i < 360; ++i) {
    circle.emplace_back(std::cos(radians(i)), std::sin(radians(i)));
    ellipse.emplace_back(5.0 * std::cos(radians(i)), 3.0 * std::sin(radians(i)));
  }
  EXPECT_NEAR(ellipse_eccentricity(circle), 0.0, 1e-6);
  EXPECT_NEAR(ellipse_eccentricity(ellipse), 0.8, 1e-12);  // sqrt(1 - 9 / 25)
  const double line = ellipse_eccentricity({{0, 0}, {1, 0}, {2, 0}});
  EXPECT_GT(line, 0.999999);
  EXPECT_LT(line, 1.0);
  EXPECT_EQ(ellipse_eccentricity({}), 0.0);
}

TEST(Flatten, SortsByPlaceAndKeepsIndices) {
  PointCloud cloud;
  cloud.points = {{3, 0, 5}, {1, 0, 5}, {2, 0, 5}};
  Surface surface;
  surface.inliers = {0, 1, 2};
  surface.T_cloud_surface.translation() = Eigen::Vector3d(0, 0, 5);
  const FlatPoints flat = flatten(cloud, surface);
  EXPECT_EQ(flat.order, (std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_EQ(flat.points[2], Eigen::Vector2d(3, 0));
}

}  // namespace
}  // namespace scanchor
