#include "scenes/box_distance.hpp"

#include <algorithm>
#include <cmath>

namespace scanchor {
namespace {

/// Distance between two segments (Ericson, Real-Time Collision Detection, 2005, section 5.1.9).
double segment_distance(const Eigen::Vector3d& p1, const Eigen::Vector3d& d1,
                        const Eigen::Vector3d& p2, const Eigen::Vector3d& d2) {
  const Eigen::Vector3d r = p1 - p2;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(r);
  const double c = d1.dot(r);
  const double b = d1.dot(d2);
  if (a < 1e-18 || e < 1e-18) {
    const double s = a < 1e-18 ? 0.0 : std::clamp(-c / a, 0.0, 1.0);
    const double t = e < 1e-18 ? 0.0 : std::clamp(f / e, 0.0, 1.0);
    return (r + s * d1 - t * d2).norm();
  }
  const double denominator = a * e - b * b;
  double s =
      denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0.0) {
    t = 0.0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1.0) {
    t = 1.0;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return (r + s * d1 - t * d2).norm();
}

}  // namespace

// Alternating projections give an upper bound; the faces' axes and the line between the projections
// give lower ones, which mostly agree with it at once; where they do not, the nearest pair is a
// corner against a box or an edge against an edge, and all are looked at.
double box_distance(const OrientedBox& a, const OrientedBox& b) {
  const auto project = [](const OrientedBox& box, const Eigen::Vector3d& p) {
    const Eigen::Vector3d local = box.axes.transpose() * (p - box.center);
    return Eigen::Vector3d(box.center + box.axes * local.cwiseMax(-box.half).cwiseMin(box.half));
  };
  Eigen::Vector3d p = project(a, b.center);
  Eigen::Vector3d q = project(b, p);
  double last = (p - q).norm();
  double apart = 0.0;
  const Eigen::Vector3d d = b.center - a.center;
  const auto apart_along = [&](const Eigen::Vector3d& axis) {
    const double reach = (a.axes.transpose() * axis).cwiseAbs().dot(a.half) +
                         (b.axes.transpose() * axis).cwiseAbs().dot(b.half);
    return std::abs(axis.dot(d)) - reach;
  };
  for (const OrientedBox* box : {&a, &b}) {
    for (int k = 0; k < 3; ++k) apart = std::max(apart, apart_along(box->axes.col(k)));
  }
  for (int i = 0; i < 8; ++i) {
    if (last > 1e-9) apart = std::max(apart, apart_along((q - p) / (q - p).norm()));
    if (last - apart < 1e-10) return last;
    p = project(a, q);
    q = project(b, p);
    last = std::min(last, (p - q).norm());
  }
  if (boxes_near(a, b, -1e-12)) return 0.0;
  const auto corner = [](const OrientedBox& box, int k) {
    const Eigen::Vector3d sign((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
    return Eigen::Vector3d(box.center + box.axes * sign.cwiseProduct(box.half));
  };
  Eigen::Vector3d of_a[8];
  Eigen::Vector3d of_b[8];
  for (int k = 0; k < 8; ++k) {
    of_a[k] = corner(a, k);
    of_b[k] = corner(b, k);
    last = std::min(
        {last, (project(b, of_a[k]) - of_a[k]).norm(), (project(a, of_b[k]) - of_b[k]).norm()});
  }
  for (int i = 0; i < 12; ++i) {
    // The four corners that have the axis' sign bit clear begin its four edges.
    const int bit = 1 << (i / 4);
    const int low = ((i % 4) & (bit - 1)) | (((i % 4) & ~(bit - 1)) << 1);
    for (int j = 0; j < 12; ++j) {
      const int other = 1 << (j / 4);
      const int begin = ((j % 4) & (other - 1)) | (((j % 4) & ~(other - 1)) << 1);
      last = std::min(last, segment_distance(of_a[low], of_a[low | bit] - of_a[low], of_b[begin],
                                             of_b[begin | other] - of_b[begin]));
    }
  }
  return last;
}

}  // namespace scanchor
