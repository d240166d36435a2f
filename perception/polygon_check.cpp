#include "perception/polygon_check.hpp"

#include <algorithm>
#include <vector>

namespace scanchor {
namespace {

struct Edge {
  Eigen::Vector2d a, b;
  std::uint32_t ring, index, ring_size;
  [[nodiscard]] double left() const { return std::min(a.x(), b.x()); }
  [[nodiscard]] double right() const { return std::max(a.x(), b.x()); }
};

double turn_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool on_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

bool touch(const Edge& e, const Edge& f) {
  const double d1 = turn_of(f.a, f.b, e.a);
  const double d2 = turn_of(f.a, f.b, e.b);
  const double d3 = turn_of(e.a, e.b, f.a);
  const double d4 = turn_of(e.a, e.b, f.b);
  if (((d1 > 0 && d2 < 0) || (d1 < 0 && d2 > 0)) && ((d3 > 0 && d4 < 0) || (d3 < 0 && d4 > 0)))
    return true;
  return (d1 == 0 && on_segment(f.a, f.b, e.a)) || (d2 == 0 && on_segment(f.a, f.b, e.b)) ||
         (d3 == 0 && on_segment(e.a, e.b, f.a)) || (d4 == 0 && on_segment(e.a, e.b, f.b));
}

/// Neighbours share one vertex; they may not fold back onto each other.
bool folded(const Edge& e, const Edge& f) {
  const Eigen::Vector2d& shared = e.b == f.a ? e.b : e.a;
  const Eigen::Vector2d u = (e.b == f.a ? e.a : e.b) - shared;
  const Eigen::Vector2d v = (e.b == f.a ? f.b : f.a) - shared;
  return u.x() * v.y() - u.y() * v.x() == 0.0 && u.dot(v) > 0.0;
}

void add_edges(const Ring& ring, std::uint32_t number, std::vector<Edge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    edges.push_back({ring[i], ring[(i + 1) % ring.size()], number, static_cast<std::uint32_t>(i),
                     static_cast<std::uint32_t>(ring.size())});
  }
}

/// Sweep from left to right: each edge is held against those that began before it and have not
/// ended.
bool no_contact(std::vector<Edge> edges) {
  for (const Edge& e : edges) {
    if (e.a == e.b) return false;
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& e, const Edge& f) { return e.left() < f.left(); });
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& e = edges[i];
    std::erase_if(active, [&](std::size_t k) { return edges[k].right() < e.left(); });
    for (const std::size_t k : active) {
      const Edge& f = edges[k];
      const bool same = e.ring == f.ring;
      const bool neighbours = same && ((e.index + 1) % e.ring_size == f.index ||
                                       (f.index + 1) % f.ring_size == e.index);
      if (neighbours && e.ring_size > 3 ? folded(e, f) : (!neighbours && touch(e, f))) return false;
      if (neighbours && e.ring_size == 3 && turn_of(e.a, e.b, e.b == f.a ? f.b : f.a) == 0.0)
        return false;
    }
    active.push_back(i);
  }
  return true;
}

}  // namespace

bool is_simple(const Ring& ring) {
  if (ring.size() < 3) return false;
  std::vector<Edge> edges;
  add_edges(ring, 0, edges);
  return no_contact(std::move(edges));
}

bool contains(const Ring& ring, const Eigen::Vector2d& p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const auto& a = ring[i];
    const auto& b = ring[j];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& p) {
  if (!contains(polygon.outer, p)) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [&](const Ring& hole) { return contains(hole, p); });
}

bool is_valid(const Polygon& polygon) {
  if (polygon.outer.size() < 3 || ring_area(polygon.outer) <= 0.0) return false;
  std::vector<Edge> edges;
  add_edges(polygon.outer, 0, edges);
  std::uint32_t number = 0;
  for (const Ring& hole : polygon.holes) {
    if (hole.size() < 3 || ring_area(hole) >= 0.0 || !contains(polygon.outer, hole.front()))
      return false;
    add_edges(hole, ++number, edges);
  }
  return no_contact(std::move(edges));
}

}  // namespace scanchor
