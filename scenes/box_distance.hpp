#pragma once
// How far two boxes are from each other.

#include "scenes/collide.hpp"

namespace scanchor {

/// [m]; 0 where they overlap. Exact to rounding for boxes turned in any way.
double box_distance(const OrientedBox& a, const OrientedBox& b);

}  // namespace scanchor
