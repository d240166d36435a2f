#pragma once
// The paper's chain from the points of one plane to A, E, R: alpha shape, bitmap, Hough lines, four
// lines at right angles.

#include "cloud/point_cloud.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// Fills polygons, rectangle, area, rectangularness, is_rectangle and eccentricity of the surface
/// from its inliers, as section 2 of the paper lists the steps. No intervals beyond half a cell of
/// the bitmap, and no sensor: low = high = value where nothing is known.
void shape_as_paper(const PointCloud& cloud, Surface& surface);

}  // namespace scanchor
