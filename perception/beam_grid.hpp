#pragma once
// The points as the sensor saw them: a grid of directions about as fine as the beams lie, so that
// "next to each other" means that no beam went between.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "perception/canonical_cloud.hpp"

namespace scanchor {

/// Where the beam of each point meets a cube around the sensor.
struct BeamPlaces {
  int side = 1;                         ///< cells along the side of a face
  std::vector<std::uint32_t> of_point;  ///< face << 20 | row << 10 | column
};
BeamPlaces place_beams(const CanonicalCloud& cloud, const Eigen::Vector3d& sensor);

/// Cells of a cube around the sensor, each face divided evenly, 1.1 spacings of the beams wide
/// where the median beam lies, wider where beams lie closer one way than the other. They are kept
/// in tiles of 8 x 8, and only those that hold a point; all others are one empty tile, the first.
class BeamGrid {
 public:
  static constexpr std::uint32_t cells_per_tile = 64;  ///< consecutive ones; the last is whole too

  BeamGrid(const CanonicalCloud& cloud, const Eigen::Vector3d& sensor)
      : BeamGrid(place_beams(cloud, sensor)) {}
  explicit BeamGrid(BeamPlaces places);
  [[nodiscard]] std::size_t tile_count() const { return spot_of_tile_.size(); }
  /// The tiles around a tile, three by three, the tile itself in the middle, where all cells up to
  /// two from its own lie on the same face; false elsewhere. Precondition: the tile holds a point.
  [[nodiscard]] bool tiles_around(std::uint32_t tile, std::array<std::uint32_t, 9>& around) const {
    const Spot& at = spot_of_tile_[tile];
    if (at.x < 1 || at.y < 1 || 8 * at.x + 10 > side_ || 8 * at.y + 10 > side_) return false;
    for (int k = 0; k < 9; ++k)
      around[static_cast<std::size_t>(k)] = tile_at_[static_cast<std::size_t>(
          (at.face * tiles_ + at.y + k / 3 - 1) * tiles_ + at.x + k % 3 - 1)];
    return true;
  }
  [[nodiscard]] std::size_t cell_count() const { return start_.size() - 1; }
  [[nodiscard]] std::uint32_t cell_of_point(std::size_t i) const { return cell_of_point_[i]; }
  /// The cell in a direction from the sensor; one without points where nothing was met.
  [[nodiscard]] std::uint32_t cell_towards(const Eigen::Vector3f& direction) const {
    return cell_at(spot(direction, side_));
  }
  /// Does the cell lie at the edge of its tile?
  [[nodiscard]] static bool is_on_rim(std::uint32_t cell) {
    return ((cell + 1U) & 6U) == 0 || (((cell >> 3) + 1U) & 6U) == 0;  // 0 or 7
  }
  /// Points of a cell, rising.
  [[nodiscard]] std::span<const std::uint32_t> points(std::uint32_t cell) const {
    return {order_.data() + start_[cell], order_.data() + start_[cell + 1]};
  }
  /// Cells up to `Reach` away in both directions, as (2 Reach + 1)^2 indices row by row, the cell
  /// itself in the middle; over the edge of a face the cell in that direction on the next one.
  /// Precondition: the cell holds a point.
  template <int Reach>
  [[nodiscard]] std::array<std::uint32_t, (2 * Reach + 1) * (2 * Reach + 1)> around(
      std::uint32_t cell) const {
    std::array<std::uint32_t, (2 * Reach + 1) * (2 * Reach + 1)> cells;
    const int in_x = static_cast<int>(cell & 7U), in_y = static_cast<int>(cell >> 3 & 7U);
    std::size_t k = 0;
    if (in_x >= Reach && in_y >= Reach && in_x + Reach < 8 && in_y + Reach < 8) {
      for (int dy = -Reach; dy <= Reach; ++dy) {
        for (int dx = -Reach; dx <= Reach; ++dx)
          cells[k++] = cell + static_cast<std::uint32_t>(8 * dy + dx);
      }
      return cells;
    }
    const Spot tile = spot_of_tile_[cell >> 6];
    const int x = 8 * tile.x + in_x, y = 8 * tile.y + in_y;
    if (x >= Reach && y >= Reach && x + Reach < side_ && y + Reach < side_) {
      for (int dy = -Reach; dy <= Reach; ++dy) {
        // A row lies in one tile or in two.
        const auto* const row = tile_at_.data() + (tile.face * tiles_ + ((y + dy) >> 3)) * tiles_;
        const int split = (x + Reach) & ~7;
        const auto below = static_cast<std::uint32_t>(((y + dy) & 7) << 3);
        const std::uint32_t left = row[(x - Reach) >> 3] << 6 | below,
                            right = row[(x + Reach) >> 3] << 6 | below;
        for (int dx = -Reach; dx <= Reach; ++dx)
          cells[k++] = (x + dx < split ? left : right) | static_cast<std::uint32_t>((x + dx) & 7);
      }
      return cells;
    }
    for (int dy = -Reach; dy <= Reach; ++dy) {
      for (int dx = -Reach; dx <= Reach; ++dx) {
        const bool on_face = x + dx >= 0 && y + dy >= 0 && x + dx < side_ && y + dy < side_;
        cells[k++] = cell_at(on_face ? Spot{tile.face, x + dx, y + dy}
                                     : beyond_face(tile.face, x + dx, y + dy));
      }
    }
    return cells;
  }

 private:
  struct Spot {
    int face, x, y;
  };
  [[nodiscard]] std::uint32_t cell_at(const Spot& at) const {
    return tile_at_[static_cast<std::size_t>((at.face * tiles_ + (at.y >> 3)) * tiles_ +
                                             (at.x >> 3))]
               << 6 |
           static_cast<std::uint32_t>((at.y & 7) << 3 | (at.x & 7));
  }
  [[nodiscard]] Spot beyond_face(int face, int x, int y) const;
  static Spot spot(const Eigen::Vector3f& direction, int side);

  int side_ = 1, tiles_ = 1;            // cells and tiles along the side of a face
  std::vector<std::uint32_t> tile_at_;  // number of the tile by face and place, 0: empty
  std::vector<Spot> spot_of_tile_;      // x and y count tiles
  std::vector<std::uint32_t> cell_of_point_, start_, order_;
};

}  // namespace scanchor
