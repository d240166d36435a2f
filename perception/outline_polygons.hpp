#pragma once
// From the raw outline, which wavers, to polygons with straight edges.

#include <vector>

#include "perception/outline.hpp"
#include "perception/rectangle_sides.hpp"
#include "perception/surface.hpp"

namespace scanchor {

/// The raw outline as polygons: noise in it smoothed, edges straight, valid (polygon_check.hpp),
/// largest first. `edges`: all outer edges with their kind, for the fit of the rectangle. Pieces
/// and holes of less than three samples are left out.
std::vector<Polygon> outline_polygons(const Outline& outline,
                                      std::vector<OutlineEdge>* edges = nullptr);

/// How much of the outline is no true edge, but a shadow or the end of the view.
struct OutlineShare {
  double hidden = 0.0;        ///< [m] of the outer rings
  double total = 0.0;         ///< [m] all of the outer rings
  double hidden_holes = 0.0;  ///< [m] of the holes
};
OutlineShare hidden_share(const Outline& outline);

}  // namespace scanchor
