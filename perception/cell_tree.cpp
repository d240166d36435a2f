#include "perception/cell_tree.hpp"

#include <algorithm>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

constexpr int shift_of(int level) { return 3 * (CanonicalCloud::levels - level); }

// Appends the children of a cell; its `child` counts from the first of `children`.
void divide(const CanonicalCloud& cloud, int level, Cell& cell, std::vector<Cell>& children) {
  constexpr std::uint32_t few = 48;  // are looked through quicker than they are halved
  const int shift = shift_of(level);
  const auto* const codes = cloud.code.data();
  cell.child = static_cast<std::uint32_t>(children.size());
  std::uint32_t begin = cell.begin;
  while (begin < cell.end) {
    const std::uint64_t prefix = codes[begin] >> shift;
    auto end = begin + 1;
    if (cell.end - begin <= few) {
      while (end < cell.end && codes[end] >> shift == prefix) ++end;
    } else {
      end =
          static_cast<std::uint32_t>(std::upper_bound(codes + begin, codes + cell.end, prefix,
                                                      [shift](std::uint64_t p, std::uint64_t code) {
                                                        return p < code >> shift;
                                                      }) -
                                     codes);
    }
    Cell child{begin, end};
    child.level = static_cast<std::uint8_t>(level);
    children.push_back(child);
    ++cell.children;
    cell.octants |= static_cast<std::uint8_t>(1U << (prefix & 7U));
    begin = end;
  }
}

}  // namespace

CellTree cell_tree(const CanonicalCloud& cloud, std::uint32_t largest, double least_side) {
  CellTree tree;
  const auto n = static_cast<std::uint32_t>(cloud.size());
  if (n == 0) return tree;
  tree.cells.reserve(n / 2 + 16);
  tree.cells.push_back({0, n});
  constexpr std::size_t block = 2048;
  // Level by level; a block of parents finds its children, which are put together in order.
  for (std::size_t from = 0, to = 1;
       from < to && tree.cells[from].level < CanonicalCloud::levels;) {
    const int level = tree.cells[from].level + 1;
    if (cloud.cell_side(level) < least_side) break;
    std::vector<std::vector<Cell>> found((to - from + block - 1) / block);
    parallel_blocks(to - from, block, [&](std::size_t begin, std::size_t end) {
      auto& children = found[begin / block];
      for (std::size_t i = from + begin; i < from + end; ++i) {
        if (tree.cells[i].size() > largest) divide(cloud, level, tree.cells[i], children);
      }
    });
    std::vector<std::size_t> start(found.size() + 1, to);
    for (std::size_t k = 0; k < found.size(); ++k) start[k + 1] = start[k] + found[k].size();
    tree.cells.resize(start.back());
    parallel_blocks(to - from, block, [&](std::size_t begin, std::size_t end) {
      const auto& children = found[begin / block];
      const std::size_t at = start[begin / block];
      std::copy(children.begin(), children.end(),
                tree.cells.begin() + static_cast<std::ptrdiff_t>(at));
      for (std::size_t i = from + begin; i < from + end; ++i) {
        if (tree.cells[i].children != 0) tree.cells[i].child += static_cast<std::uint32_t>(at);
      }
    });
    from = to;
    to = tree.cells.size();
  }
  // From the deepest level up: a parent is the sum of its children.
  tree.moments.resize(tree.cells.size());
  for (std::size_t first = 0, to = tree.cells.size(); to > 0; to = first) {
    first = static_cast<std::size_t>(
        std::lower_bound(tree.cells.begin(), tree.cells.begin() + static_cast<std::ptrdiff_t>(to),
                         tree.cells[to - 1].level,
                         [](const Cell& cell, std::uint8_t l) { return cell.level < l; }) -
        tree.cells.begin());
    parallel_blocks(to - first, block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = first + begin; i < first + end; ++i) {
        const Cell& cell = tree.cells[i];
        Moments sum;
        for (std::uint32_t c = 0; c < cell.children; ++c) sum.add(tree.moments[cell.child + c]);
        for (auto p = cell.begin; p < cell.end && cell.children == 0; ++p)
          sum.add(cloud.x[p], cloud.y[p], cloud.z[p]);
        tree.moments[i] = sum;
      }
    });
  }
  return tree;
}

int CellTree::neighbour_codes(const CanonicalCloud& cloud, std::uint32_t at,
                              std::array<std::uint64_t, 26>& codes) const {
  constexpr std::uint64_t axis_bits =
      0x249249249249ULL;  // every third bit: z; shifted by one: y; by two: x
  const int shift = shift_of(cells[at].level);
  const std::uint64_t corner = cloud.code[cells[at].begin] >> shift << shift;
  const std::uint64_t one = std::uint64_t{1} << shift;
  std::array<std::array<std::uint64_t, 3>, 3> along;  // per axis: here, one up, one down
  std::array<std::array<bool, 3>, 3> there;
  for (int axis = 0; axis < 3; ++axis) {
    // Adding with the other axes' bits set carries across them; subtracting with them clear
    // borrows.
    const std::uint64_t mask = axis_bits << axis, others = ~mask;
    const std::uint64_t here = corner & mask;
    const std::uint64_t up = ((here | others) + (one << axis)) & mask;
    const std::uint64_t down = (here - (one << axis)) & mask;
    along[axis] = {here, up, down};
    there[axis] = {true, up > here, here != 0};
  }
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        if ((i | j | k) == 0 || !there[2][i] || !there[1][j] || !there[0][k]) continue;
        codes[static_cast<std::size_t>(count++)] = along[2][i] | along[1][j] | along[0][k];
      }
    }
  }
  return count;
}

}  // namespace scanchor
