#pragma once
// Which boxes lie near a place in plan: what relations that need nearness look at.

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace scanchor {

/// A grid over the footprints of boxes. It may return boxes that are not near, never leaves one
/// out.
class PlanGrid {
 public:
  PlanGrid() = default;

  /// `boxes` [m] by number. `everywhere`: numbers that every question returns.
  PlanGrid(const std::vector<Eigen::AlignedBox3d>& boxes,
           const std::vector<std::int32_t>& everywhere);

  /// Numbers, rising, of all boxes that in plan are at most `reach` [m] from `box` along x and
  /// along y. Replaces `numbers`.
  void near(const Eigen::AlignedBox3d& box, double reach, std::vector<std::int32_t>& numbers) const;

 private:
  struct Cells {
    int x0, x1, y0, y1;
  };
  [[nodiscard]] Cells cells_of(const Eigen::AlignedBox3d& box, double reach) const;

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  double cell_ = 1.0;  // [m]
  int nx_ = 0, ny_ = 0;
  std::vector<std::int32_t> start_;       // of each cell in numbers_
  std::vector<std::int32_t> numbers_;     // of the boxes that touch a cell
  std::vector<std::int32_t> everywhere_;  // rising
};

}  // namespace scanchor
