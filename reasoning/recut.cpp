#include "reasoning/recut.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math.hpp"
#include "reasoning/recut_frame.hpp"

namespace scanchor {

namespace {

Eigen::Vector2d flat(const Surface& surface, const Eigen::Vector3d& p) {
  return (surface.T_cloud_surface.inverse() * p).head<2>();
}

/// A ring and the kinds of its edges cut by u.x >= limit (sign 1) or <= limit (-1); Sutherland and
/// Hodgman, with the kind of each edge carried along.
void clip(Ring& ring, std::vector<EdgeKind>& kinds, const RectangleSides& sides, double limit,
          double sign) {
  Ring kept;
  std::vector<EdgeKind> kept_kinds;
  const bool with_kinds = kinds.size() == ring.size();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& p = ring[i];
    const Eigen::Vector2d& q = ring[(i + 1) % ring.size()];
    const double a = sign * (sides.of(p).x() - limit);
    const double b = sign * (sides.of(q).x() - limit);
    const EdgeKind kind = with_kinds ? kinds[i] : EdgeKind::unknown;
    if (a >= 0.0) {
      kept.push_back(p);
      kept_kinds.push_back(kind);
    }
    if ((a >= 0.0) != (b >= 0.0)) {
      kept.push_back(p + (q - p) * (a / (a - b)));
      // Leaving: the next edge runs along the cut, where the thing ends; coming in: it is this one.
      kept_kinds.push_back(a >= 0.0 ? EdgeKind::true_edge : kind);
    }
  }
  ring = std::move(kept);
  kinds = with_kinds ? std::move(kept_kinds) : std::vector<EdgeKind>();
}

double polygons_area(const Surface& surface) {
  double area = 0.0;
  for (const auto& polygon : surface.polygons) area += polygon.area();
  return area;
}

Measured like(const Measured& whole, double value) {
  const double share = whole.value > 0.0 ? value / whole.value : 1.0;
  return {value, value - (whole.value - whole.low) * std::min(1.0, std::sqrt(share)),
          value + (whole.high - whole.value) * std::min(1.0, std::sqrt(share)), whole.at_least};
}

std::optional<Surface> piece(const Surface& whole, const std::vector<Eigen::Vector3d>& points,
                             double low, double high) {
  const RectangleSides sides(whole.rectangle);
  Surface s = whole;
  s.inliers.clear();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto i : whole.inliers) {
    const double x = sides.of(flat(whole, points[i])).x();
    if (x < low || x >= high) continue;
    s.inliers.push_back(i);
    sum += points[i];
  }
  if (s.inliers.size() < 3) return std::nullopt;
  s.inlier_count = s.inliers.size();
  s.plane.centroid = sum / static_cast<double>(s.inliers.size());
  // The fewer points on a shorter base, the less is known of the tilt.
  const double share =
      static_cast<double>(s.inliers.size()) / static_cast<double>(whole.inliers.size());
  s.plane.normal_covariance /= share;

  std::vector<Polygon> polygons;
  double x_low = INFINITY, x_high = -INFINITY, y_low = INFINITY, y_high = -INFINITY;
  for (Polygon polygon : whole.polygons) {
    clip(polygon.outer, polygon.outer_kind, sides, low, 1.0);
    clip(polygon.outer, polygon.outer_kind, sides, high, -1.0);
    if (polygon.outer.size() < 3) continue;
    std::vector<Ring> holes;
    for (auto& hole : polygon.holes) {
      std::vector<EdgeKind> none;
      clip(hole, none, sides, low, 1.0);
      clip(hole, none, sides, high, -1.0);
      if (hole.size() >= 3) holes.push_back(hole);
    }
    polygon.holes = std::move(holes);
    for (const auto& p : polygon.outer) {
      const Eigen::Vector2d at = sides.of(p);
      x_low = std::min(x_low, at.x());
      x_high = std::max(x_high, at.x());
      y_low = std::min(y_low, at.y());
      y_high = std::max(y_high, at.y());
    }
    polygons.push_back(std::move(polygon));
  }
  if (polygons.empty()) return std::nullopt;
  std::sort(polygons.begin(), polygons.end(),
            [](const Polygon& a, const Polygon& b) { return a.area() > b.area(); });
  s.polygons = std::move(polygons);
  // The rectangle keeps to the whole one's sides, or a bump of the outline would widen it.
  const double half_length = 0.5 * whole.rectangle.length.value;
  const double half_width = 0.5 * whole.rectangle.width.value;
  x_low = std::max({x_low, low, -half_length});
  x_high = std::min({x_high, high, half_length});
  y_low = std::max(y_low, -half_width);
  y_high = std::min(y_high, half_width);
  if (x_high - x_low < 1e-3 || y_high - y_low < 1e-3) return std::nullopt;
  auto& r = s.rectangle;
  r.center = sides.center + 0.5 * (x_low + x_high) * sides.u + 0.5 * (y_low + y_high) * sides.v;
  r.length = side(whole.rectangle.length, x_high - x_low, whole.rectangle.length.at_least);
  r.width = side(whole.rectangle.width, y_high - y_low, whole.rectangle.width.at_least);
  if (r.width.value > r.length.value) {
    std::swap(r.width, r.length);
    r.angle += 0.5 * pi;
  }
  const double area = polygons_area(s);
  const double of_whole = polygons_area(whole);
  s.area = like(whole.area, of_whole > 0.0 ? whole.area.value * area / of_whole : area);
  const double filled = area / (r.length.value * r.width.value);
  const double filled_whole =
      of_whole / (whole.rectangle.length.value * whole.rectangle.width.value);
  s.rectangularness = std::clamp(whole.rectangularness * filled / filled_whole, 0.0, 1.0);
  s.occluded_outline =
      whole.polygons.front().outer_kind.empty() ? whole.occluded_outline : outline_in_shadow(s);
  centre_frame(s);
  return s;
}

}  // namespace

