#include "perception/choose_planes.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/random.hpp"

namespace scanchor {
namespace {

// Floor and wall meet in an edge. Started with a fifth of the points labelled wrongly, they end on
// their own planes.
TEST(ChoosePlanes, MendsLabelsAtAnEdge) {
  SequentialRandom random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 4000; ++i) {
    const double u = random.uniform(), v = random.uniform(), w = 0.01 * random.normal();
    points.push_back(i % 2 == 0 ? Eigen::Vector3d(u, v, w) : Eigen::Vector3d(u, w, v));
  }
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto cloud = canonical_cloud(points, all);
  const auto tree = cell_tree(cloud);
  PlaneLabels nothing;
  nothing.of_point.assign(cloud.size(), -1);
  const auto pool =
      point_pool(cloud, tree, nothing, std::vector<std::int32_t>(tree.cells.size(), -1), 0.01);
  std::vector<std::int32_t> truth, label;
  std::vector<Moments> sums(2);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    truth.push_back(static_cast<std::int32_t>(cloud.source[cloud.first[i]] % 2));
    label.push_back(random.chance(0.2) ? 1 - truth.back() : truth.back());
    sums[static_cast<std::size_t>(truth.back())].add(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  std::vector<GrownPlane> planes = {grown_plane(sums[0], 0.01), grown_plane(sums[1], 0.01)};
  const BeamNoise noise = 0.01;
  std::vector<GrownPlane> planes_apart = planes;
  std::vector<std::int32_t> label_apart = label;
  PlaneChoice(pool, noise).choose(std::vector<Moments>(2), 3, planes, label);
  std::size_t right = 0;
  for (std::size_t i = 0; i < label.size(); ++i) right += label[i] == truth[i];
  EXPECT_GT(right, label.size() * 97 / 100);
  EXPECT_LT(std::abs(planes[0].plane.normal.dot(planes[1].plane.normal)), 0.01);
  EXPECT_NEAR(
      planes[0].moments.n + planes[1].moments.n,
      static_cast<double>(std::count_if(label.begin(), label.end(), [](auto l) { return l >= 0; })),
      1e-9);
  // Votes that are kept from round to round are those that would be counted anew.
  for (int round = 0; round < 3; ++round)
    PlaneChoice(pool, noise).choose(std::vector<Moments>(2), 1, planes_apart, label_apart);
  EXPECT_EQ(label_apart, label);
}

}  // namespace
}  // namespace scanchor
