#include "perception/tile_fill.hpp"

namespace scanchor {

void TileFill::clear() {
  for (const auto tile : tiles_) own_[tile] = waiting_[tile] = pending_[tile] = 0;
  tiles_.clear();
  queue_.clear();
  ++now_;
}

bool TileFill::waits_near(std::uint32_t cell) {
  const auto tile = cell >> 6;
  if (near_of_[tile] != now_) {
    near_[tile] = cells_with_waiting_near(tile);
    near_of_[tile] = asked_ = now_;
  }
  return (near_[tile] & bit_of(cell)) != 0;
}

std::uint64_t TileFill::cells_with_waiting_near(std::uint32_t tile) const {
  std::array<std::uint32_t, 9> tiles{};
  if (!grid_.tiles_around(tile, tiles)) return ~std::uint64_t{0};
  constexpr std::uint64_t first = 0x0101010101010101U, two = first | first << 1;
  // Up to two to the left and right in a row of tiles, then up to two above and below.
  const auto across = [&](std::size_t middle) {
    const std::uint64_t before = waiting_[tiles[middle - 1]], here = waiting_[tiles[middle]],
                        after = waiting_[tiles[middle + 1]];
    return here | (here << 1 & ~first) | (here << 2 & ~two) | (here >> 1 & ~(first << 7)) |
           (here >> 2 & ~(two << 6)) | (before >> 7 & first) | (before >> 6 & two) |
           (after << 7 & first << 7) | (after << 6 & two << 6);
  };
  const std::uint64_t above = across(1), here = across(4), below = across(7);
  return here | here << 8 | here << 16 | here >> 8 | here >> 16 | above >> 56 | above >> 48 |
         below << 56 | below << 48;
}

std::uint64_t TileFill::spread(std::uint32_t tile, std::uint64_t bits) {
  std::uint64_t rim = 0;
  std::array<std::uint32_t, 9> tiles{};
  if (!grid_.tiles_around(tile, tiles)) {  // over the edge of a face cells lie as they do
    for (std::uint64_t left = bits; left != 0; left &= left - 1) {
      const auto at = static_cast<std::uint32_t>(std::countr_zero(left));
      for (const auto next : grid_.around<1>(tile << 6 | at)) {
        if ((own_[next >> 6] & bit_of(next)) == 0) rim |= left & ~(left - 1);
        if (is_waiting(next)) reach(next);
      }
    }
    return rim;
  }
  constexpr std::uint64_t column = 0x0101010101010101U;
  // The tile with the columns to its left and right, then with rows above and below: a cell is at
  // the rim unless all nine of its square are there.
  const auto across = [&](std::size_t middle) {
    const std::uint64_t here = own_[tiles[middle]];
    const std::uint64_t before = (here << 1 & ~column) | (own_[tiles[middle - 1]] >> 7 & column);
    const std::uint64_t after =
        (here >> 1 & ~(column << 7)) | (own_[tiles[middle + 1]] << 7 & column << 7);
    return here & before & after;
  };
  const std::uint64_t middle = across(4);
  const std::uint64_t full =
      middle & (middle << 8 | across(1) >> 56) & (middle >> 8 | across(7) << 56);
  rim = bits & ~full;

  const std::uint64_t wide = bits | (bits << 1 & ~column) | (bits >> 1 & ~(column << 7));
  const std::uint64_t tall = bits | bits << 8 | bits >> 8;
  reach(tiles[1], wide << 56);            // its last row beside our first
  reach(tiles[7], wide >> 56);            // its first row
  reach(tiles[3], (tall & column) << 7);  // its last column
  reach(tiles[5], tall >> 7 & column);    // its first column
  reach(tiles[0], (bits & 1U) << 63);
  reach(tiles[2], (bits >> 7 & 1U) << 56);
  reach(tiles[6], (bits >> 56 & 1U) << 7);
  reach(tiles[8], bits >> 63);
  return rim;
}

}  // namespace scanchor
