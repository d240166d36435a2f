#pragma once
// The part of drawing that OpenGL does: shaded triangles, points and lines into an own framebuffer
// object.

#include <vector>

#include "results/drawing.hpp"
#include "results/image.hpp"
#include "results/view.hpp"

namespace scanchor {

struct Frame {
  Image image;
  /// [m] along the line of sight, one a pixel in the order of the image; 0: background.
  std::vector<float> distance;
};

/// Draws meshes, polygons, points, lines and arrows' shafts; no text. Reuses one context for the
/// whole process: calls from several threads wait for each other. Same bytes for the same input on
/// one driver version. `samples`: 1 or 4, fewer if the driver has fewer. Throws Error if there is
/// no OpenGL.
Frame draw_with_gl(const Drawing& drawing, const Projection& projection, int width, int height,
                   int samples, Color background);

/// "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa 22.3.6".
std::string gl_driver();

}  // namespace scanchor
