#pragma once
// Questions to polygons.

#include <Eigen/Core>

#include "perception/surface.hpp"

namespace scanchor {

/// No two edges touch but neighbours in their common vertex, and no vertex comes twice. O(n log n)
/// for rings that are not wildly jagged.
bool is_simple(const Ring& ring);

/// All rings simple, no two of them touch or cross, the outer one counter-clockwise, holes
/// clockwise and inside it.
bool is_valid(const Polygon& polygon);

/// Even-odd rule; points on the border may go either way.
bool contains(const Ring& ring, const Eigen::Vector2d& point);
/// Inside the outer ring and in no hole.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

}  // namespace scanchor
