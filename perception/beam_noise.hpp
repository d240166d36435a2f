#pragma once
// Noise of a range sensor lies along its beams: across a surface seen at a grazing angle there is
// little of it, and a thing that stands out from such a surface by less than the noise can still be
// told from it.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "perception/moments.hpp"

namespace scanchor {

/// Standard deviation of points along the beam, and across planes where the sensor's place is
/// known. Converts from a number: noise across any plane, sensor unknown.
struct BeamNoise {
  /// Least cosine of incidence that is believed (81 degrees): beyond it the roughness of real
  /// surfaces and errors of the angles decide, which range noise says nothing about.
  static constexpr double grazing = 0.15;

  /// Least cosine at which a surface can be met at all: the points of one line of the sweep lie in
  /// a plane with the sensor, and that plane is no surface (they show 0.01 and less).
  static constexpr double edge_on = 0.02;

  double sigma = 0.0;  ///< [m] along the beam
  bool sensor_known = false;
  Eigen::Vector3d sensor = Eigen::Vector3d::Zero();  ///< [m] in the frame of the planes

  BeamNoise(double s) : sigma(s) {}  // NOLINT: a number is a noise
  BeamNoise(double s, const Eigen::Vector3d& at) : sigma(s), sensor_known(true), sensor(at) {}

  /// True for a plane that the sensor sees as a line.
  [[nodiscard]] bool is_edge_on(const MomentPlane& plane, const Eigen::Vector3d& at) const {
    return sensor_known && std::abs(plane.distance(sensor)) < edge_on * (at - sensor).norm();
  }
  /// [m] across the plane near `at`.
  [[nodiscard]] double across(const MomentPlane& plane, const Eigen::Vector3d& at) const {
    if (!sensor_known) return sigma;
    const double range = (at - sensor).norm();
    return sigma *
           std::clamp(std::abs(plane.distance(sensor)) / std::max(range, 1e-9), grazing, 1.0);
  }
};

}  // namespace scanchor
