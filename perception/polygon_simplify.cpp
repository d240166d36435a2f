#include "perception/polygon_simplify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace scanchor {
namespace {

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b) {
  const Eigen::Vector2d d = b - a;
  const double squared = d.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(d) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

struct Line {
  Eigen::Vector2d point, direction;
};

/// Line through the vertices from..to (around the ring) by total least squares, without the two at
/// the corners, which belong to the neighbours as much; nothing if fewer than four are left.
std::optional<Line> fit_line(const Ring& ring, std::uint32_t from, std::uint32_t to) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  const std::uint32_t steps = (to + n - from) % n;
  if (steps < 5) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::uint32_t k = 1; k < steps; ++k) mean += ring[(from + k) % n];
  mean /= steps - 1;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::uint32_t k = 1; k < steps; ++k) {
    const Eigen::Vector2d d = ring[(from + k) % n] - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  if (xx + yy <= 0.0) return std::nullopt;
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  return Line{mean, {std::cos(angle), std::sin(angle)}};
}

Eigen::Vector2d project(const Line& line, const Eigen::Vector2d& p) {
  return line.point + (p - line.point).dot(line.direction) * line.direction;
}

}  // namespace

std::vector<std::uint32_t> simplify(const RoughRing& ring) {
  const auto n = static_cast<std::uint32_t>(ring.points.size());
  std::vector<std::uint32_t> kept;
  if (n <= 4) {
    for (std::uint32_t i = 0; i < n; ++i) kept.push_back(i);
    return kept;
  }
  // Two vertices that are corners for certain: the farthest from the middle, and the farthest from
  // that.
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& p : ring.points) middle += p;
  middle /= n;
  const auto farthest = [&](const Eigen::Vector2d& from) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < n; ++i) {
      if ((ring.points[i] - from).squaredNorm() > (ring.points[best] - from).squaredNorm())
        best = i;
    }
    return best;
  };
  const std::uint32_t first = farthest(middle);
  const std::uint32_t second = farthest(ring.points[first]);
  if (first == second) return {0, 1, 2};
  std::vector<char> keep(n, 0);
  keep[first] = keep[second] = 1;
  struct Span {
    std::uint32_t from, steps;
  };
  std::vector<Span> open = {{first, (second + n - first) % n}, {second, (first + n - second) % n}};
  while (!open.empty()) {
    const Span span = open.back();
    open.pop_back();
    const auto& a = ring.points[span.from];
    const auto& b = ring.points[(span.from + span.steps) % n];
    double worst = 1.0;
    std::uint32_t at = 0;
    std::uint32_t i = span.from;
    for (std::uint32_t k = 1; k < span.steps; ++k) {
      i = i + 1 < n ? i + 1 : 0;
      const double ratio = distance_to_segment(ring.points[i], a, b) / ring.tolerance[i];
      if (ratio > worst) {
        worst = ratio;
        at = k;
      }
    }
    if (at == 0) continue;
    keep[(span.from + at) % n] = 1;
    open.push_back({span.from, at});
    open.push_back({(span.from + at) % n, span.steps - at});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    if (keep[i]) kept.push_back(i);
  }
  if (kept.size() < 3) {  // a sliver within the tolerance: its widest place is the third corner
    std::uint32_t widest = 0;
    double width = -1.0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double d = distance_to_segment(ring.points[i], ring.points[first], ring.points[second]);
      if (!keep[i] && d > width) {
        width = d;
        widest = i;
      }
    }
    kept.insert(std::lower_bound(kept.begin(), kept.end(), widest), widest);
  }
  return kept;
}

Ring straighten(const RoughRing& ring, const std::vector<std::uint32_t>& kept) {
  const std::size_t m = kept.size();
  std::vector<std::optional<Line>> lines(m);
  for (std::size_t i = 0; i < m; ++i) lines[i] = fit_line(ring.points, kept[i], kept[(i + 1) % m]);
  Ring result(m);
  for (std::size_t i = 0; i < m; ++i) {
    const Eigen::Vector2d& old = ring.points[kept[i]];
    const auto& before = lines[(i + m - 1) % m];
    const auto& after = lines[i];
    Eigen::Vector2d moved = old;
    if (before && after) {
      const Eigen::Vector2d& u = before->direction;
      const Eigen::Vector2d& v = after->direction;
      const double cross = u.x() * v.y() - u.y() * v.x();
      const Eigen::Vector2d between = after->point - before->point;
      if (std::abs(cross) > 0.25) {  // sharper than about 15 degrees
        moved = before->point + (between.x() * v.y() - between.y() * v.x()) / cross * u;
      } else {
        moved = 0.5 * (project(*before, old) + project(*after, old));
      }
    } else if (before) {
      moved = project(*before, old);
    } else if (after) {
      moved = project(*after, old);
    }
    result[i] = (moved - old).norm() <= 3.0 * ring.tolerance[kept[i]] ? moved : old;
  }
  return result;
}

}  // namespace scanchor
