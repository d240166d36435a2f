#include "perception/beam_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/random.hpp"

namespace scanchor {
namespace {

CanonicalCloud sphere_of_points(int count) {
  SequentialRandom random(3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(
        Eigen::Vector3d(3 * random.normal(), 2 * random.normal(), random.normal()).normalized() *
        random.uniform(1.0, 4.0));
  }
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  return canonical_cloud(points, all);
}

TEST(BeamGrid, EveryPointIsInItsCellOnce) {
  const auto cloud = sphere_of_points(5000);
  const BeamGrid grid(cloud, Eigen::Vector3d::Zero());
  std::vector<int> seen(cloud.size(), 0);
  for (std::uint32_t cell = 0; cell < grid.cell_count(); ++cell) {
    for (const auto p : grid.points(cell)) {
      ++seen[p];
      EXPECT_EQ(grid.cell_of_point(p), cell);
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(cloud.size()));
}

TEST(BeamGrid, ADirectionLeadsToTheCellOfThePointsThere) {
  const auto cloud = sphere_of_points(5000);
  const Eigen::Vector3d sensor(0.1, 0.2, 0.3);
  const BeamGrid grid(cloud, sensor);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    EXPECT_EQ(grid.cell_towards(0.5F * (cloud.point(i) - sensor.cast<float>())),
              grid.cell_of_point(i));
  std::size_t rim = 0;
  for (std::uint32_t cell = 0; cell < BeamGrid::cells_per_tile; ++cell)
    rim += BeamGrid::is_on_rim(cell) ? 1U : 0U;
  EXPECT_EQ(rim, 28U);
  EXPECT_EQ(grid.cell_count() % BeamGrid::cells_per_tile, 0U);
}

// A scanner of few beams a line and many lines: no empty cells between what lies side by side.
TEST(BeamGrid, BeamsThatLieCloserOneWayAreNeighboursTheOtherWay) {
  for (const double ratio : {1.0, 4.0, 8.0}) {
    std::vector<Eigen::Vector3d> points;
    const double across = 0.02, along = across / ratio;
    for (double a = -0.6; a < 0.6; a += along) {
      for (double b = -0.6; b < 0.6; b += across) points.push_back({2.0, 2.0 * a, 2.0 * b});
    }
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    const auto cloud = canonical_cloud(points, all);
    const Eigen::Vector3d sensor =
        cloud.T_cloud_canonical.inverse() * Eigen::Vector3d(0.0, 0.0, 0.0);
    const BeamGrid grid(cloud, sensor);
    std::size_t empty = 0, asked = 0;
    for (std::size_t i = 0; i < cloud.size(); i += 3) {
      const Eigen::Vector3d p = points[cloud.source[cloud.first[i]]];
      if (std::abs(p.y()) > 1.0 || std::abs(p.z()) > 1.0) continue;  // not the rim
      for (const auto cell : grid.around<1>(grid.cell_of_point(i))) {
        ++asked;
        empty += grid.points(cell).empty() ? 1U : 0U;
      }
    }
    EXPECT_LT(static_cast<double>(empty), 0.3 * static_cast<double>(asked)) << ratio;
  }
}

// Across the edges of the cube too: what lies around a cell is near it in direction.
TEST(BeamGrid, NeighboursLookTheSameWay) {
  const auto cloud = sphere_of_points(20000);
  const BeamGrid grid(cloud, Eigen::Vector3d::Zero());
  const double faces = static_cast<double>(grid.cell_count()) / 6.0;
  const double cell_angle = 2.0 / std::sqrt(faces);  // at the middle of a face, the largest
  std::size_t compared = 0;
  for (std::size_t i = 0; i < cloud.size(); i += 7) {
    const auto cells = grid.around<1>(grid.cell_of_point(i));
    EXPECT_EQ(cells[4], grid.cell_of_point(i));
    for (const auto cell : cells) {
      ASSERT_LT(cell, grid.cell_count());
      for (const auto p : grid.points(cell)) {
        const double cosine = cloud.point(i).cast<double>().normalized().dot(
            cloud.point(p).cast<double>().normalized());
        EXPECT_LT(std::acos(std::min(1.0, cosine)), 3.0 * cell_angle);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 5000U);
  // Near is found: of pairs closer than half a cell nearly all are neighbours.
  std::size_t near = 0, found = 0;
  for (std::size_t i = 0; i < cloud.size(); i += 40) {
    const auto cells = grid.around<1>(grid.cell_of_point(i));
    for (std::size_t j = 0; j < cloud.size(); ++j) {
      const double cosine = cloud.point(i).cast<double>().normalized().dot(
          cloud.point(j).cast<double>().normalized());
      if (j == i || std::acos(std::min(1.0, cosine)) > 0.3 * cell_angle) continue;
      ++near;
      found += std::find(cells.begin(), cells.end(), grid.cell_of_point(j)) != cells.end();
    }
  }
  EXPECT_GT(near, 100U);
  EXPECT_GE(static_cast<double>(found), 0.99 * static_cast<double>(near));
}

}  // namespace
}  // namespace scanchor
