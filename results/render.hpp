#pragma once
// Drawings to pixels, off-screen. docs/reference/rendering.md shows what each option does.

#include <string>
#include <vector>

#include "core/options.hpp"
#include "results/drawing.hpp"
#include "results/image.hpp"
#include "results/layout.hpp"
#include "results/vector.hpp"
#include "results/view.hpp"

namespace scanchor {

struct RenderOptions {
  int width = 1280;            ///< [px]
  int height = 720;            ///< [px]
  int samples = 4;             ///< a pixel; 1: no smoothing of edges
  double depth_shading = 1.0;  ///< [0, 2] how much creases and silhouettes are darkened
  bool labels = true;
  bool legend = true;
  bool scale_bar = true;
  bool axes = true;
  Color background = paper_white;
  void describe(OptionList& list);
};

/// Throws Error(bad_data) for a coordinate that is not finite or a picture without pixels, and
/// where there is no OpenGL. Same bytes for the same input on one driver version. An empty drawing
/// gives a picture that says so.
Image render(const Drawing& drawing, const View& view, const RenderOptions& options = {});

/// A label as it was set: index into Drawing::labels, its box in pixels, and whether its anchor can
/// be seen.
struct PlacedLabel {
  std::size_t index = 0;
  Box2 box;
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();
  bool visible = true;
};

struct Rendered {
  Image image;
  std::vector<PlacedLabel> labels;  ///< no two boxes overlap
  std::size_t labels_left_out =
      0;                        ///< no room, outside the picture, or of a thing too small to see
  std::vector<float> distance;  ///< [m] along the line of sight, a pixel; 0: nothing there
};
Rendered render_with_details(const Drawing& drawing, const View& view,
                             const RenderOptions& options = {});

/// The part of the picture that title and legend leave free.
Box2 free_area(const Drawing& drawing, const RenderOptions& options);

enum class ViewKind { perspective, top, side };
/// A view that frames the drawing's bounds in that free part.
View framed_view(const Drawing& drawing, const RenderOptions& options,
                 ViewKind kind = ViewKind::perspective, double azimuth_deg = -122.0,
                 double elevation_deg = 42.0);

/// The projection that render() uses: the view's centre in the middle of the free part.
Projection projection_for(const Drawing& drawing, const View& view, const RenderOptions& options);

/// Pictures of one height side by side with a title over each. Throws Error(bad_data) if there are
/// none.
Image side_by_side(const std::vector<Image>& images, const std::vector<std::string>& titles);

}  // namespace scanchor
