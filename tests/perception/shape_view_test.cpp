#include "perception/shape_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

PointCloud all_around(int count, std::uint64_t seed, const Eigen::Vector3d& sensor) {
  SequentialRandom random(seed);
  PointCloud cloud;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d d(random.normal(), random.normal(), random.normal());
    cloud.points.push_back(sensor + random.uniform(1, 5) * d.normalized());
  }
  return cloud;
}

TEST(ShapeView, HoldsEveryFinitePointOnce) {
  const Eigen::Vector3d sensor(1, 2, 3);
  PointCloud cloud = all_around(5000, 1, sensor);
  cloud.points[7] = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  cloud.points[8] = sensor;
  const ShapeView view(cloud, sensor, std::vector<std::int32_t>(cloud.size(), -1));
  std::multiset<std::uint32_t> seen;
  for (std::uint32_t c = 0; c < view.cell_count(); ++c) {
    for (const ShapeRay& ray : view.rays(c)) {
      seen.insert(ray.index);
      const std::uint32_t cell = view.cell_of(ray.direction);
      const auto around = view.around(cell);  // rounding may put a direction on a border there
      EXPECT_TRUE(cell == c || std::count(around.begin(), around.end(), c) > 0);
      EXPECT_EQ(ray.point, cloud.points[ray.index]);
      EXPECT_NEAR((sensor + ray.range * ray.direction - ray.point).norm(), 0.0, 1e-12);
    }
  }
  EXPECT_EQ(seen.size(), 4998U);
  EXPECT_EQ(std::set<std::uint32_t>(seen.begin(), seen.end()).size(), 4998U);
  EXPECT_EQ(seen.count(7), 0U);
  EXPECT_EQ(seen.count(8), 0U);
}

TEST(ShapeView, PointsOfAPlaneComeInTheSameSequenceForAnyOrder) {
  SequentialRandom random(5);
  PointCloud cloud;
  std::vector<std::int32_t> plane;
  for (int i = 0; i < 3000; ++i) {
    cloud.points.emplace_back(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(1, 3));
    plane.push_back(i % 4 - 1);
  }
  PointCloud other = cloud;
  std::reverse(other.points.begin(), other.points.end());
  std::vector<std::int32_t> other_plane(plane.rbegin(), plane.rend());
  const ShapeView a(cloud, {0, 0, 0}, plane);
  const ShapeView b(other, {0, 0, 0}, other_plane);
  for (int p = 0; p < 3; ++p) {
    const auto left = a.plane_rays(p);
    const auto right = b.plane_rays(p);
    ASSERT_EQ(left.size(), 750U);
    ASSERT_EQ(right.size(), left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      EXPECT_EQ(a.ray(left[i]).plane, p);
      EXPECT_EQ(plane[a.ray(left[i]).index], p);
      EXPECT_EQ(a.ray(left[i]).point, b.ray(right[i]).point);
    }
    std::vector<std::uint32_t> cells;
    for (std::uint32_t c = 0; c < a.cell_count(); ++c) {
      const auto rays = a.rays(c);
      if (std::any_of(rays.begin(), rays.end(), [&](const ShapeRay& r) { return r.plane == p; }))
        cells.push_back(c);
    }
    const auto listed = a.plane_cells(p);
    EXPECT_EQ(std::vector<std::uint32_t>(listed.begin(), listed.end()), cells);
  }
  EXPECT_TRUE(a.plane_rays(3).empty());
  EXPECT_TRUE(a.plane_cells(3).empty());
}

TEST(ShapeView, NeighbourCellsHoldTheNeighbourDirectionsAlsoAcrossTheCube) {
  const PointCloud cloud = all_around(20000, 2, Eigen::Vector3d::Zero());
  const ShapeView view(cloud, Eigen::Vector3d::Zero(), std::vector<std::int32_t>(cloud.size(), -1));
  SequentialRandom random(3);
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d a =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    const Eigen::Vector3d b =
        (a + 0.3 * view.cell_angle() *
                 Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized())
            .normalized();
    const auto from = view.cell_of(a);
    const auto to = view.cell_of(b);
    if (from == to) continue;
    const auto around = view.around(from);
    EXPECT_TRUE(std::count(around.begin(), around.end(), to))
        << a.transpose() << " to " << b.transpose();
  }
}

TEST(ShapeView, ACellBelongsToAPlaneOnlyIfAllOfItDoes) {
  const PointCloud cloud = all_around(3000, 4, Eigen::Vector3d::Zero());
  std::vector<std::int32_t> plane(cloud.size());
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = cloud.points[i].z() > 0 ? 0 : 1;
  const ShapeView view(cloud, Eigen::Vector3d::Zero(), plane);
  for (std::uint32_t c = 0; c < view.cell_count(); ++c) {
    std::set<std::int32_t> found;
    for (const ShapeRay& ray : view.rays(c)) found.insert(ray.plane);
    if (found.empty()) {
      EXPECT_EQ(view.owner(c), ShapeView::empty);
    }
    if (found.size() == 1) {
      EXPECT_EQ(view.owner(c), *found.begin());
    }
    if (found.size() == 2) {
      EXPECT_EQ(view.owner(c), ShapeView::mixed);
    }
  }
}

TEST(ShapeView, ACellIsDeepWhereAllAroundIsOfItsPlane) {
  const PointCloud cloud = all_around(6000, 6, Eigen::Vector3d::Zero());
  std::vector<std::int32_t> plane(cloud.size());
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = cloud.points[i].z() > 0 ? 0 : 1;
  const ShapeView view(cloud, Eigen::Vector3d::Zero(), plane);
  std::size_t deep = 0;
  for (std::uint32_t c = 0; c < view.cell_count(); ++c) {
    const std::int32_t owner = view.owner(c);
    bool expected = owner >= 0;
    for (const auto a : view.around(c)) expected = expected && view.owner(a) == owner;
    EXPECT_EQ(view.is_deep(c), expected);
    deep += view.is_deep(c);
  }
  EXPECT_GT(deep, view.cell_count() / 4);
  EXPECT_LT(deep, view.cell_count());
}

TEST(ShapeView, CellsAreAboutTwoSpacingsWide) {
  PointCloud cloud;
  for (int i = -50; i < 50; ++i) {
    for (int j = -50; j < 50; ++j)
      cloud.points.emplace_back(2.0, 0.02 * i, 0.02 * j);  // 0.01 rad apart
  }
  const ShapeView view(cloud, Eigen::Vector3d::Zero(), std::vector<std::int32_t>(cloud.size(), -1));
  EXPECT_GT(view.cell_angle(), 0.015);
  EXPECT_LT(view.cell_angle(), 0.035);
}

}  // namespace
}  // namespace scanchor
