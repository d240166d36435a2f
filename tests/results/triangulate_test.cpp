#include "results/triangulate.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

using Ring = std::vector<Eigen::Vector2d>;

double area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto& a = ring[i];
    const auto& b = ring[(i + 1) % ring.size()];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return std::abs(sum) / 2;
}

double area_of_triangles(const std::vector<Ring>& rings) {
  Ring all;
  for (const Ring& ring : rings) all.insert(all.end(), ring.begin(), ring.end());
  double sum = 0;
  for (const Eigen::Vector3i& t : triangulate(rings)) {
    sum += area({all[std::size_t(t[0])], all[std::size_t(t[1])], all[std::size_t(t[2])]});
  }
  return sum;
}

/// A star-shaped ring, so that it cannot cross itself.
Ring star(SequentialRandom& random, const Eigen::Vector2d& center, double least, double most,
          int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const SinCos turn = portable_sincos(2 * pi * i / corners);
    ring.emplace_back(center + random.uniform(least, most) * Eigen::Vector2d(turn.cos, turn.sin));
  }
  return ring;
}

TEST(Triangulate, Square) {
  const auto triangles = triangulate({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  EXPECT_EQ(triangles.size(), 2u);
}

TEST(Triangulate, EitherWayRound) {
  const Ring l = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_NEAR(area_of_triangles({l}), 3.0, 1e-12);
  EXPECT_NEAR(area_of_triangles({{l.rbegin(), l.rend()}}), 3.0, 1e-12);
}

// Property: the triangles' area is the polygon's, holes taken off.
TEST(Triangulate, KeepsTheAreaOfRandomPolygonsWithHoles) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SequentialRandom random(seed);
    std::vector<Ring> rings = {star(random, {0, 0}, 5.0, 9.0, 7 + int(seed))};
    double expected = area(rings[0]);
    for (const Eigen::Vector2d& c :
         {Eigen::Vector2d(-2, -1.5), Eigen::Vector2d(2, 0.5), Eigen::Vector2d(-1, 2.5)}) {
      rings.push_back(star(random, c, 0.3, 1.2, 3 + int(random.below(9))));
      expected -= area(rings.back());
    }
    EXPECT_NEAR(area_of_triangles(rings), expected, 1e-9) << seed;
  }
}

TEST(Triangulate, SurvivesDegenerateRings) {
  EXPECT_TRUE(triangulate({}).empty());
  EXPECT_TRUE(triangulate({{{0, 0}, {1, 1}}}).empty());
  EXPECT_TRUE(triangulate({{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}).empty());
  EXPECT_NO_THROW(triangulate({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}));  // a bow
  EXPECT_NEAR(area_of_triangles({{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}}), 1.0,
              1e-12);  // a corner twice
}

}  // namespace
}  // namespace scanchor
