#include "perception/shape_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "tests/perception/support/shape_scene.hpp"

namespace scanchor {
namespace {

using testing::box_panel;
using testing::Panel;
using testing::scan_panels;
using testing::ScannerSetup;
using testing::ShapeScan;

/// A 0.6 m board, 3 m away, turned by 45 degrees.
Panel slanted() { return box_panel({3, 0, 0}, {1, 1, 0}, {0, 0, 1}, 0.6, 0.6); }

TEST(RayPlane, DoesNotTiltWithRangeNoise) {
  const Eigen::Vector3d truth = slanted().T.linear().col(2);
  double across = 0.0;
  double along = 0.0;
  constexpr int rounds = 40;
  for (int round = 0; round < rounds; ++round) {
    ScannerSetup setup;
    setup.range_sigma = 0.03;
    setup.seed = static_cast<std::uint64_t>(round);
    const ShapeScan scan = scan_panels({slanted()}, setup);
    const Surface& s = scan.surfaces.surfaces.front();
    const RayPlane plane = fit_along_rays(scan.cloud, s, setup.position);
    // Turn about the vertical, signed.
    const auto turn = [&](const Eigen::Vector3d& n) {
      return std::asin(std::clamp(n.cross(truth).z() * (n.dot(truth) > 0 ? 1.0 : -1.0), -1.0, 1.0));
    };
    across += turn(s.plane.normal) / rounds;
    along += turn(plane.T_cloud_plane.linear().col(2)) / rounds;
  }
  // Predicted bias of the fit across the plane: sigma^2 sin(i) cos(i) / variance = 9e-4 * 0.5 /
  // 0.03 = 0.015 rad.
  EXPECT_GT(std::abs(across), radians(0.5));
  EXPECT_LT(std::abs(along), radians(0.1));
}

TEST(RayPlane, CovarianceMatchesTheSpreadOfTheFits) {
  // The width across the slope depends on the tilt: predicted variance against the variance over 60
  // scans.
  std::vector<double> widths;
  double predicted = 0.0;
  for (int round = 0; round < 60; ++round) {
    ScannerSetup setup;
    setup.range_sigma = 0.02;
    setup.seed = static_cast<std::uint64_t>(100 + round);
    const ShapeScan scan = scan_panels({slanted()}, setup);
    const RayPlane plane =
        fit_along_rays(scan.cloud, scan.surfaces.surfaces.front(), setup.position);
    // Where the rays to the two vertical edges meet the fitted plane.
    const Eigen::Vector3d a = slanted().T * Eigen::Vector3d(-0.3, 0, 0);
    const Eigen::Vector3d b = slanted().T * Eigen::Vector3d(0.3, 0, 0);
    const Eigen::Vector3d on_a = a / plane.p.dot(a);
    const Eigen::Vector3d on_b = b / plane.p.dot(b);
    widths.push_back((on_b - on_a).norm());
    predicted += plane.distance_variance(on_a, on_b, (on_b - on_a).normalized()) / 60.0;
  }
  double mean = 0.0;
  for (const double w : widths) mean += w / 60.0;
  double variance = 0.0;
  for (const double w : widths) variance += (w - mean) * (w - mean) / 59.0;
  EXPECT_NEAR(mean, 0.6, 4.0 * std::sqrt(predicted / 60.0));
  // Chi-square with 59 degrees of freedom: 99.9 % lie within 0.53 .. 1.70 of the mean.
  EXPECT_GT(variance, 0.5 * predicted);
  EXPECT_LT(variance, 1.75 * predicted);
}

TEST(RayPlane, FallsBackOnPointsThatDetermineNone) {
  PointCloud cloud;
  cloud.points = {{2, 0, 0}, {2, 0.1, 0}, {2, 0.2, 0}, {2, 0.3, 0}, {2, 0.4, 0}};
  Surface surface;
  surface.inliers = {0, 1, 2, 3, 4};
  surface.T_cloud_surface.translation() = Eigen::Vector3d(2, 0.2, 0);
  surface.T_cloud_surface.linear() << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  const RayPlane plane = fit_along_rays(cloud, surface, Eigen::Vector3d::Zero());
  EXPECT_TRUE(plane.T_cloud_plane.isApprox(surface.T_cloud_surface));
}

}  // namespace
}  // namespace scanchor
