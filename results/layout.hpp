#pragma once
// Labels set on a picture so that they do not overlap.

#include <Eigen/Core>
#include <vector>

namespace scanchor {

/// A rectangle in pixels, y down.
struct Box2 {
  double x = 0, y = 0, w = 0, h = 0;
  [[nodiscard]] bool overlaps(const Box2& other) const {
    return x < other.x + other.w && other.x < x + w && y < other.y + other.h && other.y < y + h;
  }
  [[nodiscard]] bool contains(const Eigen::Vector2d& p) const {
    return p.x() >= x && p.x() <= x + w && p.y() >= y && p.y() <= y + h;
  }
  [[nodiscard]] Eigen::Vector2d nearest(const Eigen::Vector2d& p) const;
};

struct LabelRequest {
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  ///< [px] what it points at
  Eigen::Vector2d size = Eigen::Vector2d::Zero();    ///< [px]
  double priority = 0.0;                             ///< larger ones choose first
};

struct LabelPlace {
  bool placed = false;  ///< false: no room was left near its anchor
  Box2 box;
};

/// Chooses for each label, in order of falling priority (ties: the earlier one), the cheapest free
/// place around its anchor: near is cheap, covering another anchor or crossing another leader is
/// dear. Boxes lie inside `area`, overlap neither each other nor the obstacles. Deterministic.
std::vector<LabelPlace> place_labels(const std::vector<LabelRequest>& requests,
                                     const std::vector<Box2>& obstacles, const Box2& area);

}  // namespace scanchor
