#include "perception/surfels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/random.hpp"

namespace scanchor {
namespace {

// A pool of all points: nothing was settled by flat cells.
PointPool pool_of(const std::vector<Eigen::Vector3d>& points, double sigma) {
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto cloud = canonical_cloud(points, all);
  const auto tree = cell_tree(cloud);
  PlaneLabels labels;
  labels.of_point.assign(cloud.size(), -1);
  return point_pool(cloud, tree, labels, std::vector<std::int32_t>(tree.cells.size(), -1), sigma);
}

std::vector<Eigen::Vector3d> sheet(double sigma) {
  SequentialRandom random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 4000; ++i)
    points.emplace_back(random.uniform(), 0.7 * random.uniform(), sigma * random.normal());
  return points;
}

TEST(Surfels, NormalErrorIsWhatTiltSays) {
  const double sigma = 0.01;
  const auto pool = pool_of(sheet(sigma), sigma);
  // The canonical frame of a sheet: its least axis is the normal, to within the sheet's own fit.
  int known = 0, within = 0;
  for (const auto& surfel : fit_surfels(pool, sigma)) {
    if (surfel.tilt >= unknown_tilt) continue;
    ++known;
    within += std::acos(std::min(1.0, std::abs(surfel.grown.plane.normal.z()))) <
              2.45 * surfel.tilt;  // 95 % of a 2D normal
  }
  ASSERT_GT(known, 200);
  EXPECT_GT(within, known * 88 / 100);
}

TEST(Surfels, ContinuesTellsPlanesApart) {
  const double sigma = 0.01;
  const auto pool = pool_of(sheet(sigma), sigma);
  const auto surfels = fit_surfels(pool, sigma);
  Moments all;
  for (std::size_t i = 0; i < pool.cloud.size(); ++i)
    all.add(pool.cloud.x[i], pool.cloud.y[i], pool.cloud.z[i]);
  const GrownPlane here = grown_plane(all, sigma);
  GrownPlane above = here, tilted = here;
  above.plane.offset += 0.03;
  tilted.plane.normal =
      (here.plane.normal + 1.0 * here.plane.axes.col(1)).normalized();  // 45 degrees
  tilted.plane.offset = tilted.plane.normal.dot(all.mean());
  int known = 0, on = 0, off = 0, turned = 0;
  for (const auto& surfel : surfels) {
    if (surfel.tilt >= unknown_tilt) continue;
    ++known;
    on += continues(here, surfel, sigma);
    off += continues(above, surfel, sigma);
    turned += continues(tilted, surfel, sigma);
  }
  EXPECT_GT(on, known * 95 / 100);
  EXPECT_LT(off, known * 5 / 100);
  EXPECT_LT(turned, known * 10 / 100);
}

TEST(Surfels, PointsOnALineKnowNoTilt) {
  SequentialRandom random(2);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 500; ++i)
    points.emplace_back(0.01 * i, 0.002 * random.normal(), 0.002 * random.normal());
  for (const auto& surfel : fit_surfels(pool_of(points, 0.002), 0.002))
    EXPECT_GE(surfel.tilt, unknown_tilt);
}

// Lines of a sweep 15 cm apart, points 4 mm apart: a patch holds points of one line, and the plane
// that fits them best holds the sensor too. It is no surface.
TEST(Surfels, OneLineOfTheSweepKnowsNoPlane) {
  SequentialRandom random(4);
  const double sigma = 0.01;
  std::vector<Eigen::Vector3d> points;
  for (double y = -0.9; y < 1.0; y += 0.15) {
    for (double z = -0.5; z < 0.5; z += 0.004) {
      const Eigen::Vector3d d = Eigen::Vector3d(3.0, y, z).normalized();
      points.push_back(d * (Eigen::Vector3d(3.0, y, z).norm() + sigma * random.normal()));
    }
  }
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  auto cloud = canonical_cloud(points, all);
  const BeamNoise noise(sigma, cloud.T_cloud_canonical.inverse() * Eigen::Vector3d::Zero());
  see_from(noise.sensor, cloud);
  const auto tree = cell_tree(cloud);
  PlaneLabels labels;
  labels.of_point.assign(cloud.size(), -1);
  const auto pool =
      point_pool(cloud, tree, labels, std::vector<std::int32_t>(tree.cells.size(), -1), sigma);
  const Eigen::Vector3d wall =
      cloud.T_cloud_canonical.linear().transpose() * Eigen::Vector3d::UnitX();
  std::size_t known = 0, of_wall = 0;
  for (const auto& surfel : fit_surfels(pool, noise)) {
    if (surfel.tilt >= unknown_tilt) continue;
    ++known;
    of_wall += std::abs(surfel.grown.plane.normal.dot(wall)) > 0.8 ? 1U : 0U;
  }
  EXPECT_EQ(known, of_wall);
}

}  // namespace
}  // namespace scanchor
