#include <gtest/gtest.h>

#include <cmath>
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
        // What sticks out of a rectangle or stands apart is taken off, but stays in the upper end.
        EXPECT_LE(s.area.value, area + 1e-9 * area);
        EXPECT_GE(s.area.value, 0.8 * area);
        EXPECT_GE(s.area.high, area - 1e-9 * area);
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

/// What no surface may be, whatever its points.
void expect_sane(const Surface& s, const PointCloud& cloud) {
  for (const Measured& m : {s.rectangle.length, s.rectangle.width, s.area}) {
    EXPECT_TRUE(std::isfinite(m.low) && std::isfinite(m.high));
    EXPECT_GE(m.value, 0.0);
    EXPECT_LE(m.low, m.value + 1e-9);
    EXPECT_LE(m.value, m.high + 1e-9);
  }
  EXPECT_GE(s.rectangularness, 0.0);
  EXPECT_LE(s.rectangularness, 1.0);
  EXPECT_GE(s.eccentricity, 0.0);
  EXPECT_LT(s.eccentricity, 1.0);
  Eigen::AlignedBox3d box;
  for (const std::uint32_t i : s.inliers) box.extend(cloud.points[i]);
  EXPECT_LE(s.rectangle.length.value, 2.0 * box.diagonal().norm() + 0.5);
  for (const Polygon& polygon : s.polygons) EXPECT_TRUE(is_valid(polygon));
}

TEST(FindShapes, NothingAbsurdComesOutOfAnything) {
  // Up to eight things called planes, of 1 to 600 points: patches from a millimetre to metres,
  // lines, single places, lattices without noise, rings, patches with half of the points in one
  // place, domes, frames, clouds; also far from the origin, also with points at the scanner itself.
  enum Kind { patch, line, place, lattice, ring, heap, dome, frame, cloud, kinds };
  for (std::uint64_t round = 0; round < 150; ++round) {
    SequentialRandom random(stream_seed(5, "anything", round));
    const Eigen::Vector3d sensor =
        random.chance(0.3) ? Eigen::Vector3d(5e5, 5.5e6, 300) : Eigen::Vector3d(0, 0, 0);
    const double sigma = random.chance(0.3) ? 0.0 : random.uniform(0.001, 0.05);
    PointCloud points;
    std::vector<int> label;
    const int things = 1 + static_cast<int>(random.below(8));
    for (int thing = 0; thing < things; ++thing) {
      const Eigen::Vector3d center =
          sensor +
          Eigen::Vector3d(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-2, 2));
      const Eigen::Matrix3d turn =
          (Eigen::AngleAxisd(random.uniform(0, 6.3), Eigen::Vector3d::UnitZ()) *
           Eigen::AngleAxisd(random.uniform(0, 3.2), Eigen::Vector3d::UnitX()))
              .toRotationMatrix();
      const auto kind = static_cast<Kind>(random.below(kinds));
      const int count = 1 + static_cast<int>(random.below(random.chance(0.3) ? 5 : 600));
      const double a = std::pow(10.0, random.uniform(-3, 0.7));
      const double b = std::pow(10.0, random.uniform(-3, 0.7));
      for (int i = 0; i < count; ++i) {
        double x = a * random.uniform(-1, 1);
        double y = b * random.uniform(-1, 1);
        double z = sigma * random.normal();
        if (kind == line) y = 0;
        if (kind == place || (kind == heap && i % 2 == 1)) x = y = z = 0;
        if (kind == lattice) x = std::floor(20 * x) / 20, y = std::floor(20 * y) / 20, z = 0;
        if (kind == ring) {
          const double angle = random.uniform(0, 6.3);
          x = a * std::cos(angle), y = b * std::sin(angle);
        }
        if (kind == dome) z = 0.2 * std::sqrt(std::max(0.0, 1 - x * x / (a * a)));
        if (kind == frame && std::abs(x) < 0.5 * a && std::abs(y) < 0.5 * b)
          x += x > 0 ? 0.5 * a : -0.5 * a;
        if (kind == cloud && i % 3 == 0) z = random.uniform(-1, 1);
        points.points.push_back(center + turn * Eigen::Vector3d(x, y, z));
        label.push_back(random.chance(0.03) ? -1 : thing);
      }
    }
    if (random.chance(0.1)) {
      points.points.insert(points.points.end(), 20, sensor);
      label.insert(label.end(), 20, 0);
    }
    const ShapeScan scan = testing::surfaces_from_labels(
        points, label, random.chance(0.8) ? &sensor : nullptr, sigma, 1 + random.below(4));
    for (const std::string method : {"default", "paper"}) {
      PerceiveOptions options;
      options.method = method;
      Surfaces surfaces = scan.surfaces;
      find_shapes(scan.cloud, options, surfaces);
      for (const Surface& s : surfaces.surfaces) {
        expect_sane(s, scan.cloud);
        ASSERT_FALSE(::testing::Test::HasFailure()) << "round " << round << ", " << method;
      }
    }
  }
}

}  // namespace
}  // namespace scanchor
