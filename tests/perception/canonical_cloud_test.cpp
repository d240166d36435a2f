#include "perception/canonical_cloud.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/random.hpp"

namespace scanchor {
namespace {

std::vector<Eigen::Vector3d> skewed_cloud(std::size_t n, std::uint64_t seed) {
  SequentialRandom random(seed);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = random.uniform(), v = random.uniform();
    points.emplace_back(6.0 * u * u, 3.0 * v * v, 0.5 * random.uniform());
  }
  return points;
}

std::vector<std::uint32_t> all_of(const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::uint32_t> index(points.size());
  std::iota(index.begin(), index.end(), 0U);
  return index;
}

TEST(CanonicalCloud, SpreadBitsInterleaves) {
  EXPECT_EQ(spread_bits(0b1011), 0b001000001001ULL);
  EXPECT_EQ(spread_bits(0xFFFF), 0x249249249249ULL);
}

TEST(CanonicalCloud, SortedAndComplete) {
  const auto points = skewed_cloud(5000, 1);
  const auto cloud = canonical_cloud(points, all_of(points));
  ASSERT_EQ(cloud.size(), points.size());
  EXPECT_TRUE(std::is_sorted(cloud.code.begin(), cloud.code.end()));
  std::vector<bool> seen(points.size(), false);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto s = cloud.source[cloud.first[i]];
    EXPECT_FALSE(seen[s]);
    seen[s] = true;
    const Eigen::Vector3d back = cloud.T_cloud_canonical * cloud.point(i).cast<double>();
    EXPECT_LT((back - points[s]).norm(), 2e-6);
  }
}

TEST(CanonicalCloud, SameBytesForAnyOrder) {
  auto points = skewed_cloud(3000, 2);
  const auto one = canonical_cloud(points, all_of(points));
  SequentialRandom random(3);
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random.below(static_cast<std::uint32_t>(i))]);
  }
  const auto two = canonical_cloud(points, all_of(points));
  EXPECT_EQ(one.x, two.x);
  EXPECT_EQ(one.y, two.y);
  EXPECT_EQ(one.z, two.z);
  EXPECT_EQ(one.code, two.code);
}

TEST(CanonicalCloud, FollowsARigidMotion) {
  auto points = skewed_cloud(3000, 4);
  const auto one = canonical_cloud(points, all_of(points));
  const Eigen::Isometry3d motion(Eigen::Translation3d(1e5, -2e5, 50) *
                                 Eigen::AngleAxisd(1.1, Eigen::Vector3d(3, -1, 2).normalized()));
  for (auto& p : points) p = motion * p;
  const auto two = canonical_cloud(points, all_of(points));
  // By source, since points on a border between cells may change places.
  std::vector<Eigen::Vector3f> place(points.size());
  for (std::size_t i = 0; i < one.size(); ++i) place[one.source[one.first[i]]] = one.point(i);
  double worst = 0.0;
  for (std::size_t i = 0; i < two.size(); ++i) {
    worst = std::max<double>(worst, (place[two.source[two.first[i]]] - two.point(i)).norm());
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(CanonicalCloud, EqualPointsAreKeptOnce) {
  auto points = skewed_cloud(100, 5);
  for (int i = 0; i < 3000; ++i) points.push_back(points[17]);
  const auto cloud = canonical_cloud(points, all_of(points));
  EXPECT_EQ(cloud.size(), 100U);
  EXPECT_EQ(cloud.source.size(), points.size());
  std::uint32_t most = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    most = std::max(most, cloud.first[i + 1] - cloud.first[i]);
  EXPECT_EQ(most, 3001U);
}

TEST(CanonicalCloud, NoPointsOnePointAndALine) {
  EXPECT_EQ(canonical_cloud({}, {}).size(), 0U);
  EXPECT_EQ(canonical_cloud({{1, 2, 3}}, {0}).size(), 1U);
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 100; ++i) line.emplace_back(0.1 * i, 0.0, 0.0);
  EXPECT_EQ(canonical_cloud(line, all_of(line)).size(), 100U);
}

}  // namespace
}  // namespace scanchor
