#include "perception/height_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/random.hpp"

namespace scanchor {
namespace {

// A step of 2 cm in a plane: the map shows it in means of eight points, and its weights are the
// points over the noise.
TEST(HeightMap, MeansOfSquaresShowAStep) {
  SequentialRandom random(4);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8000; ++i) {
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-0.7, 0.7);
    points.emplace_back(x, y, (x > 0.3 ? 0.02 : 0.0) + 0.01 * random.normal());
  }
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto cloud = canonical_cloud(points, all);
  Moments moments;
  for (std::size_t i = 0; i < cloud.size(); ++i) moments.add(cloud.x[i], cloud.y[i], cloud.z[i]);
  const GrownPlane grown = grown_plane(moments, 0.01);
  const HeightMap map(cloud, grown, all);
  double weight = 0.0;
  std::size_t filled = 0;
  for (std::size_t i = 0; i < map.weight.size(); ++i) {
    weight += map.weight[i];
    filled += map.weight[i] > 0.0F ? 1 : 0;
    const auto column = i % static_cast<std::size_t>(map.columns);
    if (column == 0 || i < static_cast<std::size_t>(map.columns)) {
      EXPECT_EQ(map.weight[i], 0.0F);
    }
  }
  EXPECT_NEAR(weight * grown.sigma * grown.sigma, 8000.0, 8.0);
  EXPECT_NEAR(static_cast<double>(filled), 1000.0, 150.0);
  // Two planes for two sides; in the map's own frame the step is there too.
  Tilt low, high;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const double x = points[cloud.source[cloud.first[i]]].x();
    const auto at = map.square(cloud.point(i));
    EXPECT_TRUE(map.holds(cloud.point(i)));
    if (x < 0.2) low.add(map.place(at), map.weight[at], map.height[at]);
    if (x > 0.4) high.add(map.place(at), map.weight[at], map.height[at]);
  }
  low.fit();
  high.fit();
  Eigen::Vector3f border = Eigen::Vector3f::Zero();
  float count = 0.0F;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (std::abs(points[cloud.source[cloud.first[i]]].x() - 0.3) > 0.05) continue;
    border += cloud.point(i);
    count += 1.0F;
  }
  const auto place = map.place(map.square(border / count));
  EXPECT_NEAR(std::abs(high.at(place) - low.at(place)), 0.02, 0.002);
  EXPECT_FALSE(map.holds(cloud.point(0) + Eigen::Vector3f(9.0F, 9.0F, 9.0F)));
}

TEST(Tilt, WhatWasAddedCanBeTakenOff) {
  SequentialRandom random(8);
  Tilt all, part, other;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d place(1.0, random.uniform(), random.uniform());
    const double height = i < 50 ? 0.3 - 0.2 * place.y() + 0.5 * place.z() : random.normal();
    all.add(place, 2.0, height);
    (i < 50 ? part : other).add(place, 2.0, height);
  }
  all.remove(other);
  all.fit();
  EXPECT_NEAR(all.at({1.0, 0.4, 0.6}), 0.3 - 0.08 + 0.3, 1e-6);
}

}  // namespace
}  // namespace scanchor
