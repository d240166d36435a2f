#pragma once
// What both methods do with the points of a plane before they differ.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "cloud/point_cloud.hpp"
#include "perception/shape_view.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// The inliers in the frame of the surface, in a sequence in which that of the cloud's points
/// leaves no trace. `order[i]` is the index in the cloud of point i.
struct FlatPoints {
  std::vector<Eigen::Vector2d> points;  ///< [m] dropped onto the plane along its normal
  std::vector<std::uint32_t> order;
};
/// Sorted by (x, y).
FlatPoints flatten(const PointCloud& cloud, const Surface& surface);
/// In the view's sequence; the surface is plane `surface.id` of the view.
FlatPoints flatten(const ShapeView& view, const Surface& surface);

/// Eccentricity of the ellipse with the second moments of the points: sqrt(1 - l1 / l2), [0, 1).
double ellipse_eccentricity(const std::vector<Eigen::Vector2d>& points);

/// Rectangle of the least area around the points (rotating calipers on the hull), longer side as
/// length; intervals are empty (low = high = value). Zero for fewer than two different points.
FittedRectangle minimum_area_rectangle(const std::vector<Eigen::Vector2d>& points);

/// Sets centre, angle in [-pi/2, pi/2) and sides from a frame and the extents in it; the longer
/// side becomes `length`.
FittedRectangle rectangle_from_sides(double angle, const Eigen::Vector2d& low,
                                     const Eigen::Vector2d& high);

}  // namespace scanchor
