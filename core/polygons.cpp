#include "core/polygons.hpp"

#include <algorithm>

namespace scanchor {

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area_of(const Ring2& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross2(ring[i], ring[(i + 1) % ring.size()]);
  return ring.size() < 3 ? 0.0 : 0.5 * twice;
}

Ring2 convex_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Ring2 hull(2 * points.size());
  std::size_t n = 0;
  const auto chain = [&](auto begin, auto end, std::size_t floor) {
    for (auto it = begin; it != end; ++it) {
      while (n >= floor + 2 && cross2(hull[n - 1] - hull[n - 2], *it - hull[n - 2]) <= 0) --n;
      hull[n++] = *it;
    }
  };
  chain(points.begin(), points.end(), 0);
  const std::size_t lower = n - 1;
  --n;  // the last point starts the upper chain again
  chain(points.rbegin(), points.rend(), lower);
  hull.resize(n - 1);
  return hull;
}

void clip(Ring2& ring, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d d = b - a;
  Ring2 kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& p = ring[i];
    const Eigen::Vector2d& q = ring[(i + 1) % ring.size()];
    const double dp = cross2(d, p - a);
    const double dq = cross2(d, q - a);
    if (dp >= 0) kept.push_back(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) kept.push_back(p + (dp / (dp - dq)) * (q - p));
  }
  ring = std::move(kept);
}

Ring2 dilated(const Ring2& ring, double r) {
  if (r <= 0) return ring;
  Ring2 points;
  const double s = r * 0.41421356237309503;  // tan(22.5 deg)
  for (const auto& p : ring) {
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        points.emplace_back(p.x() + a * r, p.y() + b * s);
        points.emplace_back(p.x() + a * s, p.y() + b * r);
      }
    }
  }
  return convex_hull(std::move(points));
}

double overlap_share(const Ring2& a, const Ring2& b) {
  const double whole = area_of(a);
  if (whole <= 0) return 0.0;
  Ring2 common = a;
  for (std::size_t i = 0; i < b.size() && !common.empty(); ++i)
    clip(common, b[i], b[(i + 1) % b.size()]);
  return area_of(common) / whole;
}

}  // namespace scanchor
