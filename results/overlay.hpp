#pragma once
// What lies over a picture: title, legend, scale bar, axes, labels. The same for pixels and for
// SVG.

#include "results/render.hpp"

namespace scanchor {

/// Height of the title block [px]; 0 without a title.
double title_height(const Drawing& drawing);
/// Width of the legend with its margins [px]; 0 without one.
double legend_width(const Drawing& drawing, const RenderOptions& options);

struct Overlay {
  VectorPicture picture;
  std::vector<PlacedLabel> labels;
  std::size_t labels_left_out = 0;
};

/// `distance`: the depth of each pixel, to tell hidden anchors (drawn hollow) from visible ones;
/// may be empty.
Overlay make_overlay(const Drawing& drawing, const Projection& projection,
                     const RenderOptions& options, const std::vector<float>& distance);

}  // namespace scanchor
