#include "perception/shape_default.hpp"

#include <algorithm>
#include <cmath>

#include "perception/outline_polygons.hpp"
#include "perception/polygon_check.hpp"
#include "perception/rectangle_fit.hpp"
#include "perception/shape_area.hpp"
#include "perception/shape_common.hpp"
#include "perception/shape_plane.hpp"

namespace scanchor {
namespace {

constexpr double nearly_filled = 0.9;  // of a rectangle is filled: the surface is one

bool on_surface(const std::vector<Polygon>& polygons, const Eigen::Vector2d& p) {
  return std::any_of(polygons.begin(), polygons.end(),
                     [&](const Polygon& polygon) { return contains(polygon, p); });
}

/// What the ray towards a point of the plane met: true if something nearer, so that nobody knows
/// what is there.
bool is_hidden(const ShapeView& view, const Surface& surface, const Eigen::Vector2d& p,
               double gate) {
  const Eigen::Vector3d target = surface.T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0);
  const Eigen::Vector3d direction = (target - view.sensor()).normalized();
  const std::uint32_t cell = view.cell_of(direction);
  double best = -2.0;
  Eigen::Vector3d hit = Eigen::Vector3d::Zero();
  for (const ShapeRay& ray : view.rays(cell)) {
    const Eigen::Vector3d& q = ray.point;
    const double cosine = direction.dot(ray.direction);
    if (cosine > best ||
        (cosine == best &&
         std::lexicographical_compare(q.data(), q.data() + 3, hit.data(), hit.data() + 3))) {
      best = cosine;
      hit = q;
    }
  }
  if (best < -1.0) return true;  // no ray went there
  const double side = surface.plane.normal.dot(view.sensor()) >= surface.plane.offset ? 1.0 : -1.0;
  return side * (surface.plane.normal.dot(hit) - surface.plane.offset) > gate;
}

/// Whether a small piece is a thing of its own: rays that passed between it and the largest piece
/// show that nothing joins them. What a shadow parts belongs together.
bool stands_apart(const ShapeView& view, const Surface& surface, const Polygon& piece,
                  double gate) {
  const Polygon& largest = surface.polygons.front();
  constexpr double small = 0.4;  // a larger one is no stray
  if (piece.area() > small * largest.area()) return false;
  Eigen::Vector2d from = piece.outer.front();
  Eigen::Vector2d to = largest.outer.front();
  for (const auto& a : piece.outer) {
    for (const auto& b : largest.outer) {
      if ((a - b).squaredNorm() < (from - to).squaredNorm()) from = a, to = b;
    }
  }
  constexpr int steps = 8;
  int open = 0;
  int hidden = 0;
  for (int k = 0; k < steps; ++k) {
    const Eigen::Vector2d p = from + (to - from) * ((k + 0.5) / steps);
    if (on_surface(surface.polygons, p)) continue;
    ++(is_hidden(view, surface, p, gate) ? hidden : open);
  }
  return open > hidden;
}

/// Takes the pieces that stand apart out of what the rectangle is fitted to; [m2] what they cover.
double leave_out_strays(const ShapeView& view, const Surface& surface, double gate,
                        RectangleEvidence& evidence) {
  std::size_t first = 0;
  double strays = 0.0;
  std::vector<OutlineEdge> kept;
  for (std::size_t k = 0; k < surface.polygons.size(); ++k) {
    const Polygon& piece = surface.polygons[k];
    const std::size_t next = first + piece.outer.size();  // one edge a vertex, piece by piece
    if (k == 0 || !stands_apart(view, surface, piece, gate)) {
      kept.insert(kept.end(), evidence.edges.begin() + static_cast<std::ptrdiff_t>(first),
                  evidence.edges.begin() + static_cast<std::ptrdiff_t>(next));
    } else {
      strays += piece.area();
      std::size_t to = 0;
      for (std::size_t i = 0; i < evidence.inside.size(); ++i) {
        if (contains(piece, evidence.inside[i])) continue;
        evidence.inside[to] = evidence.inside[i];
        evidence.inside_height[to++] = evidence.inside_height[i];
      }
      evidence.inside.resize(to);
      evidence.inside_height.resize(to);
    }
    first = next;
  }
  evidence.edges = std::move(kept);
  return strays;
}

/// Share of the rectangle, as far as it could be seen, that is surface.
double filled_share(const ShapeView* view, const Surface& surface, double gate) {
  const FittedRectangle& r = surface.rectangle;
  const Eigen::Vector2d u(std::cos(r.angle), std::sin(r.angle));
  const Eigen::Vector2d v(-u.y(), u.x());
  constexpr int steps = 24;
  int filled = 0;
  int seen = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const Eigen::Vector2d p = r.center + ((i + 0.5) / steps - 0.5) * r.length.value * u +
                                ((j + 0.5) / steps - 0.5) * r.width.value * v;
      if (on_surface(surface.polygons, p)) {
        ++filled;
        ++seen;
      } else if (view == nullptr || !is_hidden(*view, surface, p, gate)) {
        ++seen;
      }
    }
  }
  return seen > 0 ? static_cast<double>(filled) / seen : 0.0;
}

