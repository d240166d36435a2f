#pragma once
// An octree over a canonical cloud: each cell knows the moments of its points. Since the points are in Morton order, a cell is a
// range of them, and a parent is the sum of its children.

#include <array>
#include <cstdint>
#include <vector>

#include "perception/canonical_cloud.hpp"
#include "perception/moments.hpp"

namespace scanchor {

struct Cell {
  std::uint32_t begin, end;        ///< points
  std::uint32_t child = 0;         ///< index of the first child; 0: none (the root is nobody's child)
  std::uint8_t children = 0;       ///< children lie next to each other, in Morton order; empty ones are left out
  std::uint8_t level = 0;          ///< 0: root
  [[nodiscard]] std::uint32_t size() const { return end - begin; }
};

struct CellTree {
  std::vector<Cell> cells;         ///< parents before children
  std::vector<Moments> moments;    ///< one a cell, about the cloud's canonical origin

  /// The deepest cell at or above `level` that contains the place with this code, or -1 where there are no points.
  [[nodiscard]] std::int64_t find(const CanonicalCloud& cloud, std::uint64_t code, int level) const;
};

/// Splits cells of more than `largest` points. Time and memory O(n).
CellTree cell_tree(const CanonicalCloud& cloud, std::uint32_t largest = 8);

}  // namespace scanchor
