#include "perception/point_pool.hpp"

#include <algorithm>
#include <numeric>

namespace scanchor {
namespace {

constexpr std::uint32_t leaf_points = 6;

// Links from -> to, gathered by `from` in the order they were made: a counting sort.
struct Link {
  std::uint32_t from, to;
};
void to_lists(const std::vector<Link>& links, std::size_t leaves, std::vector<std::uint32_t>& start,
              std::vector<std::uint32_t>& lists) {
  start.assign(leaves + 1, 0);
  for (const auto& link : links) ++start[link.from + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  lists.resize(links.size());
  for (const auto& link : links) lists[next[link.from]++] = link.to;
}

}  // namespace

PointPool point_pool(const CanonicalCloud& cloud, const CellTree& tree, const PlaneLabels& labels,
                     const std::vector<std::int32_t>& region_of_cell, double sigma) {
  PointPool pool;
  pool.cloud.low = cloud.low;
  pool.cloud.side = cloud.side;
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    if (labels.of_point[i] >= 0) continue;
    pool.place.push_back(i);
    pool.cloud.x.push_back(cloud.x[i]);
    pool.cloud.y.push_back(cloud.y[i]);
    pool.cloud.z.push_back(cloud.z[i]);
    pool.cloud.inverse_range.push_back(cloud.inverse_range[i]);
    pool.cloud.code.push_back(cloud.code[i]);
  }
  pool.tree = cell_tree(pool.cloud, leaf_points, 2.5 * sigma);
  std::vector<std::uint32_t> leaf_of_cell(pool.tree.cells.size(), 0);
  for (std::uint32_t c = 0; c < pool.tree.cells.size(); ++c) {
    if (pool.tree.cells[c].children != 0) continue;
    leaf_of_cell[c] = static_cast<std::uint32_t>(pool.leaf.size());
    pool.leaf.push_back(c);
  }
  std::vector<Link> links;
  links.reserve(12 * pool.leaf.size());
  std::array<std::uint64_t, 26> codes;
  std::vector<std::uint32_t> coarse;
  const auto never = [](std::uint32_t) { return false; };
  const auto taken = [&](std::uint32_t at) { return region_of_cell[at] >= 0; };
  CellTree::Path path_in_tree, path_in_pool;
  pool.region_start.assign(1, 0);
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    const Cell& cell = pool.cell(l);
    coarse.clear();
    const auto touch = [&](std::uint64_t code) {
      const auto flat = tree.find_near(path_in_tree, code, cell.level, taken);
      if (flat == CellTree::none || region_of_cell[flat] < 0) return;
      const auto known = pool.regions.begin() + pool.region_start.back();
      if (std::find(known, pool.regions.end(), region_of_cell[flat]) == pool.regions.end()) {
        pool.regions.push_back(region_of_cell[flat]);
      }
    };
    const auto here = pool.cloud.code[cell.begin];
    tree.find(here, cell.level, taken, path_in_tree);
    pool.tree.find(here, cell.level, never, path_in_pool);
    touch(here);
    const int count = pool.tree.neighbour_codes(pool.cloud, pool.leaf[l], codes);
    for (int k = 0; k < count; ++k) {
      const auto code = codes[static_cast<std::size_t>(k)];
      touch(code);
      const auto at = pool.tree.find_near(path_in_pool, code, cell.level, never);
      if (at == CellTree::none || pool.tree.cells[at].children != 0)
        continue;  // smaller ones link to this one
      if (pool.tree.cells[at].level == cell.level) {
        links.push_back({l, leaf_of_cell[at]});  // and it links back when its turn comes
      } else if (std::find(coarse.begin(), coarse.end(), at) == coarse.end()) {
        coarse.push_back(at);
        links.push_back({l, leaf_of_cell[at]});
        links.push_back({leaf_of_cell[at], l});
      }
    }
    pool.region_start.push_back(static_cast<std::uint32_t>(pool.regions.size()));
  }
  to_lists(links, pool.leaf.size(), pool.start, pool.to);
  return pool;
}

}  // namespace scanchor