std::optional<std::vector<Surface>> cut_surface(const Surface& surface,
                                                const std::vector<Eigen::Vector3d>& points,
                                                const std::vector<double>& cuts) {
  std::vector<Surface> pieces;
  for (std::size_t i = 0; i <= cuts.size(); ++i) {
    auto one = piece(surface, points, i == 0 ? -INFINITY : cuts[i - 1],
                     i == cuts.size() ? INFINITY : cuts[i]);
    if (!one) return std::nullopt;
    pieces.push_back(std::move(*one));
  }
  return pieces;
}

std::vector<double> outline_seams(const Surface& surface, double gap) {
  const RectangleSides sides(surface.rectangle);
  double largest = 0.0;
  for (const auto& polygon : surface.polygons) largest = std::max(largest, polygon.area());
  std::vector<std::pair<double, double>> spans;
  for (const auto& polygon : surface.polygons) {
    if (polygon.area() < 0.1 * largest) continue;
    double low = INFINITY;
    double high = -INFINITY;
    for (const auto& p : polygon.outer) {
      low = std::min(low, sides.of(p).x());
      high = std::max(high, sides.of(p).x());
    }
    spans.emplace_back(low, high);
  }
  std::sort(spans.begin(), spans.end());
  std::vector<double> seams;
  double reached = spans.empty() ? 0.0 : spans.front().second;
  for (const auto& [low, high] : spans) {
    if (low > reached + gap) seams.push_back(0.5 * (low + reached));
    reached = std::max(reached, high);
  }
  return seams;
}

std::optional<std::vector<double>> find_seams(const Surface& surface,
                                              const std::vector<Eigen::Vector3d>& points,
                                              int pieces, double spacing) {
  const double length = surface.rectangle.length.value;
  const double bin = std::max(spacing, 0.005);
  const int count = static_cast<int>(length / bin);
  if (count < 8 * pieces) return std::nullopt;
  const RectangleSides sides(surface.rectangle);
  std::vector<double> density(static_cast<std::size_t>(count), 0.0);
  for (const auto i : surface.inliers) {
    const double x = sides.of(flat(surface, points[i])).x() + 0.5 * length;
    const int k = static_cast<int>(x / bin);
    if (k >= 0 && k < count) density[static_cast<std::size_t>(k)] += 1.0;
  }
  std::vector<double> sorted = density;
  std::nth_element(sorted.begin(), sorted.begin() + count / 2, sorted.end());
  const double usual = sorted[static_cast<std::size_t>(count / 2)];
  if (usual < 4.0) return std::nullopt;  // too few points to see a gap in
  std::vector<double> seams;
  for (int s = 1; s < pieces; ++s) {
    const int at = count * s / pieces;
    const int reach = std::max(2, count / pieces / 6);
    int thinnest = at;
    for (int k = std::max(1, at - reach); k <= std::min(count - 2, at + reach); ++k) {
      if (density[static_cast<std::size_t>(k)] < density[static_cast<std::size_t>(thinnest)])
        thinnest = k;
    }
    if (density[static_cast<std::size_t>(thinnest)] > 0.35 * usual) return std::nullopt;
    seams.push_back((thinnest + 0.5) * bin - 0.5 * length);
  }
  return seams;
}

Surfaces with_changed(const Surfaces& surfaces, const std::vector<std::int32_t>& removed,
                      std::vector<Surface> added, std::vector<std::int32_t>* place_of_added) {
  Surfaces result = surfaces;
  std::vector<char> gone(surfaces.surfaces.size(), 0);
  for (const auto r : removed) gone[static_cast<std::size_t>(r)] = 1;
  std::vector<Surface> all;
  for (std::size_t i = 0; i < surfaces.surfaces.size(); ++i) {
    if (gone[i] == 0) all.push_back(surfaces.surfaces[i]);
  }
  const std::size_t kept = all.size();
  for (auto& s : added) all.push_back(std::move(s));
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
    if (all[x].inlier_count != all[y].inlier_count)
      return all[x].inlier_count > all[y].inlier_count;
    const auto first = [&](std::size_t i) {
      return all[i].inliers.empty() ? UINT32_MAX : all[i].inliers.front();
    };
    return first(x) < first(y);
  });
  result.surfaces.clear();
  if (place_of_added != nullptr) place_of_added->assign(all.size() - kept, -1);
  for (const auto i : order) {
    Surface s = std::move(all[i]);
    s.id = static_cast<std::int32_t>(result.surfaces.size());
    if (i >= kept && place_of_added != nullptr) (*place_of_added)[i - kept] = s.id;
    result.surfaces.push_back(std::move(s));
  }
  std::fill(result.plane_of_point.begin(), result.plane_of_point.end(), -1);
  for (const auto& s : result.surfaces) {
    for (const auto i : s.inliers) {
      if (i < result.plane_of_point.size()) result.plane_of_point[i] = s.id;
    }
  }
  return result;
}

}  // namespace scanchor
