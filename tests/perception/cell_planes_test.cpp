#include "perception/cell_planes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "core/random.hpp"

namespace scanchor {
namespace {

CanonicalCloud canonical(const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  return canonical_cloud(points, all);
}

TEST(CellPlanes, OnePlaneIsOneRegion) {
  SequentialRandom random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 20000; ++i) {
    points.emplace_back(4.0 * random.uniform(), 3.0 * random.uniform(), 0.01 * random.normal());
  }
  const auto cloud = canonical(points);
  const auto tree = cell_tree(cloud);
  std::vector<std::int32_t> region_of_cell;
  const auto labels = cell_planes(cloud, tree, 0.01, region_of_cell);
  ASSERT_EQ(labels.planes.size(), 1U);
  EXPECT_EQ(region_of_cell.size(), tree.cells.size());
  const auto in = std::count(labels.of_point.begin(), labels.of_point.end(), 0);
  EXPECT_GT(in, 20000 * 0.995);  // three sigma hold 99.7 %
}

TEST(CellPlanes, WallsOfABoxAreSixRegions) {
  SequentialRandom random(2);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 60000; ++i) {
    Eigen::Vector3d p(random.uniform(), random.uniform(), random.uniform());
    p[i % 3] = i % 6 < 3 ? 0.0 : 1.0;
    p[i % 3] += 0.003 * random.normal();
    points.push_back(p.cwiseProduct(Eigen::Vector3d(3.0, 2.0, 1.5)));
  }
  const auto cloud = canonical(points);
  std::vector<std::int32_t> region_of_cell;
  const auto labels = cell_planes(cloud, cell_tree(cloud), 0.009, region_of_cell);
  std::map<std::pair<int, std::int32_t>, int> count;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ++count[{static_cast<int>(cloud.source[cloud.first[i]] % 6), labels.of_point[i]}];
  }
  for (int wall = 0; wall < 6; ++wall) {
    int most = 0;
    for (const auto& [key, n] : count) {
      if (key.first == wall && key.second >= 0) most = std::max(most, n);
    }
    EXPECT_GT(most, 7900)
        << wall;  // of 10,000: cells that an edge of the box runs through are not flat
  }
}

TEST(CellPlanes, ACloudOfPointsInSpaceHasNone) {
  SequentialRandom random(3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 5000; ++i)
    points.emplace_back(random.uniform(), random.uniform(), random.uniform());
  const auto cloud = canonical(points);
  std::vector<std::int32_t> region_of_cell;
  const auto labels = cell_planes(cloud, cell_tree(cloud), 0.003, region_of_cell);
  EXPECT_LT(
      std::count_if(labels.of_point.begin(), labels.of_point.end(), [](auto l) { return l >= 0; }),
      250);
}

TEST(PlaneMembers, AreThePointsOfEachPlaneRising) {
  PlaneLabels labels;
  labels.of_point = {2, -1, 0, 2, 0, -1, 2};
  labels.planes.resize(4);
  const PlaneMembers members(labels);
  const auto list = [&](std::size_t r) {
    return std::vector<std::uint32_t>(members[r].begin(), members[r].end());
  };
  EXPECT_EQ(list(0), (std::vector<std::uint32_t>{2, 4}));
  EXPECT_TRUE(members[1].empty());
  EXPECT_EQ(list(2), (std::vector<std::uint32_t>{0, 3, 6}));
  EXPECT_TRUE(members[3].empty());
}

TEST(CellPlanes, ScatterStaysWithinWhatTheNoiseAllows) {
  Moments moments;
  for (int i = 0; i < 100; ++i) moments.add(i % 10, i / 10, i % 2);
  EXPECT_DOUBLE_EQ(grown_plane(moments, 0.01).sigma, 0.012);
  Moments flat;
  for (int i = 0; i < 100; ++i) flat.add(i % 10, i / 10, 0);
  EXPECT_DOUBLE_EQ(grown_plane(flat, 0.01).sigma, 0.0025);
}

}  // namespace
}  // namespace scanchor
