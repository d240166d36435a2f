#include "results/render.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "results/depth_shading.hpp"
#include "results/gl_draw.hpp"
#include "results/overlay.hpp"
#include "results/paint.hpp"

namespace scanchor {

void RenderOptions::describe(OptionList& list) {
  list.add("width", width, "px", "width of the picture", 16, 16384);
  list.add("height", height, "px", "height of the picture", 16, 16384);
  list.add("samples", samples, "1", "samples a pixel: 1 or 4", 1, 8);
  list.add("depth_shading", depth_shading, "1", "how much creases and silhouettes are darkened",
           0.0, 2.0);
  list.add("labels", labels, "write the labels");
  list.add("legend", legend, "show the legend");
  list.add("scale_bar", scale_bar, "show the scale bar");
  list.add("axes", axes, "show the axes");
}

Box2 free_area(const Drawing& drawing, const RenderOptions& options) {
  const double top = title_height(drawing);
  return {0.0, top, options.width - legend_width(drawing, options), options.height - top};
}

View framed_view(const Drawing& drawing, const RenderOptions& options, ViewKind kind,
                 double azimuth_deg, double elevation_deg) {
  const Box2 area = free_area(drawing, options);
  const double aspect = area.w / area.h;
  const double share = 0.94 * area.h / options.height;
  switch (kind) {
    case ViewKind::top:
      return top_view(drawing.bounds, aspect, share);
    case ViewKind::side:
      return side_view(drawing.bounds, azimuth_deg, aspect, share);
    case ViewKind::perspective:
      break;
  }
  return perspective_view(places_to_frame(drawing), azimuth_deg, elevation_deg, aspect, share);
}

Projection projection_for(const Drawing& drawing, const View& view, const RenderOptions& options) {
  const Box2 area = free_area(drawing, options);
  const Eigen::Vector2d shift(area.x + area.w / 2 - options.width / 2.0,
                              area.y + area.h / 2 - options.height / 2.0);
  return {view, options.width, options.height, drawing.bounds, shift};
}

Rendered render_with_details(const Drawing& drawing, const View& view,
                             const RenderOptions& options) {
  if (options.width < 16 || options.height < 16) {
    fail_usage("a picture needs at least 16 x 16 pixels");
  }
  Drawing checked;  // Only its bounds are used where the caller gave none.
  const Eigen::AlignedBox3d contents = bounds_of(drawing);
  const Drawing* subject = &drawing;
  if (drawing.bounds.isEmpty() && !contents.isEmpty()) {
    checked = drawing;
    checked.bounds = contents;
    subject = &checked;
  }
  // The planes near and far enclose everything, also what the view does not frame.
  const Box2 area = free_area(*subject, options);
  const Eigen::Vector2d shift(area.x + area.w / 2 - options.width / 2.0,
                              area.y + area.h / 2 - options.height / 2.0);
  Eigen::AlignedBox3d space = contents;
  space.extend(subject->bounds);
  const Projection projection(view, options.width, options.height, space, shift);
  Frame frame = draw_with_gl(*subject, projection, options.width, options.height, options.samples,
                             options.background);
  // Translucent polygons leave no depth: shading would only show the noise of the points around
  // them.
  const bool solid = !subject->meshes.empty();
  const double strength = solid || subject->polygons.empty() ? options.depth_shading : 0.0;
  shade_by_depth(frame, strength, projection.pixels_per_metre(1.0), projection.parallel(), !solid);
  Overlay overlay = make_overlay(*subject, projection, options, frame.distance);
  paint(overlay.picture, frame.image);
  return {std::move(frame.image), std::move(overlay.labels), overlay.labels_left_out,
          std::move(frame.distance)};
}

Image render(const Drawing& drawing, const View& view, const RenderOptions& options) {
  return render_with_details(drawing, view, options).image;
}

Image side_by_side(const std::vector<Image>& images, const std::vector<std::string>& titles) {
  if (images.empty()) fail_usage("no pictures to set side by side");
  constexpr int band = 34;
  constexpr int gap = 12;
  int width = 0;
  int height = 0;
  for (const Image& image : images) {
    width += image.width + gap;
    height = std::max(height, image.height);
  }
  Image result = blank_image(width - gap, height + band);
  VectorPicture text;
  text.width = result.width;
  text.height = result.height;
  int x = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    copy_into(result, images[i], x, band);
    if (i < titles.size()) {
      text.text(x + 18.0, 24.0, fit_text(titles[i], images[i].width - 36.0, 17.0, FontWeight::bold),
                17.0, ink, TextAnchor::start, FontWeight::bold);
    }
    if (i > 0) text.line({x - gap / 2.0, 8.0}, {x - gap / 2.0, result.height - 8.0}, grid_line);
    x += images[i].width + gap;
  }
  paint(text, result);
  return result;
}

}  // namespace scanchor
