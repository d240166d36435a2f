#include "sensors/footprint.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

LidarOptions lms_1xx(int subrays, const char* profile) {
  LidarOptions o = lidar_preset("lms-1xx");
  o.subrays = subrays;
  o.profile = profile;
  return o;
}

TEST(BeamFootprint, DiameterAndSpreadOfTheSickManual) {
  const LidarOptions o = lms_1xx(31, "uniform");
  EXPECT_NEAR(footprint_diameter(o, 4.0), 0.068, 1e-12);
  EXPECT_NEAR(footprint_spread(o, 4.0, std::cos(radians(60.0))), 0.029, 0.0005);
  EXPECT_EQ(footprint_spread(o, 4.0, 1.0), 0.0);
}

TEST(BeamFootprint, RangesOnATiltedPlaneSpreadByDOverFourTanA) {
  for (const char* profile : {"uniform", "gaussian"}) {
    const LidarOptions o = lms_1xx(2000, profile);
    const BeamFootprint footprint(o, 1);
    const Eigen::Vector3d origin(0, 0, 0), direction(1, 0, 0);
    const double a = radians(45.0);
    const Eigen::Vector3d normal(-std::cos(a), std::sin(a), 0);
    const double offset = normal.dot(4.0 * direction);
    const auto axes = footprint.axes(direction, 7, 9);
    double sum = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < footprint.size(); ++i) {
      const Ray ray = footprint.subray(origin, direction, axes, i);
      const double range = (offset - normal.dot(ray.origin)) / normal.dot(ray.direction);
      sum += range;
      squares += (range - 4.0) * (range - 4.0);
    }
    const double n = static_cast<double>(footprint.size());
    const double spread = std::sqrt(squares / n - std::pow(sum / n - 4.0, 2));
    EXPECT_NEAR(spread, footprint_spread(o, 4.0, std::cos(a)), 0.01 * spread) << profile;
  }
}

TEST(BeamFootprint, EqualEnergyInsideEveryRadius) {
  const BeamFootprint disc(lms_1xx(1000, "uniform"), 1);
  const BeamFootprint gauss(lms_1xx(1000, "gaussian"), 1);
  for (const double radius : {0.2, 0.5, 0.8}) {
    const auto inside = [&](const BeamFootprint& f) {
      int count = 0;
      for (const auto& p : f.points()) count += std::hypot(p.u, p.v) < radius ? 1 : 0;
      return count / 1000.0;
    };
    EXPECT_NEAR(inside(disc), radius * radius, 0.002);
    EXPECT_NEAR(inside(gauss), 1.0 - std::exp(-2.0 * radius * radius), 0.002);
  }
  EXPECT_LE(disc.reach(), 1.0);
}

TEST(BeamFootprint, OneRayIsTheMiddle) {
  LidarOptions o = lms_1xx(1, "uniform");
  const BeamFootprint footprint(o, 1);
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, 3).normalized();
  const Ray ray = footprint.subray({1, 1, 1}, direction, footprint.axes(direction, 0, 0), 0);
  EXPECT_EQ(ray.origin, Eigen::Vector3d(1, 1, 1));
  EXPECT_LT((ray.direction - direction).norm(), 1e-15);
}

TEST(BeamFootprint, EachBeamTurnsThePattern) {
  const BeamFootprint footprint(lms_1xx(7, "uniform"), 1);
  const auto a = footprint.axes({1, 0, 0}, 0, 0), b = footprint.axes({1, 0, 0}, 0, 1);
  EXPECT_GT((a.u - b.u).norm(), 1e-3);
  for (const auto& d : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.6, 0, 0.8)}) {
    const auto axes = footprint.axes(d, 3, 4);
    EXPECT_NEAR(axes.u.dot(axes.v), 0.0, 1e-15);
    EXPECT_NEAR(axes.u.dot(d), 0.0, 1e-15);
    EXPECT_NEAR(axes.v.norm(), 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace scanchor
