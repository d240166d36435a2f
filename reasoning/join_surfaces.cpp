#include "reasoning/join_surfaces.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "reasoning/recut_frame.hpp"

namespace scanchor {

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
  const RectangleSides sides(a.rectangle);
  Eigen::Vector2d low(-0.5 * a.rectangle.length.value, -0.5 * a.rectangle.width.value);
  Eigen::Vector2d high = -low;
  const RectangleSides other(b.rectangle);
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
    r.angle += 0.5 * pi;
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
  const RectangleSides sides(a.rectangle);
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

}  // namespace scanchor
