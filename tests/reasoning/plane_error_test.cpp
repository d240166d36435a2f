#include "reasoning/plane_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"
#include "perception/plane_fit.hpp"
#include "reasoning/relation_model.hpp"

namespace scanchor {
namespace {

const RelationModel usual_tilts;  // whatever was fitted

/// A strip 60 cm high and `width` wide, 3 m from the sensor, turned by `turn` about the vertical,
/// with noise along the beams.
struct Strip {
  Surfaces surfaces;
  Eigen::Vector3d normal;
};

Strip strip(double width, double turn, double noise, std::uint64_t seed) {
  SequentialRandom random(seed);
  Strip made;
  const Eigen::Vector3d across(std::cos(turn), std::sin(turn), 0.0);
  made.normal = across.cross(Eigen::Vector3d::UnitZ());
  std::vector<Eigen::Vector3d> points;
  std::vector<std::uint32_t> all;
  for (std::uint32_t i = 0; i < 80; ++i) {
    const Eigen::Vector3d exact = Eigen::Vector3d(0, 3, 0) +
                                  across * random.uniform(-0.5 * width, 0.5 * width) +
                                  Eigen::Vector3d::UnitZ() * random.uniform(-0.3, 0.3);
    points.push_back(exact + exact.normalized() * (noise * random.normal()));
    all.push_back(i);
  }
  Surface surface;
  surface.plane = fit_plane(points, all, {Eigen::Vector3d::Zero()}, 0.0);
  surface.inlier_count = points.size();
  made.surfaces.surfaces = {surface};
  made.surfaces.sensor_positions = {Eigen::Vector3d::Zero()};
  made.surfaces.noise_sigma = noise;
  return made;
}

double tilt(const Strip& s) {
  const Eigen::Vector3d& n = s.surfaces.surfaces[0].plane.normal;
  return std::atan2(n.cross(s.normal).norm(), std::abs(n.dot(s.normal)));
}

/// Greatest standard deviation.
double said(const Eigen::Matrix3d& covariance) { return std::sqrt(covariance.trace()); }

TEST(PlaneError, CoversWhatNoiseAlongTheBeamsDoesToANarrowStrip) {
  int missed_by_fit = 0, missed = 0;
  constexpr int strips = 200;
  for (int i = 0; i < strips; ++i) {
    const Strip s = strip(0.05, 0.3, 0.02, 100 + static_cast<std::uint64_t>(i));
    const Surface& surface = s.surfaces.surfaces[0];
    if (tilt(s) > 3.0 * said(surface.plane.normal_covariance)) ++missed_by_fit;
    if (tilt(s) > 3.0 * said(plane_error(surface, s.surfaces, usual_tilts))) ++missed;
  }
  // The fit across the plane turns to the beam and is sure of it.
  EXPECT_GT(missed_by_fit, strips / 10);
  EXPECT_LT(missed, strips / 20);
}

TEST(PlaneError, LeavesALargeFaceNearlyAsItWas) {
  const Strip s = strip(2.0, 0.3, 0.01, 7);
  const Surface& surface = s.surfaces.surfaces[0];
  const double fit = said(surface.plane.normal_covariance);
  EXPECT_GT(said(plane_error(surface, s.surfaces, usual_tilts)), fit);
  EXPECT_LT(said(plane_error(surface, s.surfaces, usual_tilts)), 2.0 * fit);
}

TEST(PlaneError, DoubtsWhatIsBentOrScattersMoreThanTheSensor) {
  Strip s = strip(0.4, 0.3, 0.01, 8);
  const double plain = said(plane_error(s.surfaces.surfaces[0], s.surfaces, usual_tilts));
  s.surfaces.surfaces[0].confidence = 0.2;
  EXPECT_GT(said(plane_error(s.surfaces.surfaces[0], s.surfaces, usual_tilts)), 1.5 * plain);
  s.surfaces.surfaces[0].confidence = 1.0;
  s.surfaces.noise_sigma = 0.005;  // half of what the points show
  EXPECT_GT(said(plane_error(s.surfaces.surfaces[0], s.surfaces, usual_tilts)), 3.0 * plain);
}

TEST(PlaneError, TakesAnExactPlaneForExact) {
  Surfaces surfaces;
  Surface surface;
  surface.inlier_count = 100;
  EXPECT_EQ(plane_error(surface, surfaces, usual_tilts), Eigen::Matrix3d::Zero());
}

TEST(PlaneError, LiesAcrossTheNormal) {
  const Strip s = strip(0.05, 0.8, 0.02, 9);
  const Surface& surface = s.surfaces.surfaces[0];
  const Eigen::Matrix3d error = plane_error(surface, s.surfaces, usual_tilts);
  EXPECT_LT((error * surface.plane.normal).norm(), 1e-12);
  EXPECT_LT((error - error.transpose()).norm(), 1e-12);
}

}  // namespace
}  // namespace scanchor
