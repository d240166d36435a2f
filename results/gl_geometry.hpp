#pragma once
// What the renderer makes of lines and polygons before the driver sees them.

#include <array>
#include <vector>

#include "results/drawing.hpp"
#include "results/view.hpp"

namespace scanchor {

/// A corner of a line that has been made of triangles, in clip coordinates.
struct LineVertex {
  std::array<float, 4> clip;
  Color color;
};

/// The drawing's lines and the outlines of its polygons, two triangles each, as wide as they say in
/// pixels: core profiles promise lines of one pixel only. `hidden`: those that show through
/// everything, else the others. What is behind the eye is cut off.
std::vector<LineVertex> line_vertices(const Drawing& drawing, const Projection& projection,
                                      int width, int height, bool hidden);

/// The filling of a polygon with holes, in its colour; empty where its ring spans no area.
DrawnMesh filling(const DrawnPolygon& polygon);

}  // namespace scanchor
