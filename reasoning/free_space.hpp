#pragma once
// Where a shape fits between obstacles in the plane.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// What may be used: within one of the outer rings and in none of the holes, clear of the
/// obstacles.
struct FreeSpace {
  std::vector<Ring> outer;      ///< simple; none: the whole plane
  std::vector<Ring> holes;      ///< simple
  std::vector<Ring> obstacles;  ///< convex, in any order of turning; two points are a wall
};

/// The place nearest to `wanted` for the origin of `shape` (convex, counter-clockwise, moved and
/// not turned), such that the shape lies within the space and touches at most the borders; the
/// origin within `window` (convex, counter-clockwise). Nothing where it fits nowhere. Exact: the
/// nearest place is `wanted`, or the foot of a perpendicular on a border of the places that an
/// obstacle forbids (its Minkowski sum with the turned shape; Lozano-Perez, IEEE Trans. Computers
/// 32, 1983), or where two borders meet, and all of those are tried, the nearest first.
std::optional<Eigen::Vector2d> nearest_fit(const FreeSpace& space, const Ring& shape,
                                           const Ring& window, const Eigen::Vector2d& wanted);

/// [m2] of a convex region, counter-clockwise, that lies within the outer rings and in no hole.
double area_within(const FreeSpace& space, const Ring& region);

}  // namespace scanchor
