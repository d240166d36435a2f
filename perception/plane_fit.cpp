#include "perception/plane_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "perception/beam_noise.hpp"
#include "perception/bent_planes.hpp"

namespace scanchor {
namespace {

bool faces_away(const Eigen::Vector3d& normal, const Eigen::Vector3d& centroid,
                const std::vector<Eigen::Vector3d>& sensors) {
  if (sensors.empty()) {
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal[largest] < 0.0;
  }
  const auto nearest =
      std::min_element(sensors.begin(), sensors.end(), [&](const auto& a, const auto& b) {
        return (a - centroid).squaredNorm() < (b - centroid).squaredNorm();
      });
  return normal.dot(*nearest - centroid) < 0.0;
}

/// [sigma2] variance along a unit vector of noise along a beam.
double noise_along(const Eigen::Vector3d& direction, const Eigen::Vector3d& beam) {
  const double cosine = direction.dot(beam);
  return cosine * cosine + BeamNoise::grazing * BeamNoise::grazing;
}

}  // namespace

MomentPlane fit_plane_along(const Moments& moments, const Eigen::Vector3d& beam) {
  const Eigen::Matrix3d c = moments.covariance();
  const Eigen::Matrix3d noise = beam * beam.transpose() + BeamNoise::grazing * BeamNoise::grazing *
                                                              Eigen::Matrix3d::Identity();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> solver(c, noise);
  MomentPlane plane;
  plane.normal = solver.eigenvectors().col(0).normalized();
  plane.offset = plane.normal.dot(moments.mean());
  // Principal axes of what the points spread along it.
  const Eigen::Vector3d u = plane.normal.unitOrthogonal();
  const Eigen::Vector3d v = plane.normal.cross(u);
  const double angle = 0.5 * std::atan2(2.0 * u.dot(c * v), u.dot(c * u) - v.dot(c * v));
  plane.axes.col(0) = plane.normal;
  plane.axes.col(2) = std::cos(angle) * u + std::sin(angle) * v;
  plane.axes.col(1) = plane.axes.col(2).cross(plane.normal);
  for (int axis = 0; axis < 3; ++axis)
    plane.variances[axis] = std::max(0.0, plane.axes.col(axis).dot(c * plane.axes.col(axis)));
  return plane;
}

Plane plane_from_moments(const Moments& moments, const MomentPlane& fit,
                         const Eigen::Vector3d& origin, const std::vector<Eigen::Vector3d>& sensors,
                         double noise_floor, const std::optional<Eigen::Vector3d>& beam) {
  Plane plane;
  plane.centroid = origin + moments.mean();
  const double n = moments.n;
  const double unbiased = n > 3.0 ? n / (n - 3.0) : n;
  const double variance = std::max(fit.variances[0] * unbiased, noise_floor * noise_floor);
  plane.normal =
      faces_away(fit.normal, plane.centroid, sensors) ? Eigen::Vector3d(-fit.normal) : fit.normal;
  plane.offset = plane.normal.dot(plane.centroid);
  plane.residual_sigma = std::sqrt(variance);
  plane.centroid_sigma = std::sqrt(variance / n);
  for (int axis = 1; axis <= 2; ++axis) {
    // Points on a line leave the tilt about that line open: a quarter turn is all that can be said.
    // The spread along the plane holds noise too, which says nothing about the tilt (T. W.
    // Anderson, Ann. Math. Statist. 34, 1963).
    const double spread = std::max(fit.variances[axis], 1e-30);
    const double share =
        beam ? noise_along(fit.axes.col(axis), *beam) / noise_along(fit.normal, *beam) : 1.0;
    const double known = std::max(spread - share * fit.variances[0], 1e-30);
    const double tilt = std::min(variance * spread / (n * known * known), 2.4674);
    plane.normal_covariance += tilt * fit.axes.col(axis) * fit.axes.col(axis).transpose();
  }
  return plane;
}

Plane fit_plane(const std::vector<Eigen::Vector3d>& points,
                const std::vector<std::uint32_t>& inliers,
                const std::vector<Eigen::Vector3d>& sensors, double noise_floor) {
  assert(!inliers.empty());
  // Twice: the second pass sums about the mean, so that nothing cancels on long, thin, exactly flat
  // patches.
  const Eigen::Vector3d first = points[inliers[0]];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto i : inliers) sum += points[i] - first;
  const Eigen::Vector3d mean = first + sum / static_cast<double>(inliers.size());
  Moments moments;
  for (const auto i : inliers) {
    const Eigen::Vector3d d = points[i] - mean;
    moments.add(d.x(), d.y(), d.z());
  }
  return plane_from_moments(moments, fit_plane(moments), mean, sensors, noise_floor);
}

