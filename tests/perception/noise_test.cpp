#include "perception/noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/random.hpp"
#include "tests/perception/support/room.hpp"

namespace scanchor {
namespace {

CanonicalCloud canonical_of_all(const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  return canonical_cloud(points, all);
}

TEST(Noise, SpacingIsTheMedianOfBruteForce) {
  SequentialRandom random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 900; ++i) {
    const double density = i % 3 == 0 ? 4.0 : 0.5;
    points.emplace_back(density * random.uniform(), density * random.uniform(),
                        0.2 * random.uniform());
  }
  const auto cloud = canonical_of_all(points);
  std::vector<float> nearest;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    float best = 1e9F;
    for (std::size_t j = 0; j < cloud.size(); ++j) {
      if (j != i) best = std::min(best, (cloud.point(i) - cloud.point(j)).norm());
    }
    nearest.push_back(best);
  }
  std::sort(nearest.begin(), nearest.end());
  EXPECT_NEAR(median_spacing(cloud), nearest[nearest.size() / 2], 1e-6);
}

// The reference room from 0.2 to 4 cm, with and without a known sensor.
TEST(Noise, EstimateIsTheSensorsNoise) {
  for (const double sigma : {0.002, 0.005, 0.01, 0.02, 0.04}) {
    support::RayGrid grid;
    grid.beams = 250;
    grid.lines = 150;
    grid.range_sigma = sigma;
    const auto scan = support::scan_boxes(support::reference_room(11), grid);
    const auto cloud = canonical_of_all(scan.cloud.points);
    const auto tree = cell_tree(cloud);
    const double spacing = median_spacing(cloud);
    EXPECT_NEAR(estimate_noise(cloud, tree, spacing, {grid.position}) / sigma, 1.0, 0.15) << sigma;
    EXPECT_NEAR(estimate_noise(cloud, tree, spacing, {}) / sigma, 0.9, 0.2) << sigma;
  }
}

TEST(Noise, FlatDataGiveTheLeastThatIsBelieved) {
  support::RayGrid grid;
  grid.beams = 200;
  grid.lines = 100;
  grid.range_sigma = 0.0;
  const auto scan = support::scan_boxes(support::reference_room(12), grid);
  const auto cloud = canonical_of_all(scan.cloud.points);
  const double spacing = median_spacing(cloud);
  EXPECT_LT(estimate_noise(cloud, cell_tree(cloud), spacing, {}),
            2.0 * least_noise(cloud, spacing));
  EXPECT_GT(least_noise(cloud, spacing), 0.0);
}

TEST(Noise, TooFewPointsFallBackToTheSpacing) {
  const auto cloud = canonical_of_all({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_DOUBLE_EQ(estimate_noise(cloud, cell_tree(cloud), 1.0, {}), 0.25);
  EXPECT_EQ(median_spacing(canonical_of_all({{0, 0, 0}})), 0.0);
}

}  // namespace
}  // namespace scanchor
