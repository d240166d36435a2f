#include "perception/outline_samples.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/perception/support/shape_scene.hpp"

namespace scanchor {
namespace {

using testing::box_panel;
using testing::scan_panels;
using testing::ScannerSetup;
using testing::ShapeScan;

/// A board 2 m ahead, a wall 5 m ahead, a post that hides a part of the board.
ShapeScan board_scan(double sigma) {
  ScannerSetup setup;
  setup.range_sigma = sigma;
  return scan_panels({box_panel({2, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 0.8),
                      box_panel({5, 0, 0}, {0, 1, 0}, {0, 0, 1}, 20, 20),
                      box_panel({1, 0.25, 0}, {0, 1, 0}, {0, 0, 1}, 0.05, 3.0)},
                     setup);
}

std::size_t surface_of(const ShapeScan& scan, int panel) {
  for (std::size_t i = 0; i < scan.panel_of_surface.size(); ++i) {
    if (scan.panel_of_surface[i] == panel) return i;
  }
  return 0;
}

TEST(OutlineSamples, KindsFollowWhatTheRaysMet) {
  const ShapeScan scan = board_scan(0.01);
  const std::size_t board = surface_of(scan, 0);
  const Surface& s = scan.surfaces.surfaces[board];
  const ShapeView view(scan.cloud, {0, 0, 0}, scan.surfaces.plane_of_point);
  const OutlineSamples samples = samples_with_view(view, s, s.T_cloud_surface, 0.035);
  std::array<int, 4> counts{};
  for (const OutlineSample& sample : samples.samples) {
    ++counts[static_cast<std::size_t>(sample.kind)];
    const int panel =
        scan.panel_of_surface[static_cast<std::size_t>(scan.surfaces.plane_of_point[sample.point])];
    if (panel == 0) {
      EXPECT_EQ(sample.kind, SampleKind::inside);
    }
    if (panel == 1) {
      EXPECT_EQ(sample.kind, SampleKind::passed);
    }
    if (panel == 2) {
      EXPECT_EQ(sample.kind, SampleKind::blocked);
    }
  }
  EXPECT_GT(counts[0], 500);
  EXPECT_GT(counts[1], 100);
  EXPECT_GT(counts[2], 50);
  EXPECT_LT(static_cast<std::size_t>(counts[0]), s.inliers.size())
      << "cells deep inside are thinned";
}

TEST(OutlineSamples, RangeNoiseDoesNotMoveThemAlongThePlane) {
  // The same rays with and without noise meet the plane in the same places.
  const ShapeScan clean = board_scan(0.0);
  ShapeScan noisy = board_scan(0.03);
  const std::size_t board = surface_of(clean, 0);
  const Surface& s = clean.surfaces.surfaces[board];
  const ShapeView view(noisy.cloud, {0, 0, 0}, clean.surfaces.plane_of_point);
  const OutlineSamples samples = samples_with_view(view, s, s.T_cloud_surface, 0.2);
  int checked = 0;
  for (const OutlineSample& sample : samples.samples) {
    if (sample.kind != SampleKind::inside) continue;
    const Eigen::Vector3d p = s.T_cloud_surface.inverse() * clean.cloud.points[sample.point];
    EXPECT_NEAR((sample.plane - p.head<2>()).norm(), 0.0, 1e-9);
    ++checked;
  }
  EXPECT_GT(checked, 100);
}

TEST(OutlineSamples, TheChartIsAProjectiveImageOfThePlane) {
  const ShapeScan scan = board_scan(0.0);
  const Surface& s = scan.surfaces.surfaces[surface_of(scan, 0)];
  const ShapeView view(scan.cloud, {0, 0, 0}, scan.surfaces.plane_of_point);
  const OutlineSamples samples = samples_with_view(view, s, s.T_cloud_surface, 1e-6);
  for (const OutlineSample& sample : samples.samples) {
    if (!sample.reachable) continue;
    Eigen::Vector2d plane;
    ASSERT_TRUE(samples.chart.to_plane(sample.chart, plane));
    EXPECT_NEAR((plane - sample.plane).norm(), 0.0, 1e-9);
  }
}

TEST(OutlineSamples, WithoutAViewAllArePointsOfTheSurface) {
  const ShapeScan scan = testing::flat_scan({{0, 0}, {1, 0}, {0, 1}, {1, 1}});
  const Surface& s = scan.surfaces.surfaces.front();
  const OutlineSamples samples = samples_without_view(flatten(scan.cloud, s), s.T_cloud_surface);
  ASSERT_EQ(samples.samples.size(), 4U);
  EXPECT_FALSE(samples.with_view);
  for (const OutlineSample& sample : samples.samples) {
    EXPECT_EQ(sample.kind, SampleKind::inside);
    EXPECT_EQ(sample.chart, sample.plane);
  }
}

}  // namespace
}  // namespace scanchor
