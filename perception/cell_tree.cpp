#include "perception/cell_tree.hpp"

#include <algorithm>

namespace scanchor {
namespace {

constexpr int shift_of(int level) { return 3 * (CanonicalCloud::levels - level); }

}  // namespace

CellTree cell_tree(const CanonicalCloud& cloud, std::uint32_t largest) {
  CellTree tree;
  const auto n = static_cast<std::uint32_t>(cloud.size());
  if (n == 0) return tree;
  tree.cells.reserve(n / 2 + 16);
  tree.cells.push_back({0, n});
  for (std::size_t i = 0; i < tree.cells.size(); ++i) {  // breadth first: the vector is the queue
    const Cell cell = tree.cells[i];
    if (cell.size() <= largest || cell.level == CanonicalCloud::levels) continue;
    const int level = cell.level + 1;
    const int shift = shift_of(level);
    tree.cells[i].child = static_cast<std::uint32_t>(tree.cells.size());
    std::uint32_t begin = cell.begin;
    while (begin < cell.end) {
      const std::uint64_t prefix = cloud.code[begin] >> shift;
      const auto* const codes = cloud.code.data();
      const auto end = static_cast<std::uint32_t>(
          std::upper_bound(codes + begin, codes + cell.end, prefix,
                           [shift](std::uint64_t p, std::uint64_t code) { return p < (code >> shift); }) -
          codes);
      Cell child{begin, end};
      child.level = static_cast<std::uint8_t>(level);
      tree.cells.push_back(child);
      ++tree.cells[i].children;
      begin = end;
    }
  }
  tree.moments.resize(tree.cells.size());
  for (std::size_t i = tree.cells.size(); i-- > 0;) {
    const Cell& cell = tree.cells[i];
    Moments& sum = tree.moments[i];
    if (cell.children == 0) {
      for (auto p = cell.begin; p < cell.end; ++p) sum.add(cloud.x[p], cloud.y[p], cloud.z[p]);
    } else {
      for (std::uint32_t c = 0; c < cell.children; ++c) sum.add(tree.moments[cell.child + c]);
    }
  }
  return tree;
}

std::int64_t CellTree::find(const CanonicalCloud& cloud, std::uint64_t code, int level) const {
  std::int64_t at = 0;
  for (;;) {
    const Cell& cell = cells[static_cast<std::size_t>(at)];
    if (cell.children == 0 || cell.level >= level) return at;
    const int shift = shift_of(cell.level + 1);
    std::int64_t next = -1;
    for (std::uint32_t c = 0; c < cell.children; ++c) {
      if (cloud.code[cells[cell.child + c].begin] >> shift == code >> shift) next = cell.child + c;
    }
    if (next < 0) return -1;
    at = next;
  }
}

}  // namespace scanchor
