#include "perception/chance_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "perception/perceive.hpp"

namespace scanchor {
namespace {

// P(at least k of n), summed exactly.
double binomial_tail(int k, int n, double p) {
  double sum = 0.0;
  for (int i = k; i <= n; ++i) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(i + 1.0) - std::lgamma(n - i + 1.0) +
                    i * std::log(p) + (n - i) * std::log1p(-p));
  }
  return sum;
}

TEST(ChancePlanes, TheBoundHoldsAndIsNotFarOff) {
  for (const int n : {10, 40, 200}) {
    for (int k = n / 2; k < n; k += n / 10) {
      const double exact = std::log(binomial_tail(k, n, 1.0 / 3.0));
      EXPECT_GE(log_chance(k, n, 1.0 / 3.0), exact) << k << " of " << n;
      EXPECT_LE(log_chance(k, n, 1.0 / 3.0), exact + 0.5 * std::log(8.0 * n)) << k << " of " << n;
    }
  }
  EXPECT_EQ(log_chance(10, 40, 1.0 / 3.0), 0.0);
  EXPECT_NEAR(log_chance(20, 20, 1.0 / 3.0), 20 * std::log(1.0 / 3.0), 1e-9);
}

// Points without order have no planes, whatever noise they are said to have.
TEST(ChancePlanes, RandomPointsHaveNone) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    SequentialRandom random(seed);
    PointCloud cloud;
    const int count = seed == 4 ? 200000 : 20000;
    for (int i = 0; i < count; ++i)
      cloud.points.emplace_back(random.uniform(), random.uniform(), random.uniform());
    for (const double sigma : {0.0, 0.002, 0.01}) {
      PerceiveOptions options;
      options.shapes = false;
      options.noise_sigma = sigma;
      EXPECT_LE(find_planes(cloud, options).surfaces.size(), 1U) << seed << " " << sigma;
    }
  }
}

// A strip of 30 points among as many strays in its surroundings stands; strays alone do not.
TEST(ChancePlanes, AThinStripStands) {
  SequentialRandom random(9);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 30; ++i)
    points.emplace_back(0.6 * random.uniform(), 0.03 * random.uniform(), 0.002 * random.normal());
  for (int i = 0; i < 60; ++i)
    points.emplace_back(random.uniform(), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
  for (int i = 0; i < 30; ++i)  // spread through the surroundings of a plane at x = 3
    points.emplace_back(3.0 + random.uniform(-0.018, 0.018), random.uniform(), random.uniform());
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto cloud = canonical_cloud(points, all);
  PlaneLabels labels;
  std::vector<Moments> sums(2);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto source = cloud.source[cloud.first[i]];
    const bool within = std::abs(points[source].x() - 3.0) < 0.006;
    const int plane = source < 30 ? 0 : (source >= 90 && within ? 1 : -1);
    labels.of_point.push_back(plane);
    if (plane >= 0) sums[static_cast<std::size_t>(plane)].add(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  for (const auto& sum : sums) labels.planes.push_back(grown_plane(sum, 0.002));
  ASSERT_GE(sums[1].n, 6.0);
  drop_chance_planes(cloud, cell_tree(cloud), labels);
  EXPECT_EQ(std::count(labels.of_point.begin(), labels.of_point.end(), 0), 30);
  EXPECT_EQ(std::count(labels.of_point.begin(), labels.of_point.end(), 1), 0);
}

}  // namespace
}  // namespace scanchor
