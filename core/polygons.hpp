#pragma once
// Polygons in the plane: hulls, shadows of things on the floor, and what they have in common.

#include <Eigen/Core>
#include <vector>

namespace scanchor {

/// Counter-clockwise corners.
using Ring2 = std::vector<Eigen::Vector2d>;

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/// [m2]; 0 for fewer than three corners.
double area_of(const Ring2& ring);
/// Convex hull, counter-clockwise, without points on its edges; fewer than three corners for points
/// on one line (Andrew's monotone chain, Information Processing Letters 9, 1979).
Ring2 convex_hull(std::vector<Eigen::Vector2d> points);
/// Cuts a simple polygon with the half plane to the left of a -> b (Sutherland and Hodgman 1974).
void clip(Ring2& ring, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/// Minkowski sum of a convex polygon with a regular octagon around the circle of radius r.
Ring2 dilated(const Ring2& ring, double r);
/// Share of a's area that lies over b.
double overlap_share(const Ring2& a, const Ring2& b);

}  // namespace scanchor
