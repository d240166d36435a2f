#pragma once
// An octree over a canonical cloud: each cell knows the moments of its points. Since the points are
// in Morton order, a cell is a range of them, and a parent is the sum of its children.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "perception/canonical_cloud.hpp"
#include "perception/moments.hpp"

namespace scanchor {

struct Cell {
  std::uint32_t begin, end;  ///< points
  std::uint32_t child = 0;   ///< index of the first child; 0: none (the root is nobody's child)
  std::uint8_t children =
      0;  ///< children lie next to each other, in Morton order; empty ones are left out
  std::uint8_t octants = 0;  ///< bit i: there is a child with Morton digit i
  std::uint8_t level = 0;    ///< 0: root
  [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

struct CellTree {
  std::vector<Cell> cells;       ///< parents before children
  std::vector<Moments> moments;  ///< one a cell, about the cloud's canonical origin

  /// Walks from the root to the cell that contains the place with this code: ends at `level`, at a
  /// cell without children, or at the first for which `stop` is true. `none` where there are no
  /// points.
  template <class Stop>
  [[nodiscard]] std::uint32_t find(std::uint64_t code, int level, const Stop& stop) const {
    return walk(0, code, level, stop, [](std::uint32_t) {});
  }
  /// The cells on the way to a place, root first.
  struct Path {
    std::uint64_t code = 0;
    std::array<std::uint32_t, CanonicalCloud::levels + 1> cells{};
    int length = 0;
  };
  /// As `find`; keeps the way.
  template <class Stop>
  std::uint32_t find(std::uint64_t code, int level, const Stop& stop, Path& path) const {
    path.code = code;
    path.length = 0;
    return walk(0, code, level, stop, [&](std::uint32_t at) {
      path.cells[static_cast<std::size_t>(path.length++)] = at;
    });
  }
  /// As `find`, for a place near one that was found with the same level and the same `stop`: begins
  /// where the ways part, not at the root.
  template <class Stop>
  [[nodiscard]] std::uint32_t find_near(const Path& path, std::uint64_t code, int level,
                                        const Stop& stop) const {
    const int differs = std::bit_width(code ^ path.code);  // bits, three a level
    const int shared = CanonicalCloud::levels - (differs + 2) / 3;
    const auto from = path.cells[static_cast<std::size_t>(std::min(shared, path.length - 1))];
    return walk(from, code, level, stop, [](std::uint32_t) {});
  }
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  /// Bits set in a byte: the base instruction set has none for it, and a call costs more than the
  /// rest of `find`.
  static constexpr std::array<std::uint8_t, 256> count_bits = [] {
    std::array<std::uint8_t, 256> bits{};
    for (unsigned i = 0; i < 256; ++i) bits[i] = static_cast<std::uint8_t>(std::popcount(i));
    return bits;
  }();

  /// Codes of the up to 26 places one cell's side away from cell `at`, in all directions; returns
  /// their number.
  int neighbour_codes(const CanonicalCloud& cloud, std::uint32_t at,
                      std::array<std::uint64_t, 26>& codes) const;

 private:
  template <class Stop, class Passed>
  std::uint32_t walk(std::uint32_t at, std::uint64_t code, int level, const Stop& stop,
                     const Passed& passed) const {
    for (;;) {
      passed(at);
      const Cell& cell = cells[at];
      if (cell.children == 0 || cell.level >= level || stop(at)) return at;
      const auto octant =
          static_cast<unsigned>(code >> (3 * (CanonicalCloud::levels - 1 - cell.level))) & 7U;
      if (!(cell.octants >> octant & 1U)) return none;
      at = cell.child + count_bits[cell.octants & ((1U << octant) - 1U)];
    }
  }
};

/// Splits cells of more than `largest` points whose children are not smaller than `least_side` [m].
/// Time and memory O(n).
CellTree cell_tree(const CanonicalCloud& cloud, std::uint32_t largest = 8, double least_side = 0.0);

}  // namespace scanchor