Eigen::Isometry3d surface_frame(const Plane& plane, const Eigen::Vector3d& long_axis) {
  Eigen::Vector3d x = long_axis - plane.normal * plane.normal.dot(long_axis);
  x.normalize();
  Eigen::Index largest = 0;
  x.cwiseAbs().maxCoeff(&largest);
  if (x[largest] < 0.0) x = -x;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear().col(0) = x;
  frame.linear().col(1) = plane.normal.cross(x);
  frame.linear().col(2) = plane.normal;
  frame.translation() = plane.centroid;
  return frame;
}

void BendTest::add(double u, double v, double w) {
  n_ += 1.0;
  total_ += w * w;
  double ui = 1.0;
  for (int i = 0; i <= 4; ++i) {
    double uivj = ui;
    for (int j = 0; i + j <= 4; ++j) {
      power_[i][j] += uivj;
      uivj *= v;
    }
    ui *= u;
  }
  const double terms[6] = {1.0, u, v, u * u, u * v, v * v};
  for (int k = 0; k < 6; ++k) right_[k] += w * terms[k];
}

double BendTest::confidence(double noise_floor) const {
  if (n_ < 8.0)
    return n_ / 16.0;  // six numbers are fitted below: with fewer points nothing can be said
  constexpr int order_u[6] = {0, 1, 0, 2, 1, 0}, order_v[6] = {0, 0, 1, 0, 1, 2};
  Eigen::Matrix<double, 6, 6> normal_matrix;
  Eigen::Matrix<double, 6, 1> right, scale;
  for (int k = 0; k < 6; ++k) {
    right[k] = right_[k];
    scale[k] = 1.0 / std::sqrt(std::max(power_[2 * order_u[k]][2 * order_v[k]], 1e-300));
    for (int l = 0; l < 6; ++l)
      normal_matrix(k, l) = power_[order_u[k] + order_u[l]][order_v[k] + order_v[l]];
  }
  normal_matrix = scale.asDiagonal() * normal_matrix * scale.asDiagonal();  // columns of length one
  right = scale.cwiseProduct(right);
  // Into a vector first: the product of the expressions takes the compiler four seconds more.
  const Eigen::Matrix<double, 6, 1> solution = normal_matrix.ldlt().solve(right);
  const double explained = std::clamp(solution.dot(right), 0.0, total_);
  const double floor2 = std::max(noise_floor * noise_floor, 1e-18);
  const double left = std::max((total_ - explained) / std::max(n_ - 6.0, 1.0), floor2);
  // Noise alone explains 3 of n degrees of freedom, with a standard deviation of sqrt(6):
  // chi-square.
  const double bend = std::max(0.0, explained / n_ - left * (3.0 + 2.0 * std::sqrt(6.0)) / n_);
  // What the sensor's own systematic error may do: a sagitta s over [-h, h] has the mean square
  // (0.298 s)^2.
  const double u2 = power_[2][0] / n_, v2 = power_[0][2] / n_;
  const double sagitta =
      std::min(systematic_error, systematic_bend * std::sqrt(3.0 * std::min(u2, v2)));
  const double ratio = bend / (0.16 * left + 0.0888 * sagitta * sagitta);
  return 1.0 / (1.0 + ratio * ratio);
}

}  // namespace scanchor
