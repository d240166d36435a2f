#include "scenes/box_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "scenes/pose.hpp"

namespace scanchor {
namespace {

OrientedBox random_box(SequentialRandom& random, double spread) {
  const Eigen::Quaterniond q(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                             random.uniform(-1, 1));
  return {{random.uniform(-spread, spread), random.uniform(-spread, spread),
           random.uniform(-spread, spread)},
          q.normalized().toRotationMatrix(),
          {random.uniform(0.05, 0.6), random.uniform(0.05, 0.6), random.uniform(0.05, 0.6)}};
}

Eigen::Vector3d nearest(const OrientedBox& box, const Eigen::Vector3d& p) {
  const Eigen::Vector3d local = box.axes.transpose() * (p - box.center);
  return box.center + box.axes * local.cwiseMax(-box.half).cwiseMin(box.half);
}

// Alternating projections between two convex bodies come to the nearest pair (von Neumann), slowly;
// run long enough they are an oracle.
TEST(BoxDistance, AgreesWithLongProjections) {
  SequentialRandom random(5);
  int apart = 0;
  for (int i = 0; i < 400; ++i) {
    const OrientedBox a = random_box(random, 1.0);
    const OrientedBox b = random_box(random, 1.0);
    Eigen::Vector3d p = a.center, q = b.center;
    for (int k = 0; k < 20000; ++k) {
      const Eigen::Vector3d next = nearest(a, q);
      const bool still = (next - p).norm() < 1e-13;
      p = next;
      q = nearest(b, p);
      if (still && k > 10) break;
    }
    const double oracle = (p - q).norm();
    if (oracle < 1e-4) {
      EXPECT_LE(box_distance(a, b), oracle + 1e-9);
      continue;
    }
    ++apart;
    EXPECT_NEAR(box_distance(a, b), oracle, 1e-5);
    EXPECT_NEAR(box_distance(a, b), box_distance(b, a), 1e-9);
  }
  EXPECT_GT(apart, 100);
}

TEST(BoxDistance, TouchingAndNestedBoxesAreAtZero) {
  const OrientedBox unit{{0, 0, 0}, Eigen::Matrix3d::Identity(), {0.5, 0.5, 0.5}};
  OrientedBox other = unit;
  other.half *= 0.2;
  EXPECT_EQ(box_distance(unit, other), 0.0);
  other = unit;
  other.center.x() = 1.0;
  EXPECT_NEAR(box_distance(unit, other), 0.0, 1e-9);
  other.center.x() = 1.25;
  EXPECT_NEAR(box_distance(unit, other), 0.25, 1e-12);
}

}  // namespace
}  // namespace scanchor
