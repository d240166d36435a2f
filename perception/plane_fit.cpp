#include "perception/plane_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "perception/moments.hpp"

namespace scanchor {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

MomentPlane local_plane(const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std::uint32_t>& inliers, Eigen::Vector3d& mean) {
  assert(!inliers.empty());
  // Twice: the second pass sums about the mean, so that nothing cancels on long, thin, exactly flat patches.
  const Eigen::Vector3d first = points[inliers[0]];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto i : inliers) sum += points[i] - first;
  mean = first + sum / static_cast<double>(inliers.size());
  Moments moments;
  for (const auto i : inliers) {
    const Eigen::Vector3d d = points[i] - mean;
    moments.add(d.x(), d.y(), d.z());
  }
  return fit_plane(moments);
}

bool faces_away(const Eigen::Vector3d& normal, const Eigen::Vector3d& centroid,
                const std::vector<Eigen::Vector3d>& sensors) {
  if (sensors.empty()) {
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal[largest] < 0.0;
  }
  const auto nearest = std::min_element(sensors.begin(), sensors.end(), [&](const auto& a, const auto& b) {
    return (a - centroid).squaredNorm() < (b - centroid).squaredNorm();
  });
  return normal.dot(*nearest - centroid) < 0.0;
}

}  // namespace

Plane fit_plane(const std::vector<Eigen::Vector3d>& points, const std::vector<std::uint32_t>& inliers,
                const std::vector<Eigen::Vector3d>& sensors, double noise_floor) {
  Plane plane;
  const MomentPlane fit = local_plane(points, inliers, plane.centroid);
  const double n = static_cast<double>(inliers.size());
  const double unbiased = n > 3.0 ? n / (n - 3.0) : n;
  const double variance = std::max(fit.variances[0] * unbiased, noise_floor * noise_floor);
  plane.normal = faces_away(fit.normal, plane.centroid, sensors) ? Eigen::Vector3d(-fit.normal) : fit.normal;
  plane.offset = plane.normal.dot(plane.centroid);
  plane.residual_sigma = std::sqrt(variance);
  plane.centroid_sigma = std::sqrt(variance / n);
  for (int axis = 1; axis <= 2; ++axis) {
    // Points on a line leave the tilt about that line open: a quarter turn is all that can be said.
    const double tilt = std::min(variance / (n * std::max(fit.variances[axis], 1e-30)), 2.4674);
    plane.normal_covariance += tilt * fit.axes.col(axis) * fit.axes.col(axis).transpose();
  }
  return plane;
}

Eigen::Isometry3d surface_frame(const Plane& plane, const std::vector<Eigen::Vector3d>& points,
                                const std::vector<std::uint32_t>& inliers) {
  Eigen::Vector3d mean;
  const MomentPlane fit = local_plane(points, inliers, mean);
  Eigen::Vector3d x = fit.axes.col(2) - plane.normal * plane.normal.dot(fit.axes.col(2));
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

double plane_confidence(const Plane& plane, const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std::uint32_t>& inliers, double noise_floor) {
  const double n = static_cast<double>(inliers.size());
  if (n < 8.0) return n / 16.0;  // six numbers are fitted below: with fewer points nothing can be said
  const Eigen::Vector3d x = plane.normal.unitOrthogonal();
  const Eigen::Vector3d y = plane.normal.cross(x);
  double extent2 = 1e-300;
  for (const auto i : inliers) extent2 = std::max(extent2, (points[i] - plane.centroid).squaredNorm());
  const double scale = 1.0 / std::sqrt(extent2);
  Matrix6d normal_matrix = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  double total = 0.0;
  for (const auto i : inliers) {
    const Eigen::Vector3d d = points[i] - plane.centroid;
    const double u = scale * x.dot(d), v = scale * y.dot(d), w = plane.normal.dot(d);
    Vector6d row;
    row << 1.0, u, v, u * u, u * v, v * v;
    normal_matrix.selfadjointView<Eigen::Lower>().rankUpdate(row);
    right += w * row;
    total += w * w;
  }
  normal_matrix = normal_matrix.selfadjointView<Eigen::Lower>();
  const Vector6d solution = normal_matrix.ldlt().solve(right);
  const double explained = std::clamp(solution.dot(right), 0.0, total);
  const double floor2 = std::max(noise_floor * noise_floor, 1e-18);
  const double left = std::max((total - explained) / std::max(n - 6.0, 1.0), floor2);
  // Noise alone explains 3 of n degrees of freedom, with a standard deviation of sqrt(6): chi-square.
  const double bend = std::max(0.0, explained / n - left * (3.0 + 2.0 * std::sqrt(6.0)) / n);
  const double ratio = bend / (0.16 * left);
  return 1.0 / (1.0 + ratio * ratio);
}

}  // namespace scanchor
