#include "perception/paper_planes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

#include "core/random.hpp"
#include "perception/moments.hpp"

namespace scanchor {
namespace {

// The corner of a room, a metre each way, and nothing else.
std::vector<Eigen::Vector3d> corner(double sigma) {
  SequentialRandom random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 3000; ++i) {
    const double u = random.uniform(0.02, 1.0), v = random.uniform(0.02, 1.0),
                 w = sigma * random.normal();
    points.push_back(i % 3 == 0   ? Eigen::Vector3d(u, v, w)
                     : i % 3 == 1 ? Eigen::Vector3d(u, w, v)
                                  : Eigen::Vector3d(w, u, v));
  }
  return points;
}

std::vector<std::int32_t> regions_of(const std::vector<Eigen::Vector3d>& points, double sigma,
                                     const PaperOptions& options) {
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  const auto cloud = canonical_cloud(points, all);
  const auto region = paper_planes(cloud, sigma, options);
  std::vector<std::int32_t> by_source(points.size(), -1);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    by_source[cloud.source[cloud.first[i]]] = region[i];
  return by_source;
}

TEST(PaperPlanes, ThreeWallsOfACorner) {
  const auto region = regions_of(corner(0.002), 0.002, {});
  std::map<std::pair<int, std::int32_t>, int> count;
  for (std::size_t i = 0; i < region.size(); ++i) ++count[{static_cast<int>(i % 3), region[i]}];
  std::set<std::int32_t> best;
  for (int wall = 0; wall < 3; ++wall) {
    int most = 0;
    std::int32_t id = -1;
    for (const auto& [key, n] : count) {
      if (key.first == wall && n > most) most = n, id = key.second;
    }
    EXPECT_GT(most, 900) << wall;
    EXPECT_GE(id, 0);
    best.insert(id);
  }
  EXPECT_EQ(best.size(), 3U);
}

// Algorithm 1, line 6: every point of a region lies within gamma of it and the error stays below
// delta.
TEST(PaperPlanes, RegionsKeepTheirBounds) {
  const auto points = corner(0.01);
  const PaperOptions options;
  const auto region = regions_of(points, 0.01, options);
  std::map<std::int32_t, Moments> moments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (region[i] >= 0) moments[region[i]].add(points[i].x(), points[i].y(), points[i].z());
  }
  ASSERT_FALSE(moments.empty());
  for (const auto& [id, sum] : moments) {
    EXPECT_GE(sum.n, static_cast<double>(options.minimum));
    EXPECT_LT(fit_plane(sum).variances[0], options.delta * 1e-4 * 1.0001);
  }
}

TEST(PaperPlanes, SeedsAreDrawnFromTheSeed) {
  const auto points = corner(0.01);
  PaperOptions other;
  other.seed = 2;
  EXPECT_EQ(regions_of(points, 0.01, {}), regions_of(points, 0.01, {}));
  EXPECT_NE(regions_of(points, 0.01, {}), regions_of(points, 0.01, other));
}

TEST(PaperPlanes, FewPointsAreNoPlane) {
  EXPECT_EQ(regions_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, 0.01, {}),
            std::vector<std::int32_t>(4, -1));
  EXPECT_TRUE(regions_of({}, 0.01, {}).empty());
}

}  // namespace
}  // namespace scanchor
