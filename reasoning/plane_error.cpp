#include "reasoning/plane_error.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "reasoning/relation_model.hpp"

namespace scanchor {
namespace {

constexpr double quarter_turn2 = 2.4674;  // [rad2] nothing is known any more
constexpr double least_variance = 1e-12;  // [m2] of exact points

/// Variance of the inliers along an axis of the plane, from the tilt that the fit says for it:
/// tilt = variance spread / (n (spread - across)^2).
double spread_of(double tilt, double variance, double across, double n) {
  const double q = tilt * n / variance;
  return ((2.0 * q * across + 1.0) + std::sqrt(4.0 * q * across + 1.0)) / (2.0 * q);
}

struct Tilt {
  Eigen::Matrix3d covariance;
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();  // [rad] of the fit that was made
  double excess = 1.0;                             // noise found over the noise of the sensor
};

/// Noise lies along the beams. Least squares across the plane turn a narrow strip towards the
/// beam, since that is where the points scatter least; least squares along the beam do not. Both
/// follow from the second moments, which are read back from the covariance of the fit.
Tilt along_beam(const Plane& plane, double n, double noise, const Eigen::Vector3d& beam) {
  Tilt tilt{plane.normal_covariance};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(plane.normal_covariance);
  const double variance = std::max(plane.residual_sigma * plane.residual_sigma, least_variance);
  const double across = n > 3.0 ? variance * (n - 3.0) / n : variance;
  Eigen::Matrix3d moments = across * plane.normal * plane.normal.transpose();
  Eigen::Vector3d toward = plane.normal * plane.normal.dot(beam);  // moments^-1 beam x across
  for (int k = 1; k < 3; ++k) {
    const Eigen::Vector3d axis = axes.eigenvectors().col(k);
    if (axes.eigenvalues()[k] <= 0.0) return tilt;
    const double spread = spread_of(axes.eigenvalues()[k], variance, across, n);
    moments += spread * axis * axis.transpose();
    toward += axis * (axis.dot(beam) * across / spread);
  }
  if (toward.dot(beam) < 1e-9 * toward.norm()) return tilt;  // seen edge on
  const double along = across / toward.dot(beam);  // variance of the points along the beam
  Eigen::Vector3d normal = toward.normalized();
  if (normal.dot(plane.normal) < 0.0) normal = -normal;
  const double used = std::max(n > 3.0 ? along * n / (n - 3.0) : along, noise * noise);
  if (noise > 0.0) tilt.excess = std::max(1.0, std::sqrt(along) / noise);
  // Covariance of the two slopes of range over the directions across the beam, carried over to the
  // normal.
  const Eigen::Matrix3d off_beam = Eigen::Matrix3d::Identity() - beam * beam.transpose();
  const Eigen::Matrix3d flat = off_beam * moments * off_beam + beam * beam.transpose();
  const Eigen::Matrix3d slopes = off_beam * flat.inverse() * off_beam * (used / n);
  const Eigen::Matrix3d carry =
      (Eigen::Matrix3d::Identity() - normal * normal.transpose()) * std::abs(beam.dot(normal));
  tilt.covariance = carry * slopes * carry.transpose();
  const Eigen::Vector3d turn = normal - plane.normal * plane.normal.dot(normal);
  const double angle = std::atan2(turn.norm(), normal.dot(plane.normal));
  if (angle > 0.0) tilt.bias = turn.normalized() * angle;
  return tilt;
}

}  // namespace

Eigen::Matrix3d plane_error(const Surface& surface, const Surfaces& surfaces,
                            const RelationModel& model) {
  const Plane& plane = surface.plane;
  const double n = static_cast<double>(surface.inlier_count);
  if (n < 4.0 || plane.normal_covariance.trace() <= 0.0) return plane.normal_covariance;
  Tilt tilt{plane.normal_covariance};
  // Of several sensors it is not known which saw which point.
  if (surfaces.sensor_positions.size() == 1) {
    const Eigen::Vector3d beam = plane.centroid - surfaces.sensor_positions.front();
    if (beam.norm() > 1e-3) tilt = along_beam(plane, n, surfaces.noise_sigma, beam.normalized());
  }
  // Points of what lies next to it come in by the noise, and turn it by as much as noise may over
  // its extent; many points do not help. More scatter than noise, or a bend, says that they did.
  const double doubt = (2.0 - std::clamp(surface.confidence, 0.0, 1.0)) *
                       std::pow(tilt.excess, model.tilt_excess_power);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(tilt.covariance);
  Eigen::Matrix3d error = tilt.bias * tilt.bias.transpose();
  for (int k = 1; k < 3; ++k) {
    const double fit = std::max(0.0, axes.eigenvalues()[k]);
    const double chosen = model.tilt_of_points * std::min(1.0, fit * n);
    const double own =
        doubt * doubt * (model.tilt_scale * model.tilt_scale * fit + chosen * chosen);
    const Eigen::Vector3d axis = axes.eigenvectors().col(k);
    error += std::min(own, quarter_turn2) * axis * axis.transpose();
  }
  const Eigen::Matrix3d flat =
      Eigen::Matrix3d::Identity() - plane.normal * plane.normal.transpose();
  return flat * error * flat;
}

}  // namespace scanchor
