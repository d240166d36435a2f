#include "results/draw_surfaces.hpp"

#include <fmt/format.h>

#include "core/math.hpp"

namespace scanchor {
namespace {

constexpr Color shadow_edge{213, 94, 0};

std::vector<Eigen::Vector3d> in_space(const Surface& surface, const Ring& ring) {
  std::vector<Eigen::Vector3d> result;
  result.reserve(ring.size());
  for (const Eigen::Vector2d& p : ring) {
    result.emplace_back(surface.T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0));
  }
  return result;
}

std::array<Eigen::Vector3d, 4> rectangle_corners(const Surface& surface, double length,
                                                 double width) {
  const SinCos turn = portable_sincos(surface.rectangle.angle);
  const Eigen::Vector2d along = 0.5 * length * Eigen::Vector2d(turn.cos, turn.sin);
  const Eigen::Vector2d across = 0.5 * width * Eigen::Vector2d(-turn.sin, turn.cos);
  const Eigen::Vector2d& c = surface.rectangle.center;
  std::array<Eigen::Vector3d, 4> result;
  const Eigen::Vector2d corners[] = {c - along - across, c + along - across, c + along + across,
                                     c - along + across};
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = surface.T_cloud_surface * Eigen::Vector3d(corners[i].x(), corners[i].y(), 0.0);
  }
  return result;
}

void add_rectangle(DrawnLines& lines, const std::array<Eigen::Vector3d, 4>& c, int dashes) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& a = c[i];
    const Eigen::Vector3d& b = c[(i + 1) % 4];
    // Dashes in space, about 4 cm each, so that they stay in the right perspective.
    const int count = dashes > 0 ? std::max(3, 2 * int((b - a).norm() / 0.08) + 1) : 1;
    for (int k = 0; k < count; k += 2) {
      lines.ends.push_back(a + (b - a) * (double(k) / count));
      lines.ends.push_back(a + (b - a) * (double(k + 1) / count));
    }
  }
}

}  // namespace

bool turned_away(const Surface& surface, const Eigen::Vector3d& towards_eye) {
  return surface.area.value >= 2.0 && surface.plane.normal.dot(towards_eye) < -0.02;
}

std::string feature_text(const Surface& surface) {
  const auto bound = [](const Measured& m) { return m.at_least ? "≥" : ""; };
  return fmt::format("A {}{:.2f} m², E {}{:.2f} m, R {:.2f}", bound(surface.area),
                     surface.area.value, bound(surface.rectangle.length),
                     surface.rectangle.length.value, surface.rectangularness);
}

Drawing draw_surfaces(const Surfaces& surfaces, const DrawSurfacesOptions& options) {
  Drawing drawing;
  DrawnLines rectangles;
  rectangles.color = ink;
  rectangles.width_px = 1.3;
  DrawnLines intervals;
  intervals.color = with_alpha(ink, 90);
  intervals.width_px = 0.9;
  DrawnLines shadows;
  shadows.color = shadow_edge;
  shadows.width_px = 2.2;
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s) {
    const Surface& surface = surfaces.surfaces[s];
    if (surface.area.value < options.least_area || turned_away(surface, options.towards_eye)) {
      continue;
    }
    const Color color = s < options.colors.size() ? options.colors[s] : color_of_number(surface.id);
    for (const Polygon& polygon : surface.polygons) {
      DrawnPolygon drawn;
      drawn.outer = in_space(surface, polygon.outer);
      for (const Ring& hole : polygon.holes) drawn.holes.push_back(in_space(surface, hole));
      drawn.fill = with_alpha(color, options.opacity);
      drawn.outline = mix(color, ink, 0.35);
      for (const Eigen::Vector3d& p : drawn.outer) drawing.bounds.extend(p);
      if (options.occlusion) {
        for (std::size_t e = 0; e < polygon.outer_kind.size() && e < drawn.outer.size(); ++e) {
          if (polygon.outer_kind[e] != EdgeKind::occlusion) continue;
          shadows.ends.push_back(drawn.outer[e]);
          shadows.ends.push_back(drawn.outer[(e + 1) % drawn.outer.size()]);
        }
      }
      if (options.polygons) drawing.polygons.push_back(std::move(drawn));
    }
    const FittedRectangle& fit = surface.rectangle;
    if (options.rectangles && fit.length.value > 0.0) {
      add_rectangle(rectangles, rectangle_corners(surface, fit.length.value, fit.width.value), 1);
      for (const auto& [l, w] :
           {std::pair(fit.length.low, fit.width.low), std::pair(fit.length.high, fit.width.high)}) {
        if (l > 0.0 && w > 0.0) add_rectangle(intervals, rectangle_corners(surface, l, w), 0);
      }
    }
    if (options.features) {
      drawing.labels.push_back(
          {surface.plane.centroid, feature_text(surface), color, double(surface.inliers.size())});
    }
  }
  for (DrawnLines* lines : {&rectangles, &intervals, &shadows}) {
    if (!lines->ends.empty()) drawing.lines.push_back(std::move(*lines));
  }
  return drawing;
}

}  // namespace scanchor
