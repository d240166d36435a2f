#pragma once
// What the rays near one surface say about it: here it is, here it is not, here something stands in
// front.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "perception/shape_common.hpp"
#include "perception/shape_view.hpp"
#include "perception/surface.hpp"

namespace scanchor {

enum class SampleKind : std::uint8_t {
  inside,   ///< an inlier of the surface
  passed,   ///< the ray crossed the plane and met something farther: no surface here
  blocked,  ///< the ray met something nearer: nobody knows
  beside,   ///< a point of another surface in the same plane, or where the two meet
};

/// One ray at the surface.
struct OutlineSample {
  Eigen::Vector2d chart =
      Eigen::Vector2d::Zero();  ///< where the triangulation happens; a projective image of `plane`,
                                ///< so lines stay lines
  Eigen::Vector2d plane =
      Eigen::Vector2d::Zero();  ///< [m] where the ray crosses the plane, in the surface's frame
  Eigen::Vector3d metric =
      Eigen::Vector3d::Zero();  ///< where distances between samples are measured: unit direction of
                                ///< the ray, or (plane, 0)
  double height = 0.0;      ///< [m] of the point itself over the plane, positive towards the sensor
  std::uint32_t point = 0;  ///< index in the cloud
  SampleKind kind = SampleKind::inside;
  bool reachable = true;  ///< false: the ray does not cross the plane (looks above its horizon);
                          ///< `plane` is not set
  bool thinned = false;   ///< stands for the inliers of a whole cell deep inside
};

/// The view of one surface from the sensor, in chart coordinates: gnomonic projection on an axis
/// near the middle of the surface. Evenly spread rays are evenly spread in it, however obliquely
/// they meet the plane, and straight edges stay straight.
struct SurfaceChart {
  Eigen::Vector3d sensor;  ///< [m] in the surface's frame
  Eigen::Matrix3d
      axes;  ///< rows e1, e2, a: chart = (e1.d, e2.d) / a.d, with d in the surface's frame
  /// Chart to plane; false where the ray does not come down on the plane.
  [[nodiscard]] bool to_plane(const Eigen::Vector2d& chart, Eigen::Vector2d& plane) const;
};

struct OutlineSamples {
  std::vector<OutlineSample>
      samples;  ///< those inside first, else cell by cell: no trace of the order of the points
  SurfaceChart chart;
  Eigen::Isometry3d T_cloud_plane =
      Eigen::Isometry3d::Identity();  ///< frame of `plane` and of the chart's sensor
  bool with_view = false;             ///< false: inliers only, chart = plane, metric in metres
};

/// All inliers where no sensor position is known: dropped onto the plane along its normal.
OutlineSamples samples_without_view(const FlatPoints& flat, const Eigen::Isometry3d& T_cloud_plane);

/// The inliers, moved onto the plane along their rays (range noise moves a point along its ray, so
/// this takes the noise out of the outline), and the rays of others within two cells. Inliers of
/// cells deep inside are thinned to one a cell. `gate` [m]: points nearer to the plane than this
/// belong to it as far as noise can tell.
/// The surface is plane `surface.id` of the view.
OutlineSamples samples_with_view(const ShapeView& view, const Surface& surface,
                                 const Eigen::Isometry3d& T_cloud_plane, double gate);

}  // namespace scanchor
