#include "perception/plane_fit.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

struct Patch {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> all;
};

// A rectangle in the plane z = 0, noise across it, then moved.
Patch noisy_rectangle(SequentialRandom& random, std::size_t n, double length, double width,
                      double sigma, const Eigen::Isometry3d& pose) {
  Patch patch;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = length * random.uniform(-0.5, 0.5), y = width * random.uniform(-0.5, 0.5);
    patch.points.push_back(pose * Eigen::Vector3d(x, y, sigma * random.normal()));
  }
  patch.all.resize(n);
  std::iota(patch.all.begin(), patch.all.end(), 0U);
  return patch;
}

// The claim of reasoning.md 2.2: the true normal lies inside the 95 % ellipse of the covariance,
// and the true offset within 1.96 sigma, in 95 % of the fits. 2000 fits: the standard error is 0.5
// %.
TEST(PlaneFit, CovarianceCoversTheTruth) {
  SequentialRandom random(3);
  const Eigen::Isometry3d pose(Eigen::Translation3d(3, 1, 2) *
                               Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const Eigen::Vector3d truth = pose.linear().col(2);
  for (const auto& [n, sigma] : {std::pair<std::size_t, double>{500, 0.01}, {60, 0.03}}) {
    int normal_in = 0, offset_in = 0;
    const int fits = 2000;
    for (int k = 0; k < fits; ++k) {
      const Patch patch = noisy_rectangle(random, n, 0.52, 0.32, sigma, pose);
      const Plane plane = fit_plane(patch.points, patch.all, {pose.translation() + 5.0 * truth});
      ASSERT_GT(plane.normal.dot(truth), 0.0);  // towards the sensor
      // The error in the tangent plane, measured in the covariance's own axes.
      const Eigen::Vector3d x = plane.normal.unitOrthogonal(), y = plane.normal.cross(x);
      Eigen::Matrix<double, 3, 2> tangent;
      tangent << x, y;
      const Eigen::Vector2d error = tangent.transpose() * (truth - plane.normal);
      const Eigen::Matrix2d covariance = tangent.transpose() * plane.normal_covariance * tangent;
      normal_in +=
          error.dot(covariance.inverse() * error) < 5.991;  // chi-square, 2 degrees of freedom
      const double off = truth.dot(plane.centroid - pose.translation());
      offset_in += std::abs(off) < 1.96 * plane.centroid_sigma;
    }
    EXPECT_NEAR(normal_in / static_cast<double>(fits), 0.95, 0.025) << n;
    EXPECT_NEAR(offset_in / static_cast<double>(fits), 0.95, 0.02) << n;
  }
}

// A strip 2 cm wide in front of a scanner, its points moved along the beams by 1 cm: across itself
// it scatters by 6 mm, along the beam by 10.
TEST(PlaneFit, AStripNarrowerThanTheNoiseFacesItsSensor) {
  SequentialRandom random(5);
  const Eigen::Vector3d truth(-std::cos(0.35), std::sin(0.35), 0.0);  // 20 degrees off the beam
  const Eigen::Vector3d across(std::sin(0.35), std::cos(0.35), 0.0);
  int normal_in = 0;
  double turned = 0.0;
  const int fits = 1000;
  for (int k = 0; k < fits; ++k) {
    Moments moments;
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d p = Eigen::Vector3d(1.5, 0, 0) + random.uniform(-0.01, 0.01) * across +
                                random.uniform(-0.2, 0.2) * Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d q = p + 0.01 * random.normal() * p.normalized();
      moments.add(q.x(), q.y(), q.z());
    }
    const Eigen::Vector3d beam = moments.mean().normalized();
    const Plane plane =
        plane_from_moments(moments, fit_plane_along(moments, beam), Eigen::Vector3d::Zero(),
                           {Eigen::Vector3d::Zero()}, 0.0, beam);
    const Plane squares = plane_from_moments(moments, fit_plane(moments), Eigen::Vector3d::Zero(),
                                             {Eigen::Vector3d::Zero()}, 0.0);
    EXPECT_LT(std::abs(squares.normal.dot(truth)), 0.8) << "least squares take its side for it";
    const double angle = std::atan2(plane.normal.cross(truth).z(), plane.normal.dot(truth));
    turned += angle / fits;
    const double sigma =
        std::sqrt(across.dot(plane.normal_covariance * across)) / std::abs(across.dot(across));
    normal_in += std::abs(angle) < 1.96 * sigma;
  }
  EXPECT_NEAR(turned, 0.0, 0.03);
  EXPECT_GT(normal_in, 0.9 * fits);
}

