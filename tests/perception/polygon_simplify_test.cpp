#include "perception/polygon_simplify.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace scanchor {
namespace {

/// A 2 m x 1 m rectangle with a vertex every centimetre, off by up to `error` across the edge.
RoughRing wavering(double error, std::uint64_t seed) {
  SequentialRandom random(seed);
  RoughRing ring;
  const Ring corners = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  for (std::size_t c = 0; c < 4; ++c) {
    const Eigen::Vector2d d = corners[(c + 1) % 4] - corners[c];
    const Eigen::Vector2d u = d.normalized();
    for (double t = 0.01; t < d.norm() - 0.005; t += 0.01) {
      ring.points.emplace_back(corners[c] + t * u +
                               random.uniform(-error, error) * Eigen::Vector2d(-u.y(), u.x()));
      ring.tolerance.push_back(2.0 * error);
    }
  }
  return ring;
}

TEST(Simplify, FindsTheFourCornersAndStraightenBringsThemHome) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const RoughRing rough = wavering(0.01, seed);
    const auto kept = simplify(rough);
    EXPECT_LE(kept.size(), 8U) << "the cut corners may take two vertices each";
    EXPECT_GE(kept.size(), 4U);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    const Ring ring = straighten(rough, kept);
    EXPECT_NEAR(ring_area(ring), 2.0, 0.01) << "raw ring: 1 cm of waver on 6 m";
  }
}

TEST(Simplify, EveryVertexThatWentIsWithinItsTolerance) {
  SequentialRandom random(4);
  RoughRing ring;
  for (int i = 0; i < 200; ++i) {
    const double a = 2.0 * 3.14159265358979 * i / 200.0;
    ring.points.emplace_back((1.0 + 0.1 * random.uniform()) * std::cos(a),
                             (1.0 + 0.1 * random.uniform()) * std::sin(a));
    ring.tolerance.push_back(i < 100 ? 0.02 : 0.2);
  }
  const auto kept = simplify(ring);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto from = kept[k];
    const auto to = kept[(k + 1) % kept.size()];
    const Eigen::Vector2d a = ring.points[from];
    const Eigen::Vector2d d = ring.points[to] - a;
    for (std::uint32_t i = (from + 1) % 200; i != to; i = (i + 1) % 200) {
      const double t = std::clamp((ring.points[i] - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      EXPECT_LE((ring.points[i] - a - t * d).norm(), ring.tolerance[i]);
    }
  }
  const auto fine =
      std::count_if(kept.begin(), kept.end(), [](std::uint32_t i) { return i < 100; });
  EXPECT_GT(fine, 2 * (static_cast<std::ptrdiff_t>(kept.size()) - fine))
      << "the tight half needs more vertices";
}

TEST(Simplify, SmallRingsKeepThreeCorners) {
  EXPECT_EQ(simplify({{{0, 0}, {1, 0}, {0, 1}}, {9, 9, 9}}).size(), 3U);
  EXPECT_EQ(
      simplify({{{0, 0}, {1, 0.001}, {2, 0}, {3, 0.002}, {4, 0}, {2, -0.001}}, {9, 9, 9, 9, 9, 9}})
          .size(),
      3U);
}

}  // namespace
}  // namespace scanchor
