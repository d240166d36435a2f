#include "perception/alpha_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "perception/polygon_rings.hpp"
#include "perception/polygon_union_find.hpp"

namespace scanchor {
namespace {

/// Square of the circumradius: (abc / 4F)^2.
double squared_circumradius(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                            const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a;
  const Eigen::Vector2d v = c - a;
  const double cross = u.x() * v.y() - u.y() * v.x();
  if (cross == 0.0) return std::numeric_limits<double>::infinity();
  return u.squaredNorm() * v.squaredNorm() * (b - c).squaredNorm() / (4.0 * cross * cross);
}

}  // namespace

std::vector<Polygon> alpha_shape(const std::vector<Eigen::Vector2d>& points,
                                 const Triangulation& triangulation, double radius) {
  const auto& triangles = triangulation.triangles;
  const auto& neighbours = triangulation.neighbours;
  std::vector<char> kept(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    kept[t] = squared_circumradius(points[triangles[t][0]], points[triangles[t][1]],
                                   points[triangles[t][2]]) <= radius * radius;
  }
  UnionFind pieces(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::int32_t n : neighbours[t]) {
      if (kept[t] && n >= 0 && kept[static_cast<std::size_t>(n)])
        pieces.join(t, static_cast<std::size_t>(n));
    }
  }
  std::vector<BoundarySegment> segments;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!kept[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t n = neighbours[t][k];
      if (n >= 0 && kept[static_cast<std::size_t>(n)]) continue;
      segments.push_back({triangles[t][(k + 1) % 3], triangles[t][(k + 2) % 3],
                          static_cast<std::uint32_t>(pieces.root(t)), EdgeKind::unknown});
    }
  }
  std::vector<Polygon> polygons = rings_to_polygons(points, chain_rings(points, segments));
  for (Polygon& polygon : polygons) polygon.outer_kind.clear();
  return polygons;
}

std::vector<Polygon> alpha_shape(const std::vector<Eigen::Vector2d>& points, double radius) {
  return alpha_shape(points, delaunay(points), radius);
}

double median_spacing(const std::vector<Eigen::Vector2d>& points,
                      const Triangulation& triangulation) {
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  for (const auto& t : triangulation.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      const double d = (points[a] - points[b]).squaredNorm();
      nearest[a] = std::min(nearest[a], d);
      nearest[b] = std::min(nearest[b], d);
    }
  }
  std::erase_if(nearest,
                [](double d) { return !std::isfinite(d); });  // duplicates that are no corner
  if (nearest.empty()) return 0.0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return std::sqrt(*middle);
}

}  // namespace scanchor
