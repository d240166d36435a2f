#include "results/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scanchor {
namespace {

constexpr double margin = 18.0;
constexpr double title_size = 19.0;
constexpr double subtitle_size = 13.0;
constexpr double legend_size = 13.0;
constexpr double legend_row = 21.0;
constexpr double legend_most = 300.0;  // [px] longest text in a legend
constexpr double label_size = 12.5;
constexpr double label_least = 28.0;  // [px] of a thing that gets its name
constexpr double bar_height = 180.0;
constexpr Color panel{255, 255, 255, 225};

/// A round number of 1, 2 or 5 times a power of ten, at most `limit`.
double round_below(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= limit) return step * power;
  }
  return power;
}

std::string length_text(double metres) {
  if (metres >= 0.995) return fmt::format("{:g} m", metres);
  if (metres >= 0.00995) return fmt::format("{:g} cm", metres * 100.0);
  return fmt::format("{:g} mm", metres * 1000.0);
}

void draw_title(VectorPicture& picture, const Drawing& drawing) {
  const double room = picture.width - 2 * margin;
  if (!drawing.title.empty()) {
    picture.text(margin, margin + 15.0, fit_text(drawing.title, room, title_size, FontWeight::bold),
                 title_size, ink, TextAnchor::start, FontWeight::bold);
  }
  if (!drawing.subtitle.empty()) {
    picture.text(margin, margin + (drawing.title.empty() ? 12.0 : 36.0),
                 fit_text(drawing.subtitle, room, subtitle_size), subtitle_size, faint_ink);
  }
}

Box2 legend_box(const Drawing& drawing, const RenderOptions& options) {
  const double w = legend_width(drawing, options);
  if (w == 0.0) return {};
  double h = 20.0;
  if (!drawing.legend_title.empty()) h += legend_row + 2.0;
  h += legend_row * double(drawing.legend.size());
  if (drawing.legend_bar) h += bar_height + 34.0;
  const double y = title_height(drawing) > 0.0 ? title_height(drawing) : margin;
  return {options.width - w, y, w - margin, std::min(h, options.height - y - margin)};
}

void draw_legend(VectorPicture& picture, const Drawing& drawing, const RenderOptions& options) {
  const Box2 box = legend_box(drawing, options);
  if (box.w == 0.0) return;
  picture.fill_rectangle(box.x, box.y, box.w, box.h, panel, 6.0);
  picture.stroke_rectangle(box.x, box.y, box.w, box.h, grid_line, 1.0, 6.0);
  double y = box.y + 10.0;
  const double x = box.x + 12.0;
  if (!drawing.legend_title.empty()) {
    picture.text(x, y + 13.0, drawing.legend_title, legend_size, ink, TextAnchor::start,
                 FontWeight::bold);
    y += legend_row + 2.0;
  }
  if (drawing.legend_bar) {
    const LegendBar& bar = *drawing.legend_bar;
    picture.text(x, y + 13.0, bar.title, legend_size, ink, TextAnchor::start, FontWeight::bold);
    y += legend_row + 6.0;
    constexpr int steps = 60;
    for (int i = 0; i < steps; ++i) {
      const double t = 1.0 - (i + 0.5) / steps;
      picture.fill_rectangle(x, y + bar_height * i / steps, 18.0, bar_height / steps + 0.5,
                             color_map(bar.map, t));
    }
    for (int i = 0; i <= 4; ++i) {
      const double t = i / 4.0;
      const double at = y + bar_height * (1.0 - t);
      picture.line({x + 18.0, at}, {x + 23.0, at}, ink, 1.0);
      picture.text(x + 28.0, at + 4.5, fmt::format("{:.3g}", bar.low + t * (bar.high - bar.low)),
                   legend_size - 1.0);
    }
    y += bar_height + 8.0;
  }
  const double bottom = box.y + box.h;
  for (std::size_t i = 0; i < drawing.legend.size(); ++i, y += legend_row) {
    if (y + 2 * legend_row > bottom && i + 1 < drawing.legend.size()) {
      picture.text(x, y + 14.0, fmt::format("and {} more", drawing.legend.size() - i), legend_size,
                   faint_ink);
      break;
    }
    picture.fill_rectangle(x, y + 3.0, 14.0, 14.0, with_alpha(drawing.legend[i].color, 255), 3.0);
    picture.text(x + 22.0, y + 14.5, fit_text(drawing.legend[i].text, legend_most, legend_size),
                 legend_size);
  }
}

