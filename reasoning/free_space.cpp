#include "reasoning/free_space.hpp"

#include <algorithm>
#include <cmath>

#include "core/polygons.hpp"
#include "perception/polygon_check.hpp"

namespace scanchor {
namespace {

constexpr double touching = 1e-9;  // [m] borders belong to the free places

/// Places of the origin of a shape at which it meets the obstacle: counter-clockwise.
struct Forbidden {
  Ring ring;
  Eigen::AlignedBox2d box;
  [[nodiscard]] bool contains(const Eigen::Vector2d& p) const {
    if (!box.contains(p)) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d edge = ring[(i + 1) % ring.size()] - ring[i];
      if (cross2(edge, p - ring[i]) <= touching * edge.norm()) return false;
    }
    return true;
  }
};

Forbidden forbidden(const Ring& obstacle, const Ring& shape) {
  std::vector<Eigen::Vector2d> sums;
  for (const auto& p : obstacle) {
    for (const auto& q : shape) sums.push_back(p - q);
  }
  Forbidden result;
  result.ring = convex_hull(std::move(sums));
  for (const auto& p : result.ring) result.box.extend(p);
  return result;
}

struct Border {
  Eigen::Vector2d from, to;
};

void add_borders(const Ring& ring, std::vector<Border>& borders) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    borders.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

class Fit {
 public:
  Fit(const FreeSpace& space, const Ring& shape, const Ring& window)
      : space_(space), window_(window) {
    Eigen::AlignedBox2d around;
    for (const auto& p : window) around.extend(p);
    const auto add = [&](const Ring& obstacle) {
      Forbidden f = forbidden(obstacle, shape);
      if (f.ring.size() < 3 || !f.box.intersects(around)) return;
      add_borders(f.ring, borders_);
      forbidden_.push_back(std::move(f));
    };
    for (const auto& obstacle : space.obstacles) add(obstacle);
    for (const auto* rings : {&space.outer, &space.holes}) {
      for (const auto& ring : *rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) add({ring[i], ring[(i + 1) % ring.size()]});
      }
    }
    add_borders(window, borders_);
  }

  [[nodiscard]] bool allows(const Eigen::Vector2d& p) const {
    for (std::size_t i = 0; i < window_.size(); ++i) {
      const Eigen::Vector2d edge = window_[(i + 1) % window_.size()] - window_[i];
      if (cross2(edge, p - window_[i]) < -touching * edge.norm()) return false;
    }
    for (const auto& f : forbidden_) {
      if (f.contains(p)) return false;
    }
    const auto holds = [&](const Ring& ring) { return contains(ring, p); };
    return (space_.outer.empty() || std::any_of(space_.outer.begin(), space_.outer.end(), holds)) &&
           std::none_of(space_.holes.begin(), space_.holes.end(), holds);
  }

  [[nodiscard]] std::optional<Eigen::Vector2d> nearest(const Eigen::Vector2d& wanted) const {
    struct Candidate {
      double distance;
      Eigen::Vector2d at;
    };
    std::vector<Candidate> candidates;
    const auto offer = [&](const Eigen::Vector2d& p) {
      candidates.push_back({(p - wanted).squaredNorm(), p});
    };
    offer(wanted);
    for (std::size_t i = 0; i < borders_.size(); ++i) {
      const auto& [a, b] = borders_[i];
      const Eigen::Vector2d edge = b - a;
      offer(a);
      offer(a + edge * std::clamp(edge.dot(wanted - a) / edge.squaredNorm(), 0.0, 1.0));
      for (std::size_t k = i + 1; k < borders_.size(); ++k) {
        const Eigen::Vector2d other = borders_[k].to - borders_[k].from;
        const double turn = cross2(edge, other);
        if (std::abs(turn) < 1e-12 * edge.norm() * other.norm()) continue;
        const Eigen::Vector2d step = borders_[k].from - a;
        const double s = cross2(step, other) / turn;
        const double t = cross2(step, edge) / turn;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) offer(a + s * edge);
      }
    }
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      if (a.distance != b.distance) return a.distance < b.distance;
      return a.at.x() != b.at.x() ? a.at.x() < b.at.x() : a.at.y() < b.at.y();
    });
    for (const auto& candidate : candidates) {
      if (allows(candidate.at)) return candidate.at;
    }
    return std::nullopt;
  }

 private:
  const FreeSpace& space_;
  const Ring& window_;
  std::vector<Forbidden> forbidden_;
  std::vector<Border> borders_;
};

/// [m2] of a simple ring within a convex region.
double common_area(Ring ring, const Ring& region) {
  for (std::size_t i = 0; i < region.size(); ++i)
    clip(ring, region[i], region[(i + 1) % region.size()]);
  return std::abs(area_of(ring));
}

}  // namespace

std::optional<Eigen::Vector2d> nearest_fit(const FreeSpace& space, const Ring& shape,
                                           const Ring& window, const Eigen::Vector2d& wanted) {
  return Fit(space, shape, window).nearest(wanted);
}

double area_within(const FreeSpace& space, const Ring& region) {
  double area = 0.0;
  for (const auto& ring : space.outer) area += common_area(ring, region);
  for (const auto& ring : space.holes) area -= common_area(ring, region);
  return std::max(0.0, area);
}

}  // namespace scanchor
