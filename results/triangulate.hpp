#pragma once
// Polygons with holes cut into triangles, for filling them in 3D.

#include <Eigen/Core>
#include <vector>

namespace scanchor {

/// Triangles over the vertices of all rings, numbered through in their order (rings[0] is the outer
/// ring, the others are holes, any direction of turning). Ear clipping with bridged holes (D.
/// Eberly, "Triangulation by Ear Clipping", 2008). A ring that crosses itself still gives
/// triangles, but not exactly its area. Fewer than 3 corners: none.
std::vector<Eigen::Vector3i> triangulate(const std::vector<std::vector<Eigen::Vector2d>>& rings);

}  // namespace scanchor
