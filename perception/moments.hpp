#pragma once
// Sums of points up to second order: enough to fit a plane and to tell the mean square error of any
// plane, without the points.

#include <Eigen/Core>
#include <cstddef>

namespace scanchor {

/// Number, sum and sum of products of points. Two of them add; that is what makes growing cheap.
struct Moments {
  double n = 0.0;
  double x = 0.0, y = 0.0, z = 0.0;
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  void add(double px, double py, double pz) {
    n += 1.0;
    x += px;
    y += py;
    z += pz;
    xx += px * px;
    xy += px * py;
    xz += px * pz;
    yy += py * py;
    yz += py * pz;
    zz += pz * pz;
  }
  void add(const Moments& other) {
    n += other.n;
    x += other.x;
    y += other.y;
    z += other.z;
    xx += other.xx;
    xy += other.xy;
    xz += other.xz;
    yy += other.yy;
    yz += other.yz;
    zz += other.zz;
  }
  /// Takes `other` off; the precondition is that it was added before.
  void remove(const Moments& other) {
    n -= other.n;
    x -= other.x;
    y -= other.y;
    z -= other.z;
    xx -= other.xx;
    xy -= other.xy;
    xz -= other.xz;
    yy -= other.yy;
    yz -= other.yz;
    zz -= other.zz;
  }
  /// Mean position; n > 0.
  [[nodiscard]] Eigen::Vector3d mean() const { return Eigen::Vector3d(x, y, z) / n; }
  /// Covariance with divisor n; n > 0.
  [[nodiscard]] Eigen::Matrix3d covariance() const;
};

/// Best plane of some moments: the direction of least variance, and the variances along the three
/// principal axes.
struct MomentPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();    ///< unit; its sign has no meaning
  double offset = 0.0;                                  ///< normal . x = offset
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();  ///< [m2] rising, never negative, divisor n
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();   ///< columns in the order of `variances`

  /// Signed distance of a point.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const {
    return normal.dot(point) - offset;
  }
  /// Mean square distance to this plane of the points behind `moments`.
  [[nodiscard]] double mean_square(const Moments& moments) const;
};

/// Least-squares plane; n >= 1. Accurate to rounding (iterative solver): for planes that are handed
/// on.
MomentPlane fit_plane(const Moments& moments);
/// The same by a closed formula, some times faster, exact to about 1e-7 of the largest spread: for
/// decisions inside loops.
MomentPlane fit_plane_fast(const Moments& moments);
/// Its `variances` alone, to the last bit, in half the time.
Eigen::Vector3d plane_variances_fast(const Moments& moments);

}  // namespace scanchor
