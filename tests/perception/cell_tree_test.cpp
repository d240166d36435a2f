#include "perception/cell_tree.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

CanonicalCloud random_cloud(std::size_t n) {
  SequentialRandom random(7);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < n; ++i) {
    points.emplace_back(5.0 * random.uniform(), 3.0 * random.uniform(),
                        random.chance(0.5) ? 0.0 : random.uniform());
  }
  std::vector<std::uint32_t> all(n);
  std::iota(all.begin(), all.end(), 0U);
  return canonical_cloud(points, all);
}

TEST(CellTree, ChildrenPartitionTheirParent) {
  const auto cloud = random_cloud(4000);
  const auto tree = cell_tree(cloud, 8);
  for (std::size_t i = 0; i < tree.cells.size(); ++i) {
    const Cell& cell = tree.cells[i];
    EXPECT_EQ(tree.moments[i].n, cell.size());
    if (cell.children == 0) {
      EXPECT_LE(cell.size(), 8U);
      continue;
    }
    std::uint32_t at = cell.begin;
    for (std::uint32_t c = 0; c < cell.children; ++c) {
      EXPECT_EQ(tree.cells[cell.child + c].begin, at);
      at = tree.cells[cell.child + c].end;
      EXPECT_EQ(tree.cells[cell.child + c].level, cell.level + 1);
    }
    EXPECT_EQ(at, cell.end);
  }
}

TEST(CellTree, FindEndsAtTheCellOfAPoint) {
  const auto cloud = random_cloud(2000);
  const auto tree = cell_tree(cloud, 8);
  const auto never = [](std::uint32_t) { return false; };
  for (std::uint32_t p = 0; p < cloud.size(); p += 37) {
    const auto at = tree.find(cloud.code[p], CanonicalCloud::levels, never);
    ASSERT_NE(at, CellTree::none);
    EXPECT_LE(tree.cells[at].begin, p);
    EXPECT_GT(tree.cells[at].end, p);
    EXPECT_EQ(tree.find(cloud.code[p], 2, never),
              tree.find(cloud.code[p], 2, [](std::uint32_t) { return false; }));
  }
}

TEST(CellTree, FindNearEndsWhereFindDoes) {
  const auto cloud = random_cloud(3000);
  const auto tree = cell_tree(cloud, 8);
  std::array<std::uint64_t, 26> codes;
  int none = 0, other = 0;
  for (const bool stops : {false, true}) {
    const auto stop = [&](std::uint32_t at) { return stops && tree.cells[at].size() < 40; };
    for (std::uint32_t at = 0; at < tree.cells.size(); ++at) {
      const Cell& cell = tree.cells[at];
      if (cell.children != 0) continue;
      CellTree::Path path;
      const auto own = tree.find(cloud.code[cell.begin], cell.level, stop, path);
      EXPECT_EQ(own, tree.find(cloud.code[cell.begin], cell.level, stop));
      const int count = tree.neighbour_codes(cloud, at, codes);
      for (int k = 0; k < count; ++k) {
        const auto code = codes[static_cast<std::size_t>(k)];
        const auto near = tree.find_near(path, code, cell.level, stop);
        EXPECT_EQ(near, tree.find(code, cell.level, stop));
        none += near == CellTree::none ? 1 : 0;
        other += near != CellTree::none && near != own ? 1 : 0;
      }
    }
  }
  EXPECT_GT(none, 100);
  EXPECT_GT(other, 1000);
}

// Against the definition: decode the coordinates, step, encode.
TEST(CellTree, NeighbourCodesAreTheCellsAround) {
  const auto cloud = random_cloud(2000);
  const auto tree = cell_tree(cloud, 8);
  std::array<std::uint64_t, 26> codes{};
  for (std::uint32_t i = 1; i < tree.cells.size(); i += 13) {
    const int level = tree.cells[i].level, shift = 3 * (CanonicalCloud::levels - level);
    const std::uint64_t prefix = cloud.code[tree.cells[i].begin] >> shift;
    std::array<int, 3> at{};
    for (int bit = 0; bit < level; ++bit) {
      for (int axis = 0; axis < 3; ++axis)
        at[axis] |= static_cast<int>(prefix >> (3 * bit + 2 - axis) & 1U) << bit;
    }
    std::set<std::uint64_t> expected;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const int x = at[0] + dx, y = at[1] + dy, z = at[2] + dz, side = 1 << level;
          if ((dx | dy | dz) == 0 || x < 0 || y < 0 || z < 0 || x >= side || y >= side || z >= side)
            continue;
          expected.insert((spread_bits(static_cast<std::uint64_t>(x)) << 2 |
                           spread_bits(static_cast<std::uint64_t>(y)) << 1 |
                           spread_bits(static_cast<std::uint64_t>(z)))
                          << shift);
        }
      }
    }
    const int count = tree.neighbour_codes(cloud, i, codes);
    EXPECT_EQ(std::set<std::uint64_t>(codes.begin(), codes.begin() + count), expected);
  }
}

TEST(CellTree, EmptyCloud) { EXPECT_TRUE(cell_tree(CanonicalCloud{}).cells.empty()); }

}  // namespace
}  // namespace scanchor
