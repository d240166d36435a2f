#include "perception/thin_planes.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/random.hpp"
#include "tests/perception/support/plane_score.hpp"

namespace scanchor {
namespace {

// Four legs of 6 x 6 cm on a floor, two faces of each seen: no cell is flat there, the pool must
// find them.
TEST(ThinPlanes, FacesOfLegs) {
  SequentialRandom random(1);
  const double sigma = 0.004;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::int32_t> truth;
  for (int i = 0; i < 20000; ++i) {
    points.emplace_back(2.0 * random.uniform(), 2.0 * random.uniform(), sigma * random.normal());
    truth.push_back(0);
  }
  for (int leg = 0; leg < 4; ++leg) {
    const double x = 0.5 + 0.8 * (leg % 2), y = 0.5 + 0.8 * (leg / 2);
    for (int i = 0; i < 300; ++i) {
      const double along = 0.06 * random.uniform(), z = random.uniform(0.02, 0.7),
                   off = sigma * random.normal();
      points.push_back(i % 2 == 0 ? Eigen::Vector3d(x + along, y + off, z)
                                  : Eigen::Vector3d(x + off, y + along, z));
      truth.push_back(1 + 2 * leg + i % 2);
    }
  }
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto cloud = canonical_cloud(points, all);
  const auto tree = cell_tree(cloud);
  std::vector<std::int32_t> region_of_cell;
  PlaneLabels labels = cell_planes(cloud, tree, sigma, region_of_cell);
  thin_planes(cloud, tree, sigma, region_of_cell, labels);
  std::vector<std::int32_t> by_source(points.size(), -1);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    by_source[cloud.source[cloud.first[i]]] = labels.of_point[i];
  const auto score = support::score_planes(truth, by_source, 0.8, 50);
  EXPECT_EQ(score.planes, 9);
  // Eight faces are there; four planes come out right at 80 % overlap, for faces 15 sigma broad
  // meet at every corner (docs/why/planes.md).
  EXPECT_GE(score.correct, 4);
  EXPECT_LE(score.spurious, 6);
}

}  // namespace
}  // namespace scanchor
