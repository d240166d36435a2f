#include "perception/outline_polygons.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "perception/polygon_check.hpp"
#include "perception/polygon_simplify.hpp"

namespace scanchor {
namespace {

constexpr std::size_t smallest_ring =
    7;  ///< nodes: two samples alone have six neighbouring middles or so, three have more

/// A ring of the outline at four levels of smoothing. Level 0: straightened; 1: simplified; 2: as
/// measured.
struct SmoothRing {
  Ring ring;
  std::vector<EdgeKind> kinds;
  std::vector<double> gaps;    ///< [m] of each edge
  std::vector<double> wavers;  ///< [m] of each edge
};

SmoothRing smooth(const Outline& outline, const BoundaryRing& raw, int level) {
  RoughRing rough;
  const std::size_t n = raw.nodes.size();
  for (const std::uint32_t node : raw.nodes) {
    rough.points.push_back(outline.nodes[node].position);
    rough.tolerance.push_back(outline.nodes[node].half_gap);
  }
  // The tolerance of a vertex: what is usual around it, for a lone long triangle says little.
  std::vector<double> usual(n), around(n + 4);
  for (std::size_t k = 0; k < n + 4; ++k) around[k] = rough.tolerance[(k + n - 2) % n];
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, 5> near{};
    std::copy_n(around.begin() + static_cast<std::ptrdiff_t>(i), 5, near.begin());
    std::sort(near.begin(), near.end());
    usual[i] = std::max({near[2], std::min(rough.tolerance[i], 2.0 * near[2]), 1e-6});
  }
  rough.tolerance = usual;

  SmoothRing result;
  if (level >= 2) {
    result.ring = rough.points;
    result.kinds = raw.kinds;
    for (const double t : rough.tolerance) result.gaps.push_back(2.0 * t);
    result.wavers.assign(n, 0.0);
    return result;
  }
  std::vector<double> gaps = rough.tolerance;
  // A raw outline wavers by half a gap to either side of the edge, so two vertices of it may lie a
  // gap apart across it.
  for (double& t : rough.tolerance) t *= 1.7;
  const std::vector<std::uint32_t> kept = simplify(rough);
  if (level == 0) {
    result.ring = straighten(rough, kept);
  } else {
    for (const std::uint32_t i : kept) result.ring.push_back(rough.points[i]);
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const std::size_t steps = (kept[(i + 1) % kept.size()] + n - kept[i]) % n;
    const auto next = [n](std::size_t a) { return a + 1 < n ? a + 1 : 0; };
    std::array<double, 4> length{};
    double gap = 0.0;
    std::size_t at = kept[i];
    for (std::size_t k = 0; k < steps; ++k, at = next(at)) {
      length[static_cast<std::size_t>(raw.kinds[at])] +=
          (rough.points[next(at)] - rough.points[at]).norm();
      gap += gaps[at];
    }
    const auto longest = std::max_element(length.begin(), length.end());
    result.kinds.push_back(static_cast<EdgeKind>(longest - length.begin()));
    result.gaps.push_back(2.0 * gap / static_cast<double>(steps));
    const Eigen::Vector2d& from = result.ring[i];
    const Eigen::Vector2d along = result.ring[(i + 1) % kept.size()] - from;
    double squares = 0.0;
    at = next(kept[i]);
    for (std::size_t k = 1; k < steps; ++k, at = next(at)) {
      const Eigen::Vector2d d = rough.points[at] - from;
      const double off = along.x() * d.y() - along.y() * d.x();
      squares += off * off;
    }
    result.wavers.push_back(
        steps > 1 && along.squaredNorm() > 0.0
            ? std::sqrt(squares / along.squaredNorm() / static_cast<double>(steps - 1))
            : 0.0);
  }
  return result;
}

}  // namespace

std::vector<Polygon> outline_polygons(const Outline& outline, std::vector<OutlineEdge>* edges) {
  struct Piece {
    Polygon polygon;
    std::vector<OutlineEdge> edges;
    double area;
  };
  std::vector<Piece> pieces;
  for (std::size_t r = 0; r < outline.rings.size(); ++r) {
    const BoundaryRing& outer = outline.rings[r];
    if (outer.area <= 0.0) continue;
    if (outer.nodes.size() < smallest_ring && outline.rings.size() > 1) continue;
    // Smoothing might make rings touch; then less of it.
    for (int level = 0; level < 3; ++level) {
      Piece piece;
      SmoothRing ring = smooth(outline, outer, level);
      piece.polygon.outer = ring.ring;
      piece.polygon.outer_kind = ring.kinds;
      for (std::size_t h = r + 1;
           h < outline.rings.size() && outline.rings[h].component == outer.component; ++h) {
        if (outline.rings[h].area >= 0.0 || outline.rings[h].nodes.size() < smallest_ring) continue;
        SmoothRing hole = smooth(outline, outline.rings[h], level);
        if (ring_area(hole.ring) < 0.0) piece.polygon.holes.push_back(std::move(hole.ring));
      }
      if (!is_valid(piece.polygon)) {
        // A hole that has grown into the outer ring is a notch too small to tell; without holes the
        // ring may do.
        if (level < 2) continue;
        std::erase_if(piece.polygon.holes, [&](const Ring& hole) {
          return !is_valid({piece.polygon.outer, {hole}, {}});
        });
        if (!is_valid(piece.polygon)) break;
      }
      for (std::size_t i = 0; i < ring.ring.size(); ++i) {
        piece.edges.push_back({ring.ring[i], ring.ring[(i + 1) % ring.ring.size()], ring.kinds[i],
                               ring.gaps[i], ring.wavers[i]});
      }
      piece.area = piece.polygon.area();
      pieces.push_back(std::move(piece));
      break;
    }
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    if (a.area != b.area) return a.area > b.area;
    const auto& p = a.polygon.outer.front();
    const auto& q = b.polygon.outer.front();
    return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y();
  });
  std::vector<Polygon> polygons;
  for (Piece& piece : pieces) {
    if (edges != nullptr) edges->insert(edges->end(), piece.edges.begin(), piece.edges.end());
    polygons.push_back(std::move(piece.polygon));
  }
  return polygons;
}

OutlineShare hidden_share(const Outline& outline) {
  OutlineShare share;
  for (const BoundaryRing& ring : outline.rings) {
    if (ring.nodes.size() < smallest_ring) continue;
    for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
      const double length = (outline.nodes[ring.nodes[(i + 1) % ring.nodes.size()]].position -
                             outline.nodes[ring.nodes[i]].position)
                                .norm();
      const bool hidden =
          ring.kinds[i] == EdgeKind::occlusion || ring.kinds[i] == EdgeKind::view_limit;
      if (ring.area > 0.0) {
        share.total += length;
        if (hidden) share.hidden += length;
      } else if (hidden) {
        share.hidden_holes += length;
      }
    }
  }
  return share;
}

}  // namespace scanchor
