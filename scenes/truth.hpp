#pragma once
// The exact values of faces from their triangles: plane, smallest rectangle, area. The generator
// and the readers use the same function, so a face has the same bits whether it was made or read.

#include <Eigen/Core>
#include <vector>

#include "scenes/scene.hpp"

namespace scanchor {

/// Smallest rectangle around points of a plane. One of its sides lies on an edge of the convex hull
/// (Freeman and Shapira, "Determining the minimum-area encasing rectangle for an arbitrary closed
/// curve", CACM 18, 1975).
struct PlaneRectangle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit, along the longer side
  Eigen::Vector2d size = Eigen::Vector2d::Zero();   ///< longer side first
};
PlaneRectangle smallest_rectangle(std::vector<Eigen::Vector2d> points);

/// Fills centre, normal, axis, size and area of every face from the part's triangles; names and
/// `planar` stay. Curved faces get their area, the centroid of their triangles and a zero normal.
void measure_faces(Part& part);

/// Groups triangles into faces: neighbours over an edge whose normals differ by at most `flat_deg`
/// and that lie within `distance` [m] of one plane make a planar face; what is left over joins into
/// curved faces. Fills `faces` and `triangle_face`.
void find_faces(Part& part, double flat_deg = 0.05, double distance = 1e-4);

/// Whether no vertex lies more than `tolerance` [m] outside the plane of any triangle.
bool is_convex(const Part& part, double tolerance = 1e-9);

}  // namespace scanchor
