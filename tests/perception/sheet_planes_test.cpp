#include "perception/sheet_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

// A wall of 3 x 2.4 m in the plane x = 0, a point every 3 cm, 1 cm of noise, all with one label.
struct Wall {
  CanonicalCloud cloud;
  PlaneLabels labels;
  std::vector<bool> raised;  // canonical: where `height` is above 5 mm

  template <class Height>
  Wall(std::uint64_t seed, const Height& height) {
    SequentialRandom random(seed);
    std::vector<Eigen::Vector3d> points;
    std::vector<bool> up;
    for (double y = -1.5; y < 1.5; y += 0.03) {
      for (double z = -1.2; z < 1.2; z += 0.03) {
        points.emplace_back(height(y, z) + 0.01 * random.normal(), y, z);
        up.push_back(height(y, z) > 0.005);
      }
    }
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0U);
    cloud = canonical_cloud(points, all);
    Moments moments;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      moments.add(cloud.x[i], cloud.y[i], cloud.z[i]);
      raised.push_back(up[cloud.source[cloud.first[i]]]);
    }
    labels.of_point.assign(cloud.size(), 0);
    labels.planes.push_back(grown_plane(moments, 0.01));
    split_sheets(cloud, labels, 0.01);
  }
  [[nodiscard]] std::size_t planes() const {
    return std::set<std::int32_t>(labels.of_point.begin(), labels.of_point.end()).size();
  }
  [[nodiscard]] double share_right() const {
    std::size_t right = 0;
    for (std::size_t i = 0; i < raised.size(); ++i)
      right += (labels.of_point[i] != 0) == raised[i] ? 1 : 0;
    return static_cast<double>(right) / static_cast<double>(raised.size());
  }
};

// 1.2 x 0.9 m, `off` metres before the wall.
auto board(double off) {
  return [off](double y, double z) {
    return std::abs(y - 0.3) < 0.6 && std::abs(z) < 0.45 ? off : 0.0;
  };
}

TEST(SheetPlanes, ABoardTwoNoisesBeforeAWallIsToldFromIt) {
  for (std::uint64_t seed = 60; seed < 70; ++seed) {
    const Wall scene(seed, board(0.022));
    EXPECT_EQ(scene.planes(), 2U) << seed;
    EXPECT_GT(scene.share_right(), 0.97) << seed;
    ASSERT_EQ(scene.labels.planes.size(), 2U) << seed;
    const auto &wall = scene.labels.planes[0], &sheet = scene.labels.planes[1];
    EXPECT_NEAR(std::abs(wall.plane.distance(sheet.moments.mean())), 0.022, 0.002) << seed;
  }
}

// The halves of the points that a greedy growth gave to two planes are sorted out too.
TEST(SheetPlanes, TwoMixedPlanesAreSortedOut) {
  Wall scene(71, [](double, double) { return 0.0; });
  ASSERT_EQ(scene.planes(), 1U);
  scene = Wall(72, board(0.022));
  std::vector<Moments> sums(2);
  SequentialRandom random(5);
  for (std::size_t i = 0; i < scene.labels.of_point.size(); ++i) {
    auto& label = scene.labels.of_point[i];
    label = scene.raised[i] ? (random.uniform() < 0.6 ? 1 : 0) : (random.uniform() < 0.1 ? 1 : 0);
    sums[static_cast<std::size_t>(label)].add(scene.cloud.x[i], scene.cloud.y[i], scene.cloud.z[i]);
  }
  scene.labels.planes = {grown_plane(sums[0], 0.01), grown_plane(sums[1], 0.01)};
  EXPECT_LT(scene.share_right(), 0.9);
  split_sheets(scene.cloud, scene.labels, 0.01);
  EXPECT_GT(scene.share_right(), 0.95);
}

// Two planes that cross at a shallow angle part the points of one wall by their noise: what lies
// before goes to one, what lies behind to the other.
TEST(SheetPlanes, WhatNoisePartedIsOneAgain) {
  Wall scene(73, [](double, double) { return 0.0; });
  const GrownPlane truth = scene.labels.planes[0];
  std::vector<Moments> sums(2);
  for (std::size_t i = 0; i < scene.labels.of_point.size(); ++i) {
    const Eigen::Vector3d p = scene.cloud.point(i).cast<double>();
    const double along = truth.plane.axes.col(2).dot(p - truth.moments.mean());
    const bool second = along > 0.9 || (along > 0.0 && truth.plane.distance(p) > 0.0);
    scene.labels.of_point[i] = second ? 1 : 0;
    sums[second ? 1 : 0].add(p.x(), p.y(), p.z());
  }
  scene.labels.planes = {grown_plane(sums[0], 0.01), grown_plane(sums[1], 0.01)};
  split_sheets(scene.cloud, scene.labels, 0.01);
  EXPECT_EQ(scene.planes(), 1U);
}

TEST(SheetPlanes, APlainWallStaysWhole) {
  for (std::uint64_t seed = 80; seed < 110; ++seed)
    EXPECT_EQ(Wall(seed, [](double, double) { return 0.0; }).planes(), 1U) << seed;
}

// A bow of 2 cm over the wall, a wave, and a hump of 3 cm and 1 m: none has a border.
TEST(SheetPlanes, ABendIsNoSheet) {
  for (std::uint64_t seed = 110; seed < 116; ++seed) {
    EXPECT_EQ(Wall(seed, [](double y, double) { return 0.02 * (1.0 - y * y / 2.25); }).planes(), 1U)
        << seed;
    EXPECT_EQ(Wall(seed, [](double y, double z) { return 0.01 * std::sin(3.0 * y + z); }).planes(),
              1U)
        << seed;
    EXPECT_EQ(Wall(seed,
                   [](double y, double z) {
                     const double r = std::min(1.0, std::hypot(y, z) / 0.5);
                     return 0.015 * (1.0 + std::cos(3.14159265 * r));
                   })
                  .planes(),
              1U)
        << seed;
  }
}

}  // namespace
}  // namespace scanchor
