#pragma once
// Which cells of a beam grid hang together: eight by eight at a time, as bits.

#include <bit>
#include <cstdint>
#include <vector>

#include "perception/beam_grid.hpp"

namespace scanchor {

/// A set of cells, taken out in pieces. All that touches a cell that was reached is reached too.
class TileFill {
 public:
  explicit TileFill(const BeamGrid& grid)
      : grid_(grid),
        own_(grid.tile_count(), 0),
        waiting_(own_),
        pending_(own_),
        near_(own_),
        near_of_(own_.size(), 0) {}

  /// Forgets all cells.
  void clear();
  /// Adds a cell that waits to be taken; false if it was there.
  bool add(std::uint32_t cell) {
    auto& own = own_[cell >> 6];
    const std::uint64_t bit = bit_of(cell);
    if ((own & bit) != 0) return false;
    if (own == 0) tiles_.push_back(cell >> 6);
    if (asked_ == now_) ++now_;  // what was known of neighbours holds no more
    own |= bit;
    waiting_[cell >> 6] |= bit;
    return true;
  }
  [[nodiscard]] bool is_waiting(std::uint32_t cell) const {
    return (waiting_[cell >> 6] & bit_of(cell)) != 0;
  }
  /// May a cell up to two away from this one wait? Cells that waited when the tile was first asked
  /// about count.
  [[nodiscard]] bool waits_near(std::uint32_t cell);
  /// The next piece holds this cell.
  void reach(std::uint32_t cell) { reach(cell >> 6, bit_of(cell)); }

  /// Takes what touches the reached cells, and what touches that: calls taken(tile, cells, rim) for
  /// some of one tile at a time, a bit each; at the rim one has a cell beside it that was never
  /// added.
  template <class Taken>
  void take(const Taken& taken) {
    while (!queue_.empty()) {
      const auto tile = queue_.back();
      queue_.pop_back();
      std::uint64_t bits = pending_[tile] & waiting_[tile];
      pending_[tile] = 0;
      if (bits == 0) continue;
      for (std::uint64_t before = 0; before != bits;) {
        before = bits;
        bits |= beside(bits) & waiting_[tile];
      }
      waiting_[tile] &= ~bits;
      taken(tile, bits, spread(tile, bits));
    }
  }
  /// Calls f for each cell of these bits of a tile.
  template <class F>
  static void each_cell(std::uint32_t tile, std::uint64_t bits, const F& f) {
    for (; bits != 0; bits &= bits - 1)
      f(tile << 6 | static_cast<std::uint32_t>(std::countr_zero(bits)));
  }

 private:
  static std::uint64_t bit_of(std::uint32_t cell) { return std::uint64_t{1} << (cell & 63U); }
  // Cells of a tile up to one to the left and right of some, and up to one above and below those.
  static std::uint64_t beside(std::uint64_t bits) {
    constexpr std::uint64_t first = 0x0101010101010101U;  // the first of each row
    bits |= (bits << 1 & ~first) | (bits >> 1 & ~(first << 7));
    return bits | bits << 8 | bits >> 8;
  }
  void reach(std::uint32_t tile, std::uint64_t bits) {
    if ((bits & waiting_[tile]) == 0) return;
    if (pending_[tile] == 0) queue_.push_back(tile);
    pending_[tile] |= bits;
  }
  [[nodiscard]] std::uint64_t cells_with_waiting_near(std::uint32_t tile) const;
  // Reaches what lies beside these cells in other tiles; returns those at the rim.
  std::uint64_t spread(std::uint32_t tile, std::uint64_t bits);

  const BeamGrid& grid_;
  std::vector<std::uint64_t> own_, waiting_, pending_;  // a bit a cell, by tile
  std::vector<std::uint32_t> tiles_, queue_;            // that hold any; that were reached
  // By tile: cells with one up to two away that waited at the time of `near_of_`.
  std::vector<std::uint64_t> near_;
  std::vector<std::uint32_t> near_of_;
  std::uint32_t now_ = 1, asked_ = 0;
};

}  // namespace scanchor