/// True to scale everywhere in a parallel projection; in perspective at the distance of the middle
/// of what is shown.
void draw_scale_bar(VectorPicture& picture, const Drawing& drawing, const Projection& projection,
                    std::vector<Box2>& taken) {
  if (drawing.bounds.isEmpty()) return;
  const double distance = projection.forward().dot(drawing.bounds.center() - projection.eye());
  if (!projection.parallel() && distance <= projection.near_plane()) return;
  const double scale = projection.pixels_per_metre(distance);
  const double length = round_below(0.16 * picture.width / scale);
  const double x = margin;
  const double y = picture.height - margin - 4.0;
  const double w = length * scale;
  std::string text = length_text(length);
  if (!projection.parallel()) text += " at mid-depth";
  picture.line({x, y}, {x + w, y}, ink, 2.0);
  picture.line({x, y - 5.0}, {x, y + 5.0}, ink, 2.0);
  picture.line({x + w, y - 5.0}, {x + w, y + 5.0}, ink, 2.0);
  picture.text(x, y - 9.0, text, 12.0);
  taken.push_back({x - 4.0, y - 24.0, std::max(w, text_width(text, 12.0)) + 8.0, 34.0});
}

void draw_axes(VectorPicture& picture, const Projection& projection, std::vector<Box2>& taken) {
  const Eigen::Vector2d origin(picture.width - 52.0, picture.height - 48.0);
  static const Color colors[] = {{213, 94, 0}, {0, 158, 115}, {0, 114, 178}};
  static const char* const names[] = {"x", "y", "z"};
  // Those that point away first.
  std::array<int, 3> order = {0, 1, 2};
  const auto depth = [&](int i) { return projection.forward()[i]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) > depth(b); });
  for (const int i : order) {
    const Eigen::Vector2d d(projection.right()[i], -projection.up()[i]);
    if (d.norm() > 0.12) picture.arrow(origin, origin + 30.0 * d, colors[i], 2.0);
    const Eigen::Vector2d text =
        origin + 30.0 * d +
        (d.norm() > 0.12 ? Eigen::Vector2d(9.0 * d.normalized()) : Eigen::Vector2d(8, 10));
    picture.text(text.x(), text.y() + 4.0, names[i], 12.0, colors[i], TextAnchor::middle,
                 FontWeight::bold);
  }
  taken.push_back({origin.x() - 44.0, origin.y() - 44.0, 88.0, 84.0});
}

void draw_arrows(VectorPicture& picture, const Drawing& drawing, const Projection& projection,
                 std::vector<Box2>& taken) {
  for (const DrawnArrow& arrow : drawing.arrows) {
    const Eigen::Vector3d a = projection.pixel(arrow.from);
    const Eigen::Vector3d b = projection.pixel(arrow.to);
    if (!projection.parallel() && std::min(a.z(), b.z()) < projection.near_plane()) continue;
    // Slightly bent, so that two relations between the same things stay apart.
    const Eigen::Vector2d p = a.head<2>();
    const Eigen::Vector2d q = b.head<2>();
    if ((q - p).norm() < 12.0) continue;
    const Eigen::Vector2d bend = (p + q) / 2 + 0.16 * Eigen::Vector2d(-(q - p).y(), (q - p).x());
    Path path;
    constexpr int steps = 24;
    for (int i = 0; i < steps; ++i) {
      const double t = double(i) / steps;
      path.emplace_back((1 - t) * (1 - t) * p + 2 * t * (1 - t) * bend + t * t * q);
    }
    const Eigen::Vector2d last = path.back();
    picture.polyline(path, with_alpha(paper_white, 200), arrow.width_px + 2.5);
    picture.polyline(path, arrow.color, arrow.width_px);
    picture.arrow(last + 1e-3 * (last - q), q, arrow.color, arrow.width_px);
    if (arrow.text.empty()) continue;
    const Eigen::Vector2d middle = path[std::size_t(steps / 2)];
    const double w = text_width(arrow.text, 11.0);
    const Box2 box{middle.x() - w / 2 - 4.0, middle.y() - 8.0, w + 8.0, 16.0};
    if (std::any_of(taken.begin(), taken.end(), [&](const Box2& b2) { return b2.overlaps(box); })) {
      continue;
    }
    picture.fill_rectangle(box.x, box.y, box.w, box.h, panel, 3.0);
    picture.text(middle.x(), middle.y() + 4.0, arrow.text, 11.0, arrow.color, TextAnchor::middle);
    taken.push_back(box);
  }
}

