#include "perception/point_pool.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

constexpr std::uint32_t leaf_points = 6;

struct Link {
  std::uint32_t from, to;
};
// What a block of leaves finds; blocks are put together in their order.
struct Found {
  std::vector<Link> links;
  std::vector<std::uint32_t> region_count;  // a leaf
  std::vector<std::int32_t> regions;
};

// Links gathered by where they come from, in the order they were made: a counting sort.
void to_lists(const std::vector<Found>& blocks, std::size_t leaves,
              std::vector<std::uint32_t>& start, std::vector<std::uint32_t>& lists) {
  start.assign(leaves + 1, 0);
  for (const auto& found : blocks) {
    for (const auto& link : found.links) ++start[link.from];
  }
  std::exclusive_scan(start.begin(), start.end(), start.begin(), 0U);
  lists.resize(start.back());
  for (const auto& found : blocks) {
    for (const auto& link : found.links) lists[start[link.from]++] = link.to;
  }
  // Each is where the next begins now.
  std::move_backward(start.begin(), start.end() - 1, start.end());
  start[0] = 0;
}

// The points without a label.
void gather_points(const CanonicalCloud& cloud, const PlaneLabels& labels, PointPool& pool) {
  constexpr std::size_t block = 8192;
  std::vector<std::size_t> start(cloud.size() / block + 1, 0);
  parallel_blocks(cloud.size(), block, [&](std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count += labels.of_point[i] < 0 ? 1 : 0;
    start[begin / block] = count;
  });
  std::size_t size = 0;
  for (auto& here : start) size += std::exchange(here, size);
  pool.place.resize(size);
  for (auto* v : {&pool.cloud.x, &pool.cloud.y, &pool.cloud.z, &pool.cloud.inverse_range})
    v->resize(size);
  pool.cloud.code.resize(size);
  parallel_blocks(cloud.size(), block, [&](std::size_t begin, std::size_t end) {
    std::size_t to = start[begin / block];
    for (std::size_t i = begin; i < end; ++i) {
      if (labels.of_point[i] >= 0) continue;
      pool.place[to] = static_cast<std::uint32_t>(i);
      pool.cloud.x[to] = cloud.x[i];
      pool.cloud.y[to] = cloud.y[i];
      pool.cloud.z[to] = cloud.z[i];
      pool.cloud.inverse_range[to] = cloud.inverse_range[i];
      pool.cloud.code[to++] = cloud.code[i];
    }
  });
}

}  // namespace

PointPool point_pool(const CanonicalCloud& cloud, const CellTree& tree, const PlaneLabels& labels,
                     const std::vector<std::int32_t>& region_of_cell, double sigma) {
  PointPool pool;
  pool.cloud.low = cloud.low;
  pool.cloud.side = cloud.side;
  gather_points(cloud, labels, pool);
  pool.tree = cell_tree(pool.cloud, leaf_points, 2.5 * sigma);
  std::vector<std::uint32_t> leaf_of_cell(pool.tree.cells.size(), 0);
  for (std::uint32_t c = 0; c < pool.tree.cells.size(); ++c) {
    if (pool.tree.cells[c].children != 0) continue;
    leaf_of_cell[c] = static_cast<std::uint32_t>(pool.leaf.size());
    pool.leaf.push_back(c);
  }
  constexpr std::size_t block = 512;
  std::vector<Found> blocks((pool.leaf.size() + block - 1) / block);
  const auto never = [](std::uint32_t) { return false; };
  const auto taken = [&](std::uint32_t at) { return region_of_cell[at] >= 0; };
  parallel_blocks(pool.leaf.size(), block, [&](std::size_t begin, std::size_t end) {
    Found& found = blocks[begin / block];
    auto& links = found.links;
    links.reserve(24 * (end - begin));
    std::array<std::uint64_t, 26> codes;
    std::vector<std::uint32_t> coarse;
    CellTree::Path path_in_tree, path_in_pool;
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const Cell& cell = pool.cell(l);
      coarse.clear();
      const auto first_region = static_cast<std::ptrdiff_t>(found.regions.size());
      // Places in the flat cell that was met last lead to it again.
      std::uint64_t last = 0;
      int last_shift = -1;
      const auto touch = [&](std::uint64_t code) {
        if (last_shift >= 0 && code >> last_shift == last) return;
        const auto flat = tree.find_near(path_in_tree, code, cell.level, taken);
        if (flat == CellTree::none || region_of_cell[flat] < 0) return;
        last_shift = 3 * (CanonicalCloud::levels - tree.cells[flat].level);
        last = code >> last_shift;
        if (std::find(found.regions.begin() + first_region, found.regions.end(),
                      region_of_cell[flat]) == found.regions.end())
          found.regions.push_back(region_of_cell[flat]);
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
      found.region_count.push_back(static_cast<std::uint32_t>(
          found.regions.size() - static_cast<std::size_t>(first_region)));
    }
  });
  parallel_blocks(2, 1, [&](std::size_t task, std::size_t) {
    if (task == 0) {
      to_lists(blocks, pool.leaf.size(), pool.start, pool.to);
      return;
    }
    pool.region_start.assign(1, 0);
    for (const auto& found : blocks) {
      pool.regions.insert(pool.regions.end(), found.regions.begin(), found.regions.end());
      for (const auto count : found.region_count)
        pool.region_start.push_back(pool.region_start.back() + count);
    }
  });
  return pool;
}

}  // namespace scanchor
