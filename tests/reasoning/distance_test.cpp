#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {
namespace {

Footprint foot(double x, double y, double half_a, double half_b, double yaw) {
  Footprint f;
  f.center = {x, y};
  f.u = half_a * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
  f.v = half_b * Eigen::Vector2d(-std::sin(yaw), std::cos(yaw));
  return f;
}

TEST(Distance, OverlapByHand) {
  EXPECT_NEAR(footprint_overlap(foot(0, 0, 1, 1, 0), foot(1, 0, 1, 1, 0)), 0.5, 1e-12);
  EXPECT_NEAR(footprint_overlap(foot(0, 0, 1, 1, 0), foot(0, 0, 0.1, 0.1, 0.3)), 1.0, 1e-12);
  EXPECT_EQ(footprint_overlap(foot(0, 0, 1, 1, 0), foot(5, 0, 1, 1, 0)), 0.0);
}

TEST(Distance, OverlapAgainstSampling) {
  SequentialRandom random(3);
  for (int i = 0; i < 40; ++i) {
    const auto a = foot(0, 0, random.uniform(0.3, 1), random.uniform(0.2, 1), random.uniform(0, 3));
    const auto b = foot(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.3, 1),
                        random.uniform(0.2, 1), random.uniform(0, 3));
    const auto& smaller = a.area() < b.area() ? a : b;
    const auto& larger = a.area() < b.area() ? b : a;
    int in = 0;
    const int n = 120;
    for (int x = 0; x < n; ++x) {
      for (int y = 0; y < n; ++y) {
        const Eigen::Vector2d p = smaller.center + smaller.u * (2.0 * (x + 0.5) / n - 1.0) +
                                  smaller.v * (2.0 * (y + 0.5) / n - 1.0);
        const Eigen::Vector2d d = p - larger.center;
        in += std::abs(d.dot(larger.u)) <= larger.u.squaredNorm() &&
                      std::abs(d.dot(larger.v)) <= larger.v.squaredNorm()
                  ? 1
                  : 0;
      }
    }
    EXPECT_NEAR(footprint_overlap(a, b), in / double(n * n), 0.02);
    EXPECT_NEAR(footprint_overlap(a, b), footprint_overlap(b, a), 1e-9);
  }
}

}  // namespace
}  // namespace scanchor
