#pragma once
// The plane of a surface with the noise where it is: along the rays.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>

#include "cloud/point_cloud.hpp"
#include "perception/shape_view.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// A plane p . (x - sensor) = 1, fitted so that the ranges fit best.
struct RayPlane {
  Eigen::Vector3d sensor = Eigen::Vector3d::Zero();  ///< [m] cloud frame
  Eigen::Vector3d p = Eigen::Vector3d::Zero();       ///< [1/m] normal / distance from the sensor
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of p
  Eigen::Isometry3d T_cloud_plane =
      Eigen::Isometry3d::Identity();  ///< the surface's frame, turned onto this plane

  /// [m2] variance of the distance between the places where two rays, given by points on them, meet
  /// the plane; measured along the unit vector `along` (cloud frame). The rays are exact, the plane
  /// is not.
  [[nodiscard]] double distance_variance(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& along) const;
};

/// Least squares of (measured range - range of the plane along the ray), Gauss-Newton from the
/// surface's own plane. A fit across the plane tilts an obliquely seen patch towards the sensor, by
/// about sigma^2 sin(i) cos(i) / variance of its points along the slope (one degree for half a
/// metre at 45 degrees and 3 cm), because noise along the ray moves a point across and along the
/// plane at once; this one does not. Falls back to the surface's plane where the points do not
/// determine one. `view`: holds the surface's inliers as plane `surface.id`, in a sequence that the
/// order of the cloud has no part in; without, they are sorted here.
RayPlane fit_along_rays(const PointCloud& cloud, const Surface& surface,
                        const Eigen::Vector3d& sensor, const ShapeView* view = nullptr);

}  // namespace scanchor