/// True where every vertex of the outline lies within 1.5 gaps of the rectangle's border, and the
/// border is all true edges: then the rectangle itself is the better polygon.
bool is_clean(const std::vector<Polygon>& polygons, const RectangleFit& fit,
              const std::vector<OutlineEdge>& edges, const OutlineShare& share) {
  if (polygons.size() != 1 || !polygons.front().holes.empty() || share.total <= 0.0 ||
      share.hidden > 0.1 * share.total)
    return false;
  for (std::size_t k = 0; k < 4; ++k) {
    if (fit.censored[k] || fit.support[k] < 0.6) return false;
  }
  const FittedRectangle& r = fit.rectangle;
  const Eigen::Vector2d u(std::cos(r.angle), std::sin(r.angle));
  const Eigen::Vector2d v(-u.y(), u.x());
  for (const OutlineEdge& e : edges) {
    const Eigen::Vector2d d = e.from - r.center;
    const double inwards = std::min(0.5 * r.length.value - std::abs(d.dot(u)),
                                    0.5 * r.width.value - std::abs(d.dot(v)));
    if (std::abs(inwards) > 1.5 * e.gap) return false;
  }
  return true;
}

Polygon rectangle_polygon(const FittedRectangle& r) {
  const Eigen::Vector2d u =
      0.5 * r.length.value * Eigen::Vector2d(std::cos(r.angle), std::sin(r.angle));
  const Eigen::Vector2d v =
      0.5 * r.width.value * Eigen::Vector2d(-std::sin(r.angle), std::cos(r.angle));
  Polygon polygon;
  polygon.outer = {r.center - u - v, r.center + u - v, r.center + u + v, r.center - u + v};
  polygon.outer_kind.assign(4, EdgeKind::true_edge);
  return polygon;
}

/// True where a vertex lies outside the points' box by more than a quarter of its diagonal. A ray
/// that nearly grazes the plane meets it far away or behind the scanner: such an outline says
/// nothing, and the points alone say more.
bool reaches_beyond(const std::vector<Polygon>& polygons,
                    const std::vector<Eigen::Vector2d>& points) {
  Eigen::AlignedBox2d box;
  for (const auto& point : points) box.extend(point);
  const double slack = 0.25 * box.diagonal().norm();
  for (const Polygon& polygon : polygons) {
    for (const auto& vertex : polygon.outer) {
      if (box.exteriorDistance(vertex) > slack) return true;
    }
  }
  return false;
}

/// Points on a line or fewer than three: no outline, a rectangle without width.
void shape_degenerate(const FlatPoints& flat, Surface& surface) {
  surface.polygons.clear();
  surface.rectangle = minimum_area_rectangle(flat.points);
  surface.area = {};
  surface.rectangularness = 0.0;
  surface.is_rectangle = false;
}

}  // namespace

