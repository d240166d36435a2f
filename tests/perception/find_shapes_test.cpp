#include <gtest/gtest.h>

#include <numeric>

#include "core/json.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "perception/perceive.hpp"
#include "perception/polygon_check.hpp"
#include "tests/perception/support/shape_scene.hpp"

namespace scanchor {
namespace {

using testing::box_panel;
using testing::ShapeScan;

ShapeScan room(double sigma, std::uint64_t seed = 1) {
  testing::ScannerSetup setup;
  setup.position = {0.9, 2.3, 1.4};
  setup.beams = 250;
  setup.lines = 100;
  setup.range_sigma = sigma;
  setup.jitter = 0.2;
  setup.seed = seed;
  return testing::scan_panels({box_panel({3, 2.5, 0}, {1, 0, 0}, {0, 1, 0}, 6, 5),
                               box_panel({6, 2.5, 1.4}, {0, 1, 0}, {0, 0, 1}, 5, 2.8),
                               box_panel({3, 0, 1.4}, {1, 0, 0}, {0, 0, 1}, 6, 2.8),
                               box_panel({3, 5, 1.4}, {1, 0, 0}, {0, 0, 1}, 6, 2.8),
                               box_panel({3.5, 2.6, 0.75}, {0, 1, 0}, {1, 0, 0}, 1.6, 0.8),
                               box_panel({3.6, 2.25, 1.02}, {0.12, 0.99, 0}, {0, 0, 1}, 0.57, 0.42),
                               box_panel({2.2, 1.0, 0.5}, {1, 0.4, 0}, {-0.4, 1, 0}, 0.5, 0.4)},
                              setup);
}

std::string shapes_of(ShapeScan scan, const std::string& method, bool sensor = true) {
  PerceiveOptions options;
  options.method = method;
  if (!sensor) scan.surfaces.sensor_positions.clear();
  find_shapes(scan.cloud, options, scan.surfaces);
  return surfaces_to_json(scan.surfaces, false).dump();
}

TEST(FindShapes, OneThreadOrTwoTheSameBytes) {
  for (const std::string method : {"default", "paper"}) {
    std::string one;
    std::string two;
    {
      const ThreadLimit limit(1);
      one = shapes_of(room(0.01), method);
    }
    {
      const ThreadLimit limit(2);
      two = shapes_of(room(0.01), method);
    }
    EXPECT_EQ(one, two);
    EXPECT_GT(one.size(), 5000U);
  }
}

TEST(FindShapes, AnyOrderOfThePointsTheSameBytes) {
  for (const double sigma : {0.0, 0.01}) {
    const ShapeScan scan = room(sigma);
    SequentialRandom random(3);
    std::vector<std::uint32_t> order(scan.cloud.size());
    std::iota(order.begin(), order.end(), 0U);
    const ShapeScan same = testing::permuted(scan, order);
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    const ShapeScan other = testing::permuted(scan, order);
    for (const std::string method : {"default", "paper"})
      EXPECT_EQ(shapes_of(same, method), shapes_of(other, method));
    EXPECT_EQ(shapes_of(same, "default", false), shapes_of(other, "default", false));
  }
}

TEST(FindShapes, EverySurfaceIsValidAndInRange) {
  for (const bool sensor : {true, false}) {
    for (const double sigma : {0.0, 0.02}) {
      ShapeScan scan = room(sigma, 5);
      if (!sensor) scan.surfaces.sensor_positions.clear();
      find_shapes(scan.cloud, {}, scan.surfaces);
      for (const Surface& s : scan.surfaces.surfaces) {
        EXPECT_EQ(s.inlier_count, s.inliers.size());
        ASSERT_FALSE(s.polygons.empty());
        double area = 0.0;
        for (const Polygon& polygon : s.polygons) {
          EXPECT_TRUE(is_valid(polygon));
          EXPECT_EQ(polygon.outer.size(), polygon.outer_kind.size());
          area += polygon.area();
        }
        EXPECT_NEAR(area, s.area.value, 1e-9 + 1e-9 * area);
        EXPECT_LE(s.area.low, s.area.value);
        EXPECT_LE(s.area.value, s.area.high);
        EXPECT_GE(s.rectangle.length.value, s.rectangle.width.value);
        EXPECT_GE(s.rectangularness, 0.0);
        EXPECT_LE(s.rectangularness, 1.0);
        EXPECT_GE(s.occluded_outline, 0.0);
        EXPECT_LE(s.occluded_outline, 1.0);
        EXPECT_GE(s.eccentricity, 0.0);
        EXPECT_LT(s.eccentricity, 1.0);
      }
    }
  }
}

TEST(FindShapes, MovingEverythingChangesNothingButTheFrame) {
  ShapeScan scan = room(0.01);
  ShapeScan moved = scan;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  T.translation() = Eigen::Vector3d(4, -7, 2);
  for (auto& p : moved.cloud.points) p = T * p;
  for (auto& p : moved.surfaces.sensor_positions) p = T * p;
  for (Surface& s : moved.surfaces.surfaces) {
    s.T_cloud_surface = T * s.T_cloud_surface;
    s.plane.normal = T.linear() * s.plane.normal;
    s.plane.centroid = T * s.plane.centroid;
    s.plane.offset = s.plane.normal.dot(s.plane.centroid);
    s.plane.normal_covariance = T.linear() * s.plane.normal_covariance * T.linear().transpose();
  }
  find_shapes(scan.cloud, {}, scan.surfaces);
  find_shapes(moved.cloud, {}, moved.surfaces);
  for (std::size_t i = 0; i < scan.surfaces.surfaces.size(); ++i) {
    const Surface& a = scan.surfaces.surfaces[i];
    const Surface& b = moved.surfaces.surfaces[i];
    // The cells of the view turn with the world's axes, so which samples are thinned changes; the
    // edges do not.
    EXPECT_NEAR(a.area.value, b.area.value, 0.01 * a.area.value + 1e-4);
    EXPECT_NEAR(a.rectangle.length.value, b.rectangle.length.value,
                0.01 * a.rectangle.length.value);
    EXPECT_EQ(a.is_rectangle, b.is_rectangle);
  }
}

TEST(FindShapes, FewPointsLinesAndDuplicatesAreSurvived) {
  for (const auto& points :
       std::vector<std::vector<Eigen::Vector2d>>{{{0, 0}},
                                                 {{0, 0}, {1, 0}},
                                                 {{0, 0}, {1, 0}, {0, 1}},
                                                 {{0, 0}, {1, 1}, {2, 2}, {3, 3}},
                                                 std::vector<Eigen::Vector2d>(2000, {1.0, 2.0})}) {
    for (const std::string method : {"default", "paper"}) {
      ShapeScan scan = testing::flat_scan(points);
      if (scan.surfaces.surfaces.empty()) continue;
      scan.surfaces.surfaces.front().T_cloud_surface.linear().setIdentity();
      PerceiveOptions options;
      options.method = method;
      find_shapes(scan.cloud, options, scan.surfaces);
      const Surface& s = scan.surfaces.surfaces.front();
      EXPECT_TRUE(std::isfinite(s.area.value));
      EXPECT_TRUE(std::isfinite(s.rectangle.length.value));
      for (const Polygon& polygon : s.polygons) EXPECT_TRUE(is_valid(polygon));
    }
  }
  Surfaces none;
  find_shapes({}, {}, none);
  EXPECT_TRUE(none.surfaces.empty());
}

}  // namespace
}  // namespace scanchor
