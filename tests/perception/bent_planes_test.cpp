#include "perception/bent_planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "perception/find_planes.hpp"
#include "perception/noise.hpp"
#include "tests/perception/support/room.hpp"

namespace scanchor {
namespace {

// A ceiling of 4 x 4 m that a sensor bends by 25 mm, noise of 3 mm; `step`: what x > 0 lies higher
// [m].
PointCloud ceiling(double sagitta, double step) {
  SequentialRandom random(1);
  PointCloud cloud;
  for (int i = 0; i < 30000; ++i) {
    const double x = random.uniform(-2.0, 2.0), y = random.uniform(-2.0, 2.0);
    cloud.points.emplace_back(
        x, y, 2.5 + sagitta * x * x / 4.0 + (x > 0.0 ? step : 0.0) + 0.003 * random.normal());
  }
  return cloud;
}

Surfaces planes_of(const PointCloud& cloud) {
  PerceiveOptions options;
  options.shapes = false;
  options.noise_sigma = 0.003;
  return find_planes(cloud, options);
}

TEST(BentPlanes, ABentCeilingIsOneSurface) {
  const Surfaces found = planes_of(ceiling(0.025, 0.0));
  ASSERT_FALSE(found.surfaces.empty());
  EXPECT_GT(found.surfaces[0].inliers.size(), 28000U);
  EXPECT_GT(found.surfaces[0].confidence, 0.5);
}

TEST(BentPlanes, AStepStaysAStep) {
  for (const auto& surface : planes_of(ceiling(0.025, 0.05)).surfaces)
    EXPECT_LT(surface.inliers.size(), 16500U);
}

// The gate: simulated rooms stay far below it, at any noise.
TEST(BentPlanes, MathematicalPlanesShowNoBend) {
  for (const double sigma : {0.0, 0.005, 0.02}) {
    support::RayGrid grid;
    grid.beams = 300;
    grid.lines = 150;
    grid.range_sigma = sigma;
    const auto scan = support::scan_boxes(support::reference_room(31), grid);
    std::vector<std::uint32_t> all(scan.cloud.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    const auto cloud = canonical_cloud(scan.cloud.points, all);
    const auto tree = cell_tree(cloud);
    const double noise = estimate_noise(cloud, tree, median_spacing(cloud), {grid.position});
    EXPECT_LT(estimate_flatness(tree, noise), 0.5 * bent_from * noise) << sigma;
  }
}

}  // namespace
}  // namespace scanchor
