#pragma once
// The default chain from the points of one plane to polygons, rectangle, A, E, R, with intervals
// and with what lies beyond each edge.

#include "cloud/point_cloud.hpp"
#include "perception/shape_view.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// Fills polygons, rectangle, area, rectangularness, is_rectangle, eccentricity and
/// occluded_outline of a surface from its inliers and, where the sensor position is known (`view`
/// not null), from the rays beside them. Deterministic, without a trace of the points' order.
void shape_surface(const PointCloud& cloud, const ShapeView* view, const Surfaces& all,
                   Surface& surface);

}  // namespace scanchor