bool is_visible(const Eigen::Vector3d& pixel, const std::vector<float>& distance, int width,
                int height) {
  if (distance.empty()) return true;
  const int x = int(pixel.x());
  const int y = int(pixel.y());
  if (x < 0 || y < 0 || x >= width || y >= height) return false;
  const float there = distance[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  return there == 0.0F || double(there) > pixel.z() - 0.08;
}

void draw_labels(Overlay& overlay, const Drawing& drawing, const Projection& projection,
                 const RenderOptions& options, const std::vector<float>& distance,
                 const std::vector<Box2>& taken) {
  std::vector<LabelRequest> requests;
  std::vector<PlacedLabel> wanted;
  const Box2 area = free_area(drawing, options);
  for (std::size_t i = 0; i < drawing.labels.size(); ++i) {
    const DrawnLabel& label = drawing.labels[i];
    const Eigen::Vector3d pixel = projection.pixel(label.anchor);
    const bool in_front = projection.parallel() || pixel.z() > projection.near_plane();
    const bool tiny =
        label.extent > 0.0 && label.extent * projection.pixels_per_metre(pixel.z()) < label_least;
    if (!in_front || tiny || label.text.empty() || !area.contains(pixel.head<2>())) {
      ++overlay.labels_left_out;
      continue;
    }
    requests.push_back({pixel.head<2>(),
                        {text_width(label.text, label_size) + 14.0, label_size + 8.0},
                        label.priority});
    wanted.push_back(
        {i, {}, pixel.head<2>(), is_visible(pixel, distance, options.width, options.height)});
  }
  const std::vector<LabelPlace> places = place_labels(requests, taken, area);
  // Leaders first, so that no line runs over a box.
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!places[k].placed) {
      ++overlay.labels_left_out;
      continue;
    }
    wanted[k].box = places[k].box;
    const Color color = drawing.labels[wanted[k].index].color;
    const Eigen::Vector2d end = wanted[k].box.nearest(wanted[k].anchor);
    overlay.picture.line(wanted[k].anchor, end, with_alpha(paper_white, 200), 3.0);
    overlay.picture.line(wanted[k].anchor, end, ink, 1.1);
    overlay.picture.disc(wanted[k].anchor, 4.2, ink);
    overlay.picture.disc(wanted[k].anchor, 3.0, wanted[k].visible ? color : paper_white);
    overlay.labels.push_back(wanted[k]);
  }
  for (const PlacedLabel& placed : overlay.labels) {
    const DrawnLabel& label = drawing.labels[placed.index];
    const Box2& box = placed.box;
    overlay.picture.fill_rectangle(box.x, box.y, box.w, box.h, {255, 255, 255, 240}, 4.0);
    overlay.picture.stroke_rectangle(box.x, box.y, box.w, box.h, mix(label.color, ink, 0.15), 1.4,
                                     4.0);
    overlay.picture.text(box.x + 7.0, box.y + 0.72 * box.h, label.text, label_size);
  }
}

}  // namespace

double title_height(const Drawing& drawing) {
  if (drawing.title.empty() && drawing.subtitle.empty()) return 0.0;
  return margin + (drawing.title.empty() ? 0.0 : 24.0) + (drawing.subtitle.empty() ? 0.0 : 20.0) +
         4.0;
}

double legend_width(const Drawing& drawing, const RenderOptions& options) {
  if (!options.legend || (drawing.legend.empty() && !drawing.legend_bar)) return 0.0;
  double w = text_width(drawing.legend_title, legend_size, FontWeight::bold) - 22.0;
  for (const LegendEntry& entry : drawing.legend) {
    w = std::max(w, std::min(text_width(entry.text, legend_size), legend_most));
  }
  if (drawing.legend_bar) {
    w = std::max(w, text_width(drawing.legend_bar->title, legend_size, FontWeight::bold) - 22.0);
  }
  return std::min(w + 22.0 + 24.0 + 2.0, 0.4 * options.width) + margin;
}

Overlay make_overlay(const Drawing& drawing, const Projection& projection,
                     const RenderOptions& options, const std::vector<float>& distance) {
  Overlay overlay;
  overlay.picture.width = options.width;
  overlay.picture.height = options.height;
  std::vector<Box2> taken;
  draw_title(overlay.picture, drawing);
  if (drawing.bounds.isEmpty()) {
    overlay.picture.text(options.width / 2.0, options.height / 2.0, "nothing to show", 16.0,
                         faint_ink, TextAnchor::middle);
  }
  draw_legend(overlay.picture, drawing, options);
  if (options.scale_bar) draw_scale_bar(overlay.picture, drawing, projection, taken);
  if (options.axes) draw_axes(overlay.picture, projection, taken);
  draw_arrows(overlay.picture, drawing, projection, taken);
  if (options.labels) {
    draw_labels(overlay, drawing, projection, options, distance, taken);
  }
  return overlay;
}

}  // namespace scanchor
