#include "perception/point_pool.hpp"

#include <algorithm>
#include <numeric>

namespace scanchor {
namespace {

constexpr std::uint32_t leaf_points = 6;

// Sorted pairs (leaf << 32 | other) -> lists.
template <class T>
void to_lists(std::vector<std::uint64_t>& pairs, std::size_t leaves, std::vector<std::uint32_t>& start,
              std::vector<T>& lists) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  start.assign(leaves + 1, 0);
  lists.reserve(pairs.size());
  for (const auto pair : pairs) {
    ++start[(pair >> 32) + 1];
    lists.push_back(static_cast<T>(pair & 0xFFFFFFFF));
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
}

}  // namespace

PointPool point_pool(const CanonicalCloud& cloud, const CellTree& tree, const PlaneLabels& labels,
                     const std::vector<std::int32_t>& region_of_cell) {
  PointPool pool;
  pool.cloud.low = cloud.low;
  pool.cloud.side = cloud.side;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (labels.of_point[i] >= 0) continue;
    pool.place.push_back(i);
    pool.cloud.x.push_back(cloud.x[i]);
    pool.cloud.y.push_back(cloud.y[i]);
    pool.cloud.z.push_back(cloud.z[i]);
    pool.cloud.code.push_back(cloud.code[i]);
  }
  pool.tree = cell_tree(pool.cloud, leaf_points);
  std::vector<std::uint32_t> leaf_of_cell(pool.tree.cells.size(), 0);
  for (std::uint32_t c = 0; c < pool.tree.cells.size(); ++c) {
    if (pool.tree.cells[c].children != 0) continue;
    leaf_of_cell[c] = static_cast<std::uint32_t>(pool.leaf.size());
    pool.leaf.push_back(c);
  }
  std::vector<std::uint64_t> pairs, touched;
  std::array<std::uint64_t, 26> codes;
  const auto never = [](std::uint32_t) { return false; };
  const auto taken = [&](std::uint32_t at) { return region_of_cell[at] >= 0; };
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    const Cell& cell = pool.cell(l);
    int count = pool.tree.neighbour_codes(pool.cloud, pool.leaf[l], codes);
    for (int k = 0; k < count; ++k) {
      const auto code = codes[static_cast<std::size_t>(k)];
      const auto at = pool.tree.find(code, cell.level, never);
      if (at != CellTree::none && pool.tree.cells[at].children == 0) {
        pairs.push_back(std::uint64_t{l} << 32 | leaf_of_cell[at]);
        pairs.push_back(std::uint64_t{leaf_of_cell[at]} << 32 | l);
      }
      const auto flat = tree.find(code, cell.level, taken);
      if (flat != CellTree::none && region_of_cell[flat] >= 0) {
        touched.push_back(std::uint64_t{l} << 32 | static_cast<std::uint32_t>(region_of_cell[flat]));
      }
    }
    const auto own = tree.find(pool.cloud.code[cell.begin], cell.level, taken);
    if (own != CellTree::none && region_of_cell[own] >= 0) {
      touched.push_back(std::uint64_t{l} << 32 | static_cast<std::uint32_t>(region_of_cell[own]));
    }
  }
  to_lists(pairs, pool.leaf.size(), pool.start, pool.to);
  to_lists(touched, pool.leaf.size(), pool.region_start, pool.regions);
  return pool;
}

}  // namespace scanchor
