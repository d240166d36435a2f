#include "results/layout.hpp"

#include <algorithm>
#include <numeric>

#include "core/math.hpp"

namespace scanchor {
namespace {

constexpr double box_gap = 3.0;          // [px] kept free around a box
constexpr double anchor_penalty = 30.0;  // [px] of distance that hiding another anchor is worth
constexpr double crossing_penalty = 60.0;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

bool cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Eigen::Vector2d& d) {
  return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

bool crosses(const Box2& box, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d p(box.x, box.y), q(box.x + box.w, box.y), r(box.x + box.w, box.y + box.h),
      s(box.x, box.y + box.h);
  return cross(a, b, p, r) || cross(a, b, q, s);
}

struct Placed {
  Box2 box;
  Eigen::Vector2d anchor, end;
};

}  // namespace

Eigen::Vector2d Box2::nearest(const Eigen::Vector2d& p) const {
  return {std::clamp(p.x(), x, x + w), std::clamp(p.y(), y, y + h)};
}

std::vector<LabelPlace> place_labels(const std::vector<LabelRequest>& requests,
                                     const std::vector<Box2>& obstacles, const Box2& area) {
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return requests[a].priority > requests[b].priority;
  });
  std::vector<LabelPlace> places(requests.size());
  std::vector<Placed> placed;
  for (const std::size_t index : order) {
    const LabelRequest& request = requests[index];
    double best = 1e300;
    Placed choice;
    for (const double distance : {8.0, 18.0, 32.0, 50.0, 72.0, 98.0, 128.0, 164.0, 210.0}) {
      if (distance >= best) break;
      for (int step = 0; step < 16; ++step) {
        // From straight up, alternating right and left.
        const int side = (step + 1) / 2 * (step % 2 == 1 ? 1 : -1);
        const SinCos angle = portable_sincos(pi / 2 - side * pi / 8);
        const Eigen::Vector2d out(angle.cos, -angle.sin);
        const Eigen::Vector2d center =
            request.anchor + distance * out + out.cwiseProduct(request.size / 2);
        const Box2 box{center.x() - request.size.x() / 2, center.y() - request.size.y() / 2,
                       request.size.x(), request.size.y()};
        if (box.x < area.x || box.y < area.y || box.x + box.w > area.x + area.w ||
            box.y + box.h > area.y + area.h) {
          continue;
        }
        const Box2 wide{box.x - box_gap, box.y - box_gap, box.w + 2 * box_gap, box.h + 2 * box_gap};
        const auto hits = [&](const Box2& other) { return wide.overlaps(other); };
        if (std::any_of(obstacles.begin(), obstacles.end(), hits)) continue;
        if (std::any_of(placed.begin(), placed.end(),
                        [&](const Placed& p) { return hits(p.box); })) {
          continue;
        }
        double cost = distance + 0.5 * step;
        const Eigen::Vector2d end = box.nearest(request.anchor);
        for (const Placed& other : placed) {
          if (cross(request.anchor, end, other.anchor, other.end) ||
              crosses(other.box, request.anchor, end) || crosses(box, other.anchor, other.end)) {
            cost += crossing_penalty;
          }
        }
        for (std::size_t i = 0; i < requests.size(); ++i) {
          if (i != index && wide.contains(requests[i].anchor)) cost += anchor_penalty;
        }
        if (cost < best) {
          best = cost;
          choice = {box, request.anchor, end};
        }
      }
    }
    if (best < 1e300) {
      places[index] = {true, choice.box};
      placed.push_back(choice);
    }
  }
  return places;
}

}  // namespace scanchor