void shape_surface(const PointCloud& cloud, const ShapeView* view, const Surfaces& all,
                   Surface& surface) {
  // Inliers at the sensor itself have no ray.
  const ShapeView* of_all =
      view != nullptr && view->plane_rays(surface.id).size() == surface.inliers.size() ? view
                                                                                       : nullptr;
  const FlatPoints flat = of_all != nullptr ? flatten(*of_all, surface) : flatten(cloud, surface);
  surface.eccentricity = ellipse_eccentricity(flat.points);
  // 3.5 sigma: one point in two thousand of the surface's own lies farther from it.
  const double gate = 3.5 * std::max(all.noise_sigma, surface.plane.residual_sigma) + 1e-6;
  const RayPlane plane =
      view != nullptr ? fit_along_rays(cloud, surface, view->sensor(), of_all) : RayPlane{};
  const OutlineSamples samples = view != nullptr
                                     ? samples_with_view(*view, surface, plane.T_cloud_plane, gate)
                                     : samples_without_view(flat, surface.T_cloud_surface);
  const Outline outline = find_outline(cloud, all, surface, samples, gate);
  RectangleEvidence evidence;
  surface.polygons = outline_polygons(outline, &evidence.edges);
  if (surface.polygons.empty()) {
    shape_degenerate(flat, surface);
    return;
  }
  if (view != nullptr && reaches_beyond(surface.polygons, flat.points)) {
    shape_surface(cloud, nullptr, all, surface);
    return;
  }
  if (view != nullptr) {
    // The points were moved along their rays: what is left is the plane's own error, the same for
    // all of them.
    evidence.plane_variance = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                  const Eigen::Vector2d& along) {
      return plane.distance_variance(
          plane.T_cloud_plane * Eigen::Vector3d(a.x(), a.y(), 0.0),
          plane.T_cloud_plane * Eigen::Vector3d(b.x(), b.y(), 0.0),
          plane.T_cloud_plane.linear() * Eigen::Vector3d(along.x(), along.y(), 0.0));
    };
  } else {
    // Noise along an unknown ray at 30 degrees from the normal has this part along the plane.
    evidence.sigma = 0.58 * surface.plane.residual_sigma;
  }
  double strays = 0.0;
  evidence.inside = outline.inside;
  evidence.outside = outline.beyond;
  if (view != nullptr) {
    evidence.foot = samples.chart.sensor.head<2>();
    const double across = 1.0 / std::max(surface.plane.residual_sigma, 1e-9);
    for (const double h : outline.inside_height) evidence.inside_height.push_back(h * across);
    for (const double h : outline.beyond_height) evidence.outside_height.push_back(h * across);
    strays = leave_out_strays(*view, surface, gate, evidence);
  }

  const OutlineShare share = hidden_share(outline);
  const RectangleFit fit = fit_rectangle(evidence);
  surface.occluded_outline = share.total > 0.0 ? std::min(1.0, share.hidden / share.total) : 0.0;
  surface.rectangle = fit.rectangle;
  if (is_clean(surface.polygons, fit, evidence.edges, share)) {
    surface.polygons = {rectangle_polygon(fit.rectangle)};
    surface.area = fit.area;
    surface.rectangularness = 1.0;
    surface.is_rectangle = true;
    return;
  }
  surface.area = polygon_area(surface.polygons, evidence.edges);
  surface.area.low = std::max(0.0, surface.area.low - fit.loose_area);
  surface.rectangularness = filled_share(view, surface, gate);
  // What sticks out of a rectangle that is filled is no part of it, and neither is a stray.
  if (surface.rectangularness >= nearly_filled) {
    const auto shown = [&](std::size_t k) { return !fit.censored[k] && !fit.censored[k + 2]; };
    strays = area_outside(surface.polygons, fit.rectangle, shown(0), shown(1));
  }
  take_off(strays, surface.area);
  surface.area.at_least = share.hidden + share.hidden_holes > 0.05 * share.total;
  // Four sides that meet at right angles by construction: a rectangle if the surface fills what
  // could be seen of it, and at least two sides were seen along a third of their length.
  const auto seen = std::count_if(fit.support.begin(), fit.support.end(),
                                  [](double support) { return support >= 0.3; });
  surface.is_rectangle = seen >= 2 && surface.rectangularness >= nearly_filled;
}

}  // namespace scanchor
