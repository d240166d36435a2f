#pragma once
// Creases and silhouettes darkened from the depth buffer, so that shape can be read without
// shadows.

#include "results/gl_draw.hpp"

namespace scanchor {

/// Darkens the frame's pixels that lie behind the mean of their neighbours on opposite sides, at
/// several distances: unsharp masking of the depth buffer (Luft, Colditz, Deussen, SIGGRAPH 2006),
/// on inverse depth, which is linear over a plane in perspective, so that a plane stays as it is.
/// `strength` 0: off, 1: usual. `pixels_per_metre`: at a distance of 1 m (perspective), or
/// everywhere (parallel). `fine`: only the nearest neighbours, for clouds of points.
void shade_by_depth(Frame& frame, double strength, double pixels_per_metre, bool parallel,
                    bool fine);

}  // namespace scanchor