TEST(PlaneFit, FarFromTheOriginNothingIsLost) {
  SequentialRandom random(4);
  Patch near = noisy_rectangle(random, 400, 1.0, 0.5, 0.005, Eigen::Isometry3d::Identity());
  const Plane here = fit_plane(near.points, near.all, {});
  const Eigen::Vector3d shift(500000.0, 4649776.0, 1000000.0);
  for (auto& p : near.points) p += shift;
  const Plane there = fit_plane(near.points, near.all, {});
  EXPECT_NEAR((here.normal - there.normal).norm(), 0.0, 1e-7);
  EXPECT_NEAR(here.residual_sigma, there.residual_sigma, 1e-8);
  EXPECT_NEAR((there.centroid - shift - here.centroid).norm(), 0.0, 1e-7);
}

TEST(PlaneFit, PointsOnALineLeaveTheTiltOpen) {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < 30; ++i) {
    points.emplace_back(0.01 * i, 0.0, 0.0);
    all.push_back(i);
  }
  const Plane plane = fit_plane(points, all, {}, 0.001);
  EXPECT_GT(plane.normal_covariance.trace(), 1.0);  // about a quarter turn, squared
  EXPECT_TRUE(plane.normal_covariance.allFinite());
}

TEST(PlaneFit, FrameIsRightHandedOnThePlane) {
  SequentialRandom random(5);
  const Eigen::Isometry3d pose(Eigen::Translation3d(1, 2, 3) *
                               Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX()));
  const Patch patch = noisy_rectangle(random, 300, 1.2, 0.4, 0.002, pose);
  const Plane plane = fit_plane(patch.points, patch.all, {Eigen::Vector3d(1, 2, 30)});
  const Eigen::Isometry3d frame = surface_frame(plane, Eigen::Vector3d(-1.0, 0.1, 0.0));
  EXPECT_NEAR(frame.linear().determinant(), 1.0, 1e-9);
  EXPECT_NEAR((frame.linear().col(2) - plane.normal).norm(), 0.0, 1e-12);
  EXPECT_GT(frame.linear().col(0).x(),
            0.99);  // along the axis it was given, largest component positive
}

// Distances from a plane, over a square patch: noise, and a bend onto a ball.
double confidence_of(double radius, double sigma, int n) {
  SequentialRandom random(6);
  BendTest test;
  std::vector<Eigen::Vector3d> points;
  double mean = 0.0;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform(-0.1, 0.1), v = random.uniform(-0.1, 0.1);
    const double bend = radius > 0.0 ? radius - std::sqrt(radius * radius - u * u - v * v) : 0.0;
    points.emplace_back(u, v, bend + sigma * random.normal());
    mean += points.back().z() / n;
  }
  for (const auto& p : points) test.add(p.x(), p.y(), p.z() - mean);
  return test.confidence(1e-5);
}

TEST(PlaneFit, ConfidenceFallsWithCurvature) {
  EXPECT_GT(confidence_of(0.0, 0.01, 300), 0.9);
  EXPECT_GT(confidence_of(0.0, 0.0, 300), 0.9);
  EXPECT_GT(confidence_of(20.0, 0.01, 3000), 0.9);  // a wall bowed by half a millimetre
  EXPECT_LT(confidence_of(0.2, 0.01, 300), 0.5);
  EXPECT_LT(confidence_of(0.2, 0.001, 300), 0.01);
  EXPECT_LE(confidence_of(0.0, 0.01, 7), 0.5);  // too few to say
}

}  // namespace
}  // namespace scanchor
