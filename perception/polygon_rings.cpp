#include "perception/polygon_rings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace scanchor {
namespace {

bool before(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

/// How far one turns left from direction a to direction b, (-pi, pi].
double left_turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

/// Rotates the ring so that it begins at its smallest node, and measures it.
BoundaryRing finish(const std::vector<Eigen::Vector2d>& nodes,
                    std::vector<std::uint32_t> ring_nodes, std::vector<EdgeKind> kinds,
                    std::uint32_t component) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < ring_nodes.size(); ++i) {
    if (before(nodes[ring_nodes[i]], nodes[ring_nodes[first]])) first = i;
  }
  std::rotate(ring_nodes.begin(), ring_nodes.begin() + static_cast<std::ptrdiff_t>(first),
              ring_nodes.end());
  std::rotate(kinds.begin(), kinds.begin() + static_cast<std::ptrdiff_t>(first), kinds.end());
  Ring ring(ring_nodes.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = nodes[ring_nodes[i]];
  return {std::move(ring_nodes), std::move(kinds), component, ring_area(ring)};
}

/// A millionth of the shorter edge into the region on the right of a ring at its vertex i.
Eigen::Vector2d moved_right(const Ring& ring, std::size_t i) {
  const Eigen::Vector2d& p = ring[i];
  const Eigen::Vector2d to = ring[(i + 1) % ring.size()] - p;
  const Eigen::Vector2d from = ring[(i + ring.size() - 1) % ring.size()] - p;
  Eigen::Vector2d middle = to.normalized() + from.normalized();
  const double turn = to.x() * from.y() - to.y() * from.x();  // positive: from lies left of to
  if (middle.norm() < 1e-9)
    middle = Eigen::Vector2d(to.y(), -to.x());
  else if (turn > 0.0)
    middle = -middle;  // the wedge between the edges lies on the left
  return p + 1e-6 * std::min(to.norm(), from.norm()) * middle.normalized();
}

}  // namespace

std::vector<BoundaryRing> chain_rings(const std::vector<Eigen::Vector2d>& nodes,
                                      const std::vector<BoundarySegment>& segments) {
  // Segments by their first node: begin[n] .. begin[n + 1] are those that leave node n.
  std::vector<std::uint32_t> begin(nodes.size() + 1, 0);
  for (const auto& s : segments) ++begin[s.from + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> leaving(segments.size());
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  for (std::uint32_t i = 0; i < segments.size(); ++i) leaving[fill[segments[i].from]++] = i;

  std::vector<char> used(segments.size(), 0);
  std::vector<std::int32_t> place(nodes.size(), -1);  // of a node in the path, -1: not in it
  std::vector<BoundaryRing> rings;
  std::vector<std::uint32_t> path;  // segments walked and not yet closed to a ring
  for (std::uint32_t start = 0; start < segments.size(); ++start) {
    if (used[start]) continue;
    path.clear();
    std::uint32_t current = start;
    while (true) {
      used[current] = 1;
      place[segments[current].from] = static_cast<std::int32_t>(path.size());
      path.push_back(current);
      const std::uint32_t at = segments[current].to;
      if (place[at] >= 0) {  // back at a node of the path: what lies between is a ring
        const auto cut = static_cast<std::size_t>(place[at]);
        std::vector<std::uint32_t> ring_nodes;
        std::vector<EdgeKind> kinds;
        for (std::size_t i = cut; i < path.size(); ++i) {
          ring_nodes.push_back(segments[path[i]].from);
          kinds.push_back(segments[path[i]].kind);
          place[segments[path[i]].from] = -1;
        }
        if (ring_nodes.size() >= 3) {
          rings.push_back(finish(nodes, std::move(ring_nodes), std::move(kinds),
                                 segments[path[cut]].component));
        }
        path.resize(cut);
        if (path.empty()) break;
      }
      // The sharpest turn to the left stays with the same piece of the region.
      const Eigen::Vector2d arriving = nodes[at] - nodes[segments[path.back()].from];
      bool found = false;
      double best = 0.0;
      for (std::uint32_t k = begin[at]; k < begin[at + 1]; ++k) {
        if (used[leaving[k]]) continue;
        const double turn = left_turn(arriving, nodes[segments[leaving[k]].to] - nodes[at]);
        if (!found || turn > best) {
          best = turn;
          current = leaving[k];
          found = true;
        }
      }
      if (!found) break;  // an open chain: only from input that breaks the precondition
    }
    for (const std::uint32_t s : path) place[segments[s].from] = -1;
  }
  std::sort(rings.begin(), rings.end(), [&](const BoundaryRing& a, const BoundaryRing& b) {
    if (a.component != b.component) return a.component < b.component;
    if (a.area != b.area) return a.area > b.area;
    return before(nodes[a.nodes.front()], nodes[b.nodes.front()]);
  });
  return rings;
}

std::vector<Polygon> rings_to_polygons(const std::vector<Eigen::Vector2d>& nodes,
                                       const std::vector<BoundaryRing>& rings) {
  std::vector<Polygon> polygons;
  std::uint32_t component = 0;
  for (const BoundaryRing& ring : rings) {
    Ring points;
    for (const std::uint32_t n : ring.nodes) points.push_back(nodes[n]);
    if (ring.area > 0.0) {
      polygons.push_back({std::move(points), {}, ring.kinds});
      component = ring.component;
    } else if (ring.area < 0.0 && !polygons.empty() && ring.component == component) {
      polygons.back().holes.push_back(std::move(points));
    }
  }
  std::stable_sort(polygons.begin(), polygons.end(), [](const Polygon& a, const Polygon& b) {
    const double area_a = a.area();
    const double area_b = b.area();
    return area_a != area_b ? area_a > area_b : before(a.outer.front(), b.outer.front());
  });
  return polygons;
}

void part_touching_holes(Polygon& polygon) {
  const auto less = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return before(a, b); };
  std::set<Eigen::Vector2d, decltype(less)> taken(polygon.outer.begin(), polygon.outer.end(), less);
  for (Ring& hole : polygon.holes) {
    const Ring old = hole;
    for (std::size_t i = 0; i < old.size(); ++i) {
      if (taken.count(old[i]) > 0) hole[i] = moved_right(old, i);
    }
    taken.insert(old.begin(), old.end());
  }
}

}  // namespace scanchor
