#pragma once
// A plane with its uncertainty, from the points that lie on it (reasoning.md section 2.2 of the
// design; docs/why/planes.md).

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "perception/moments.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// Least-squares plane through points[i], i in `inliers` (at least one), with covariance:
///   Sigma_n = s2/n (e1 e1^T / m1 + e2 e2^T / m2),   mi = (li - l0)^2 / li,   sigma_c^2 = s2/n, s2
///   = n/(n-3) l0,
/// where l0 <= l1 <= l2 are the variances along the principal axes. n/(n-3) makes s2 unbiased:
/// three degrees of freedom went into the plane. `noise_floor` [m] is the least standard deviation
/// that is believed (rounding of the input). The normal points towards the nearest of `sensors`;
/// without any, its largest component is positive. Summed about the first inlier in double
/// precision: coordinates of 10^6 m lose nothing.
Plane fit_plane(const std::vector<Eigen::Vector3d>& points,
                const std::vector<std::uint32_t>& inliers,
                const std::vector<Eigen::Vector3d>& sensors, double noise_floor = 0.0);

/// Where noise lies along a beam (unit vector): the plane n that explains the points with the least
/// noise along it, the least n'Cn / n'(bb' + g2 I)n; g = BeamNoise::grazing stands for roughness.
/// Of broad patches it is the least-squares plane. Of a strip narrower than the noise it is not:
/// such a strip scatters less across itself than along the beam.
MomentPlane fit_plane_along(const Moments& moments, const Eigen::Vector3d& beam);

/// The same from moments about `origin`, where the points were summed already; `fit` must be
/// fit_plane(moments) or, with a beam, fit_plane_along(moments, beam). Then mi = (li - noise along
/// ei)^2 / li, since the spread along the plane holds what of the beam lies along it.
Plane plane_from_moments(const Moments& moments, const MomentPlane& fit,
                         const Eigen::Vector3d& origin, const std::vector<Eigen::Vector3d>& sensors,
                         double noise_floor, const std::optional<Eigen::Vector3d>& beam = {});

/// Frame of a surface: origin at the centroid, z along the normal, x along the longer spread of the
/// inliers (`long_axis`; its largest component is positive).
Eigen::Isometry3d surface_frame(const Plane& plane, const Eigen::Vector3d& long_axis);

/// [0, 1] that some points are one plane and no curved thing. A paraboloid is fitted to the
/// distances from the plane; b2 is the variance that its three second-order terms explain beyond
/// chance (two standard deviations of what noise alone would give), s2 the variance that is left,
/// but not less than `noise_floor`^2, and e2 the mean square of what a sensor's own systematic
/// error may bend (bent_planes.hpp: 3 % of the narrower half extent, at most 30 mm):   confidence =
/// 1 / (1 + (b2 / (0.4^2 s2 + e2))^2). Without e2, a bend as deep as 0.4 of the noise halves it; a
/// wall bowed by a fifth of the noise keeps 0.94. Below 8 points: n / 16.
class BendTest {
 public:
  /// A point: u, v along the plane about the centroid, w across it [m].
  void add(double u, double v, double w);
  [[nodiscard]] double confidence(double noise_floor) const;

 private:
  double n_ = 0.0, total_ = 0.0;
  double power_[5][5] = {};  // sums of u^i v^j, i + j <= 4
  double right_[6] = {};     // sums of w times 1, u, v, uu, uv, vv
};

}  // namespace scanchor
