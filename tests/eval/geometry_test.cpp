#include "eval/geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

TEST(Geometry, StatsByHand) {
  ErrorStats stats;
  for (const double error : {0.01, -0.03, 0.02}) stats.add(error);
  stats.add(std::nan(""));  // no error at all
  EXPECT_EQ(stats.count, 3);
  EXPECT_NEAR(stats.mean(), 0.02, 1e-9);
  EXPECT_NEAR(stats.bias(), 0.0, 1e-9);
  EXPECT_NEAR(stats.rms(), std::sqrt(0.0014 / 3), 1e-9);
}

TEST(Geometry, QuantilesAreWithinABinOfTheSortedOnes) {
  ErrorStats stats;
  SequentialRandom random(2);
  std::vector<double> sorted;
  for (int i = 0; i < 2000; ++i) {
    const double error = 0.02 * random.normal();
    stats.add(error);
    sorted.push_back(std::abs(error));
  }
  std::sort(sorted.begin(), sorted.end());
  for (const double share : {0.5, 0.9, 0.95}) {
    const double exact = sorted[static_cast<std::size_t>(share * 2000) - 1];
    EXPECT_GE(stats.quantile(share), exact * 0.999);
    EXPECT_LE(stats.quantile(share), exact * 1.13);
  }
}

TEST(Geometry, PoolingEqualsAddingOneByOne) {
  ErrorStats a, b, both;
  for (int i = 1; i < 50; ++i) {
    (i % 2 ? a : b).add(0.001 * i);
    both.add(0.001 * i);
  }
  b.add(a);
  EXPECT_EQ(b, both);
}

// The measured plane is tilted by 2 degrees, 1 cm too high, 3 cm too long.
TEST(Geometry, KnownErrorsComeBack) {
  const SmallScan made = small_scan();
  const Protocol protocol;
  const ScanTruth truth = truth_of(made.scan, &made.scene, protocol);
  Surfaces surfaces = true_surfaces(made.scan, truth);
  ASSERT_FALSE(surfaces.surfaces.empty());
  Surface& surface = surfaces.surfaces[0];
  const PlaneTruth& plane = truth.planes[static_cast<std::size_t>(truth.plane[surface.inliers[0]])];
  surface.plane.normal =
      Eigen::AngleAxisd(radians(2.0), plane.normal.unitOrthogonal()) * -plane.normal;
  surface.plane.centroid = plane.normal * (plane.offset + 0.01);
  surface.plane.centroid_sigma = 0.002;
  surface.polygons.resize(1);
  surface.rectangle.length = {plane.length + 0.03, plane.length - 0.01, plane.length + 0.07, false};
  surface.rectangle.width = {plane.width - 0.1, plane.width - 0.12, plane.width - 0.08, true};
  surface.area = {plane.area, 0, 0, false};
  PlaneMatch match;
  score_planes(truth.plane, truth.ignored_planes, surfaces.plane_of_point, protocol, &match);
  const GeometryScore score = score_geometry(truth, match, surfaces, made.scan, protocol);
  const auto worst = [](const ErrorStats& stats) {
    return stats.mean() * static_cast<double>(stats.count);
  };
  EXPECT_NEAR(worst(score.normal_deg), 2.0, 1e-6);
  EXPECT_NEAR(worst(score.offset), 0.01, 1e-9);
  EXPECT_EQ(score.offset.covered, score.offset.with_interval - 1);  // 5 sigma off
  EXPECT_NEAR(worst(score.length), 0.03, 1e-9);
  EXPECT_EQ(score.length.covered, 1);
  EXPECT_NEAR(score.width.bias() * static_cast<double>(score.width.count), -0.1, 1e-9);
  EXPECT_EQ(score.width.covered, score.width.with_interval);  // "at least" holds
}

}  // namespace
}  // namespace scanchor
