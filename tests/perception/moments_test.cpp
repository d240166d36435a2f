#include "perception/moments.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace scanchor {
namespace {

TEST(Moments, AddAndRemoveAreInverse) {
  SequentialRandom random(1);
  Moments a, b;
  for (int i = 0; i < 50; ++i) a.add(random.normal(), random.normal(), random.normal());
  for (int i = 0; i < 20; ++i) b.add(random.normal(), random.normal(), random.normal());
  Moments both = a;
  both.add(b);
  EXPECT_EQ(both.n, 70.0);
  both.remove(b);
  EXPECT_NEAR((both.covariance() - a.covariance()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((both.mean() - a.mean()).norm(), 0.0, 1e-12);
}

TEST(Moments, FitFindsAPlaneAndItsSpreads) {
  // z = 0.5 x + 2 on a grid: the normal is (-0.5, 0, 1) / |.|, and nothing scatters.
  Moments moments;
  for (int i = -10; i <= 10; ++i) {
    for (int j = -3; j <= 3; ++j) moments.add(i, j, 0.5 * i + 2.0);
  }
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.5, 0.0, 1.0).normalized();
  for (const auto& plane : {fit_plane(moments), fit_plane_fast(moments)}) {
    EXPECT_NEAR(std::abs(plane.normal.dot(normal)), 1.0, 1e-9);
    EXPECT_NEAR(std::abs(plane.offset), 2.0 * normal.z(), 1e-6);
    EXPECT_LT(plane.variances[0], 1e-6);
    EXPECT_NEAR(plane.variances[1], 4.0, 1e-6);  // mean of j^2, j = -3..3
    EXPECT_NEAR(plane.variances[2], 1.25 * 110.0 / 3.0,
                1e-4);  // mean of i^2 is 110/3, stretched by the slope
  }
}

TEST(Moments, MeanSquareIsThatOfThePoints) {
  SequentialRandom random(2);
  Moments moments;
  MomentPlane plane;
  plane.normal = Eigen::Vector3d(1, 2, -2) / 3.0;
  plane.offset = 0.7;
  double squares = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d p(random.normal(), random.normal(), random.normal());
    moments.add(p.x(), p.y(), p.z());
    squares += plane.distance(p) * plane.distance(p);
  }
  EXPECT_NEAR(plane.mean_square(moments), squares / 100.0, 1e-12);
}

TEST(Moments, VariancesAloneAreTheSameToTheLastBit) {
  SequentialRandom random(77);
  for (int k = 0; k < 200; ++k) {
    Moments moments;
    for (int i = 0; i < 3 + k % 40; ++i)
      moments.add(5.0 + random.normal(), 0.3 * random.normal(), 0.01 * random.normal() - 2.0);
    EXPECT_EQ(plane_variances_fast(moments), fit_plane_fast(moments).variances) << k;
  }
}

}  // namespace
}  // namespace scanchor
