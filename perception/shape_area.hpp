#pragma once
// The area of a surface, and what of its outline belongs to it.

#include <vector>

#include "perception/rectangle_sides.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// [m2] area of the polygons with its interval. Each edge is known to a gap, variance gap^2 / 12
/// (reasoning.md 2.2). Where the samples change their phase along it the raw outline wavers by as
/// much, and that part averages out over the length of an edge; what does not waver is the same
/// error along the whole edge.
Measured polygon_area(const std::vector<Polygon>& polygons, const std::vector<OutlineEdge>& edges);

/// [m2] of polygons that lies outside a rectangle, beyond its two ends and beyond its two long
/// sides.
double area_outside(const std::vector<Polygon>& polygons, const FittedRectangle& rectangle,
                    bool beyond_ends, bool beyond_sides);

/// Takes an area off that may be of another thing: off the value and the lower end, while the upper
/// end still holds it.
void take_off(double doubtful, Measured& area);

}  // namespace scanchor
