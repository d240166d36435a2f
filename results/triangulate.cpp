#include "results/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scanchor {
namespace {

using Point = Eigen::Vector2d;

double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double signed_area(const std::vector<Point>& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return sum / 2.0;
}

bool inside(const Point& a, const Point& b, const Point& c, const Point& p) {
  return cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0;
}

/// Whether p lies in the loop's interior angle at its corner i. Bridges repeat corners: only one
/// copy sees p.
bool opens_towards(const std::vector<int>& loop, const std::vector<Point>& points, std::size_t i,
                   const Point& p) {
  const std::size_t n = loop.size();
  const Point& before = points[std::size_t(loop[(i + n - 1) % n])];
  const Point& here = points[std::size_t(loop[i])];
  const Point& after = points[std::size_t(loop[(i + 1) % n])];
  const bool left_of_first = cross(before, here, p) >= 0.0;
  const bool left_of_second = cross(here, after, p) >= 0.0;
  return cross(before, here, after) >= 0.0 ? left_of_first && left_of_second
                                           : left_of_first || left_of_second;
}

/// Joins a hole to the loop at the visible corner nearest to its rightmost vertex.
void bridge(std::vector<int>& loop, std::vector<int> hole, const std::vector<Point>& points) {
  const auto right_of = [&](int a, int b) {
    return points[std::size_t(a)].x() < points[std::size_t(b)].x();
  };
  std::rotate(hole.begin(), std::max_element(hole.begin(), hole.end(), right_of), hole.end());
  const Point start = points[std::size_t(hole.front())];
  // A ray to the right meets the nearest edge; one of its ends, or a reflex corner in between, sees
  // the hole.
  double nearest = 1e300;
  std::size_t edge = loop.size();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point& a = points[std::size_t(loop[i])];
    const Point& b = points[std::size_t(loop[(i + 1) % loop.size()])];
    if (a.y() > start.y() || b.y() <= start.y()) continue;  // the interior is left of upward edges
    const double x = a.x() + (start.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x >= start.x() && x < nearest) {
      nearest = x;
      edge = i;
    }
  }
  if (edge == loop.size()) return;  // The hole is not inside: leave it filled.
  const std::size_t next = (edge + 1) % loop.size();
  std::size_t best =
      points[std::size_t(loop[edge])].x() > points[std::size_t(loop[next])].x() ? edge : next;
  const Point meet(nearest, start.y());
  const Point candidate = points[std::size_t(loop[best])];
  double best_slope = 1e300;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point& p = points[std::size_t(loop[i])];
    const bool in = candidate.y() < start.y() ? inside(start, candidate, meet, p)
                                              : inside(start, meet, candidate, p);
    if (!in || p.x() <= start.x() || !opens_towards(loop, points, i, start)) continue;
    const double slope = std::abs(p.y() - start.y()) / (p.x() - start.x());
    if (slope < best_slope) {
      best_slope = slope;
      best = i;
    }
  }
  std::vector<int> inserted(hole);
  inserted.push_back(hole.front());
  inserted.push_back(loop[best]);
  loop.insert(loop.begin() + std::ptrdiff_t(best) + 1, inserted.begin(), inserted.end());
}

}  // namespace

std::vector<Eigen::Vector3i> triangulate(const std::vector<std::vector<Eigen::Vector2d>>& rings) {
  std::vector<Eigen::Vector3i> triangles;
  if (rings.empty() || rings[0].size() < 3) return triangles;
  std::vector<Point> points;
  std::vector<std::vector<int>> loops;
  for (const auto& ring : rings) {
    std::vector<int> loop(ring.size());
    std::iota(loop.begin(), loop.end(), int(points.size()));
    const bool outer = loops.empty();
    if ((signed_area(ring) > 0.0) != outer) std::reverse(loop.begin(), loop.end());
    points.insert(points.end(), ring.begin(), ring.end());
    loops.push_back(std::move(loop));
  }
  std::vector<int> loop = std::move(loops[0]);
  std::vector<std::vector<int>> holes;
  for (std::size_t i = 1; i < loops.size(); ++i) {
    if (loops[i].size() >= 3) holes.push_back(std::move(loops[i]));
  }
  const auto rightmost = [&](const std::vector<int>& hole) {
    double x = -1e300;
    for (const int i : hole) x = std::max(x, points[std::size_t(i)].x());
    return x;
  };
  std::stable_sort(holes.begin(), holes.end(),
                   [&](const auto& a, const auto& b) { return rightmost(a) > rightmost(b); });
  for (auto& hole : holes) bridge(loop, std::move(hole), points);

  const auto at = [&](std::size_t i) -> const Point& {
    return points[std::size_t(loop[i % loop.size()])];
  };
  std::size_t ear = 0;
  std::size_t misses = 0;
  while (loop.size() > 3) {
    const std::size_t n = loop.size();
    const std::size_t before = (ear + n - 1) % n;
    const std::size_t after = (ear + 1) % n;
    const Point &a = at(before), &b = at(ear), &c = at(after);
    const double turn = cross(a, b, c);
    bool is_ear = turn > 0.0;
    for (std::size_t i = 0; is_ear && i < n; ++i) {
      if (i == before || i == ear || i == after) continue;
      const Point& p = at(i);
      // Bridges repeat corners: those do not block.
      if (p == a || p == b || p == c) continue;
      if (inside(a, b, c, p)) is_ear = false;
    }
    // After a whole round without an ear the ring is degenerate: cut anyway, dropping what has no
    // area.
    if (is_ear || misses > n) {
      if (turn > 0.0) triangles.emplace_back(loop[before], loop[ear], loop[after]);
      loop.erase(loop.begin() + std::ptrdiff_t(ear));
      misses = 0;
      ear %= loop.size();
    } else {
      ear = after;
      ++misses;
    }
  }
  if (cross(at(0), at(1), at(2)) > 0.0) triangles.emplace_back(loop[0], loop[1], loop[2]);
  return triangles;
}

}  // namespace scanchor
