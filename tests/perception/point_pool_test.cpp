#include "perception/point_pool.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

TEST(PointPool, LeavesCoverThePoolAndLinksAreMutual) {
  SequentialRandom random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 6000; ++i) {
    const bool dense = i % 2 == 0;
    points.emplace_back(dense ? 0.3 * random.uniform() : 3.0 * random.uniform(),
                        2.0 * random.uniform(), random.uniform());
  }
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto cloud = canonical_cloud(points, all);
  const auto tree = cell_tree(cloud);
  PlaneLabels labels;
  labels.of_point.assign(cloud.size(), -1);
  for (std::size_t i = 0; i < cloud.size(); i += 3) labels.of_point[i] = 0;
  const auto pool =
      point_pool(cloud, tree, labels, std::vector<std::int32_t>(tree.cells.size(), -1), 0.0);
  EXPECT_EQ(pool.place.size(), 4000U);
  std::size_t covered = 0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> links;
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    covered += pool.cell(l).size();
    for (auto k = pool.start[l]; k < pool.start[l + 1]; ++k) {
      EXPECT_NE(pool.to[k], l);
      EXPECT_TRUE(links.insert({l, pool.to[k]}).second) << "twice";
    }
  }
  EXPECT_EQ(covered, pool.place.size());
  for (const auto& [a, b] : links) EXPECT_TRUE(links.count({b, a})) << a << " " << b;

  // Against the definition: two leaves are neighbours if their cubes touch.
  const auto corner = [&](std::uint32_t l) {
    const Cell& cell = pool.cell(l);
    const auto side = pool.cloud.cell_side(cell.level);
    const Eigen::Vector3f d = (pool.cloud.point(cell.begin) - pool.cloud.low) / side;
    return std::pair<Eigen::Vector3f, float>{Eigen::Vector3f(d.array().floor()) * side, side};
  };
  for (std::uint32_t a = 0; a < pool.leaf.size(); a += 29) {
    const auto [low_a, side_a] = corner(a);
    for (std::uint32_t b = 0; b < pool.leaf.size(); ++b) {
      if (a == b) continue;
      const auto [low_b, side_b] = corner(b);
      const float slack = 1e-4F;
      const bool touch = ((low_a.array() <= low_b.array() + side_b + slack) &&
                          (low_b.array() <= low_a.array() + side_a + slack))
                             .all();
      EXPECT_EQ(touch, links.count({a, b}) == 1) << a << " " << b;
    }
  }
}

}  // namespace
}  // namespace scanchor
