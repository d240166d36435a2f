#pragma once
// A plane with its uncertainty, from the points that lie on it (reasoning.md section 2.2 of the design; docs/why/planes.md).

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// Least-squares plane through points[i], i in `inliers` (at least one), with covariance:
///   Sigma_n = s2/n (e1 e1^T / l1 + e2 e2^T / l2),   sigma_c^2 = s2/n,   s2 = n/(n-3) l0,
/// where l0 <= l1 <= l2 are the variances along the principal axes. n/(n-3) makes s2 unbiased: three degrees of freedom went
/// into the plane. `noise_floor` [m] is the least standard deviation that is believed (rounding of the input).
/// The normal points towards the nearest of `sensors`; without any, its largest component is positive.
/// Summed about the first inlier in double precision: coordinates of 10^6 m lose nothing.
Plane fit_plane(const std::vector<Eigen::Vector3d>& points, const std::vector<std::uint32_t>& inliers,
                const std::vector<Eigen::Vector3d>& sensors, double noise_floor = 0.0);

/// Frame of a surface: origin at the centroid, z along the normal, x along the longer spread of the inliers.
Eigen::Isometry3d surface_frame(const Plane& plane, const std::vector<Eigen::Vector3d>& points,
                                const std::vector<std::uint32_t>& inliers);

/// [0, 1] that these inliers are one plane and no curved thing. A paraboloid is fitted to the distances from the plane; b2 is the
/// variance that its three second-order terms explain beyond chance (two standard deviations of what noise alone would give),
/// s2 the variance that is left, but not less than `noise_floor`^2:   confidence = 1 / (1 + (b2 / (0.4^2 s2))^2).
/// A bend as deep as 0.4 of the noise halves it; a wall bowed by a fifth of the noise keeps 0.94.
double plane_confidence(const Plane& plane, const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std::uint32_t>& inliers, double noise_floor);

}  // namespace scanchor
