#pragma once
// The points as the sensor saw them: a grid of directions about as fine as the beams lie, so that
// "next to each other" means that no beam went between.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/canonical_cloud.hpp"

namespace scanchor {

/// Cells of a cube around the sensor, each face divided evenly, 1.1 spacings of the beams wide
/// where the median beam lies.
class BeamGrid {
 public:
  BeamGrid(const CanonicalCloud& cloud, const Eigen::Vector3d& sensor);
  [[nodiscard]] std::size_t cell_count() const { return start_.size() - 1; }
  [[nodiscard]] std::uint32_t cell_of_point(std::size_t i) const { return cell_of_point_[i]; }
  /// Points of a cell, rising.
  [[nodiscard]] std::span<const std::uint32_t> points(std::uint32_t cell) const {
    return {order_.data() + start_[cell], order_.data() + start_[cell + 1]};
  }
  /// Cells up to `Reach` away in both directions, as (2 Reach + 1)^2 indices row by row, the cell
  /// itself in the middle; over the edge of a face the cell in that direction on the next one.
  template <int Reach>
  [[nodiscard]] std::array<std::uint32_t, (2 * Reach + 1) * (2 * Reach + 1)> around(
      std::uint32_t cell) const {
    std::array<std::uint32_t, (2 * Reach + 1) * (2 * Reach + 1)> cells;
    const auto side = static_cast<std::uint32_t>(side_);
    const std::uint32_t row = over_side(cell), face = over_side(row);
    const int x = static_cast<int>(cell - row * side), y = static_cast<int>(row - face * side);
    const bool inside = x >= Reach && y >= Reach && x + Reach < side_ && y + Reach < side_;
    std::size_t k = 0;
    if (inside) {
      for (int dy = -Reach; dy <= Reach; ++dy) {
        for (int dx = -Reach; dx <= Reach; ++dx)
          cells[k++] = cell + static_cast<std::uint32_t>(dy * side_ + dx);
      }
      return cells;
    }
    for (int dy = -Reach; dy <= Reach; ++dy) {
      for (int dx = -Reach; dx <= Reach; ++dx) {
        const bool on_face = x + dx >= 0 && y + dy >= 0 && x + dx < side_ && y + dy < side_;
        cells[k++] = on_face ? cell + static_cast<std::uint32_t>(dy * side_ + dx)
                             : beyond_face(static_cast<int>(face), x + dx, y + dy);
      }
    }
    return cells;
  }

 private:
  // A division by the side: exact, since v * side stays below 2^40.
  [[nodiscard]] std::uint32_t over_side(std::uint32_t v) const {
    return static_cast<std::uint32_t>(v * one_over_side_ >> 40);
  }
  [[nodiscard]] std::uint32_t beyond_face(int face, int x, int y) const;
  int side_ = 1;
  std::uint64_t one_over_side_ = 0;  // times 2^40, rounded up
  std::vector<std::uint32_t> cell_of_point_, start_, order_;
};

}  // namespace scanchor
