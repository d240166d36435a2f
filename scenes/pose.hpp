#pragma once
// Poses from angles with bits that do not depend on the C library (Eigen's own AngleAxis calls
// libm).

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {

/// Rotation by `angle` [rad] about x (0), y (1) or z (2), right-handed.
inline Eigen::Matrix3d rotation_about(int axis, double angle) {
  const SinCos sc = portable_sincos(angle);
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  rotation(i, i) = sc.cos;
  rotation(j, j) = sc.cos;
  rotation(i, j) = -sc.sin;
  rotation(j, i) = sc.sin;
  return rotation;
}

/// [m] rounded to whole millimetres, as rooms are laid out.
inline double to_mm(double v) { return std::floor(v * 1000.0 + 0.5) / 1000.0; }

/// Pose at a place, turned by yaw [rad] about z.
inline Eigen::Isometry3d pose_at(const Eigen::Vector3d& place, double yaw = 0.0) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (yaw != 0.0) pose.linear() = rotation_about(2, yaw);
  pose.translation() = place;
  return pose;
}

/// Pose at a place with a given rotation.
inline Eigen::Isometry3d pose_at(const Eigen::Vector3d& place, const Eigen::Matrix3d& rotation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation() = place;
  return pose;
}

/// Pose at p0 whose z axis points to p1; the x axis is horizontal where that leaves a choice.
inline Eigen::Isometry3d pose_along(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1) {
  const Eigen::Vector3d z = (p1 - p0).normalized();
  Eigen::Vector3d x = Eigen::Vector3d(-z.y(), z.x(), 0.0);
  x = x.norm() > 1e-9 ? Eigen::Vector3d(x.normalized()) : Eigen::Vector3d(1, 0, 0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear().col(0) = x;
  pose.linear().col(1) = z.cross(x);
  pose.linear().col(2) = z;
  pose.translation() = p0;
  return pose;
}

}  // namespace scanchor
