#include "reasoning/recut.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scanchor {

namespace {

/// Coordinates along the sides of a rectangle, from its middle.
struct Sides {
  Eigen::Vector2d center, u, v;
  explicit Sides(const FittedRectangle& r)
      : center(r.center),
        u(std::cos(r.angle), std::sin(r.angle)),
        v(-std::sin(r.angle), std::cos(r.angle)) {}
  [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector2d& p) const {
    return {u.dot(p - center), v.dot(p - center)};
  }
};

Eigen::Vector2d flat(const Surface& surface, const Eigen::Vector3d& p) {
  return (surface.T_cloud_surface.inverse() * p).head<2>();
}

/// A ring and the kinds of its edges cut by u.x >= limit (sign 1) or <= limit (-1); Sutherland and
/// Hodgman, with the kind of each edge carried along.
void clip(Ring& ring, std::vector<EdgeKind>& kinds, const Sides& sides, double limit, double sign) {
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

double outline_in_shadow(const Surface& surface) {
  double shadow = 0.0;
  double all = 0.0;
  for (const auto& polygon : surface.polygons) {
    for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
      const double length =
          (polygon.outer[(i + 1) % polygon.outer.size()] - polygon.outer[i]).norm();
      all += length;
      if (i < polygon.outer_kind.size() && (polygon.outer_kind[i] == EdgeKind::occlusion ||
                                            polygon.outer_kind[i] == EdgeKind::view_limit))
        shadow += length;
    }
  }
  return all > 0.0 ? shadow / all : 0.0;
}

double area_of(const Surface& surface) {
  double area = 0.0;
  for (const auto& polygon : surface.polygons) area += polygon.area();
  return area;
}

Measured like(const Measured& whole, double value) {
  const double share = whole.value > 0.0 ? value / whole.value : 1.0;
  return {value, value - (whole.value - whole.low) * std::min(1.0, std::sqrt(share)),
          value + (whole.high - whole.value) * std::min(1.0, std::sqrt(share)), whole.at_least};
}

/// A side keeps the uncertainty of its two edges.
Measured side(const Measured& as, double value, bool at_least) {
  return {value, value - (as.value - as.low), value + (as.high - as.value), at_least};
}

/// Moves the frame's origin to the plane's centroid.
void centre_frame(Surface& surface) {
  const Eigen::Vector3d origin = surface.T_cloud_surface.translation();
  const Eigen::Vector3d& n = surface.plane.normal;
  Eigen::Vector3d& centroid = surface.plane.centroid;
  centroid -= n * (n.dot(centroid) - surface.plane.offset);  // on the plane that was fitted
  const Eigen::Vector2d shift =
      (surface.T_cloud_surface.linear().transpose() * (centroid - origin)).head<2>();
  for (auto& polygon : surface.polygons) {
    for (auto& p : polygon.outer) p -= shift;
    for (auto& hole : polygon.holes) {
      for (auto& p : hole) p -= shift;
    }
  }
  surface.rectangle.center -= shift;
  surface.T_cloud_surface.translation() = centroid;
}

std::optional<Surface> piece(const Surface& whole, const std::vector<Eigen::Vector3d>& points,
                             double low, double high) {
  const Sides sides(whole.rectangle);
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
    r.angle += 0.5 * 3.14159265358979323846;
  }
  const double area = area_of(s);
  const double of_whole = area_of(whole);
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

std::vector<double> outline_seams(const Surface& surface) {
  const Sides sides(surface.rectangle);
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
    if (low > reached) seams.push_back(0.5 * (low + reached));
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
  const Sides sides(surface.rectangle);
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

Surface join_surfaces(const Surface& first, const Surface& second) {
  const bool in_order = first.area.value >= second.area.value;
  const Surface& a = in_order ? first : second;
  const Surface& b = in_order ? second : first;
  Surface s = a;
  s.inliers.insert(s.inliers.end(), b.inliers.begin(), b.inliers.end());
  std::sort(s.inliers.begin(), s.inliers.end());
  s.inlier_count = a.inlier_count + b.inlier_count;
  const double share = static_cast<double>(a.inlier_count) / static_cast<double>(s.inlier_count);
  s.plane.centroid = share * a.plane.centroid + (1.0 - share) * b.plane.centroid;
  const Eigen::Isometry3d T = a.T_cloud_surface.inverse() * b.T_cloud_surface;
  for (Polygon polygon : b.polygons) {
    const auto move = [&](Eigen::Vector2d& p) {
      p = (T * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
    };
    std::for_each(polygon.outer.begin(), polygon.outer.end(), move);
    for (auto& hole : polygon.holes) std::for_each(hole.begin(), hole.end(), move);
    if (ring_area(polygon.outer) < 0.0) {  // its normal looked the other way
      std::reverse(polygon.outer.begin(), polygon.outer.end());
      polygon.outer_kind.assign(polygon.outer_kind.rbegin(), polygon.outer_kind.rend());
      if (!polygon.outer_kind.empty())
        std::rotate(polygon.outer_kind.begin(), polygon.outer_kind.begin() + 1,
                    polygon.outer_kind.end());
      for (auto& hole : polygon.holes) std::reverse(hole.begin(), hole.end());
    }
    s.polygons.push_back(std::move(polygon));
  }
  // Corners of both rectangles, in the sides of the larger one.
  const Sides sides(a.rectangle);
  Eigen::Vector2d low(-0.5 * a.rectangle.length.value, -0.5 * a.rectangle.width.value);
  Eigen::Vector2d high = -low;
  const Sides other(b.rectangle);
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      const Eigen::Vector2d corner = other.center + x * b.rectangle.length.value * other.u +
                                     y * b.rectangle.width.value * other.v;
      const Eigen::Vector2d at =
          sides.of((T * Eigen::Vector3d(corner.x(), corner.y(), 0.0)).head<2>());
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  }
  auto& r = s.rectangle;
  const Eigen::Vector2d middle = 0.5 * (low + high);
  const Eigen::Vector2d size = high - low;
  r.center = sides.center + middle.x() * sides.u + middle.y() * sides.v;
  r.length = side(a.rectangle.length, size.x(),
                  a.rectangle.length.at_least || b.rectangle.length.at_least);
  r.width =
      side(a.rectangle.width, size.y(), a.rectangle.width.at_least || b.rectangle.width.at_least);
  if (r.width.value > r.length.value) {
    std::swap(r.width, r.length);
    r.angle += 0.5 * 3.14159265358979323846;
  }
  const double seen = a.area.value + b.area.value;
  s.area = {seen, seen - (a.area.value - a.area.low) - (b.area.value - b.area.low),
            seen + (a.area.high - a.area.value) + (b.area.high - b.area.value), true};
  // What neither rectangle covers lies in the shadow between them.
  const double covered = a.rectangle.length.value * a.rectangle.width.value +
                         b.rectangle.length.value * b.rectangle.width.value;
  const double weight =
      covered > 0.0 ? a.rectangle.length.value * a.rectangle.width.value / covered : 1.0;
  s.rectangularness = weight * a.rectangularness + (1.0 - weight) * b.rectangularness;
  s.is_rectangle = a.is_rectangle && b.is_rectangle;
  s.occluded_outline = outline_in_shadow(s);
  s.confidence = std::min(a.confidence, b.confidence);
  std::sort(s.polygons.begin(), s.polygons.end(),
            [](const Polygon& x, const Polygon& y) { return x.area() > y.area(); });
  centre_frame(s);
  return s;
}

std::optional<Facing> facing(const Surface& a, const Surface& b) {
  if (a.polygons.empty() || b.polygons.empty()) return std::nullopt;
  const Sides sides(a.rectangle);
  const Eigen::Isometry3d T = a.T_cloud_surface.inverse() * b.T_cloud_surface;
  Eigen::Vector2d low(INFINITY, INFINITY);
  Eigen::Vector2d high = -low;
  for (const auto& polygon : b.polygons) {
    for (const auto& p : polygon.outer) {
      const Eigen::Vector2d at = sides.of((T * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>());
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
  }
  const Eigen::Vector2d half(0.5 * a.rectangle.length.value, 0.5 * a.rectangle.width.value);
  Facing result;
  int axis = -1;
  double sign = 0.0;
  for (int k = 0; k < 2; ++k) {
    for (const double way : {-1.0, 1.0}) {
      const double gap = way > 0.0 ? low[k] - half[k] : -half[k] - high[k];
      if (gap <= -0.02) continue;
      if (axis >= 0) return std::nullopt;  // a corner faces a corner
      axis = k;
      sign = way;
      result.gap = std::max(gap, 0.0);
    }
  }
  if (axis < 0) return std::nullopt;
  const int along = 1 - axis;
  const double common = std::min(high[along], half[along]) - std::max(low[along], -half[along]);
  const double shorter = std::min(high[along] - low[along], 2.0 * half[along]);
  if (common <= 0.0 || shorter <= 0.0) return std::nullopt;
  result.common = std::min(1.0, common / shorter);
  result.step = std::max(std::abs(low[along] + half[along]), std::abs(high[along] - half[along]));
  result.across = a.plane.normal.dot(b.plane.centroid) - a.plane.offset;
  // Of the outline that looks towards the other, in the stretch that both have: how much is shadow?
  const double from = std::max(low[along], -half[along]);
  const double to = std::min(high[along], half[along]);
  const auto shadow = [&](const Surface& s, const Eigen::Isometry3d& T_a, double towards) {
    double dark = 0.0;
    double all = 0.0;
    const bool mirrored = T_a.linear()(2, 2) < 0.0;
    for (const auto& polygon : s.polygons) {
      if (polygon.outer_kind.size() != polygon.outer.size()) continue;
      for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
        const auto in_a = [&](const Eigen::Vector2d& p) {
          return sides.of((T_a * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>());
        };
        const Eigen::Vector2d p = in_a(polygon.outer[i]);
        const Eigen::Vector2d q = in_a(polygon.outer[(i + 1) % polygon.outer.size()]);
        // The outside of a counter-clockwise ring is to the right of its edges.
        Eigen::Vector2d outwards(q.y() - p.y(), p.x() - q.x());
        if (mirrored) outwards = -outwards;
        const double faces = towards * outwards[axis];
        if (faces <= 0.7 * outwards.norm()) continue;
        const double middle = 0.5 * (p[along] + q[along]);
        if (middle < from || middle > to) continue;
        all += faces;
        if (polygon.outer_kind[i] == EdgeKind::occlusion) dark += faces;
      }
    }
    return all > 0.0 ? dark / all : -1.0;
  };
  const double of_a = shadow(a, Eigen::Isometry3d::Identity(), sign);
  const double of_b = shadow(b, T, -sign);
  if (of_a < 0.0 || of_b < 0.0) return std::nullopt;
  result.shadow = std::min(of_a, of_b);
  return result;
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
