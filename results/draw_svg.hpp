#pragma once
// A drawing as paths instead of pixels: polygons, lines, points and everything that overlay.hpp
// writes. For papers.

#include "results/render.hpp"

namespace scanchor {

/// Far things first (painter's algorithm by the middle of each piece: polygons that pass through
/// each other may be set wrongly). Meshes are left out: they belong into pixels. At most
/// `most_points` points are drawn, an even sample, so that the file stays small. Throws
/// Error(bad_data) for a coordinate that is not finite.
VectorPicture draw_outlines(const Drawing& drawing, const View& view,
                            const RenderOptions& options = {}, std::size_t most_points = 8000);

}  // namespace scanchor
