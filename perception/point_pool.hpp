#pragma once
// The points that no flat cell took: edges, clutter, legs, far rows. They get an octree of their
// own, whose leaves adapt to how sparse these points are, so that "next to" has a meaning for the
// rows of a grazing beam as well as for a dense screen.

#include <cstdint>
#include <vector>

#include "perception/cell_planes.hpp"

namespace scanchor {

struct PointPool {
  CanonicalCloud cloud;  ///< x, y, z, inverse_range and code only
  CellTree tree;
  std::vector<std::uint32_t> place;  ///< index in the whole canonical cloud, a pool point
  std::vector<std::uint32_t> leaf;   ///< cells of `tree` without children
  std::vector<std::uint32_t>
      start;  ///< neighbours of leaf i: to[start[i] .. start[i + 1]), itself not among them
  std::vector<std::uint32_t> to;
  std::vector<std::uint32_t>
      region_start;  ///< regions of flat cells that leaf i touches, in the same form
  std::vector<std::int32_t> regions;

  [[nodiscard]] const Cell& cell(std::uint32_t leaf_index) const {
    return tree.cells[leaf[leaf_index]];
  }
};

/// Leaves hold up to 6 points, more where the noise would drown them (sides under 2.5 sigma).
/// `region_of_cell`: of the whole cloud's tree, from cell_planes.
PointPool point_pool(const CanonicalCloud& cloud, const CellTree& tree, const PlaneLabels& labels,
                     const std::vector<std::int32_t>& region_of_cell, double sigma);

}  // namespace scanchor
