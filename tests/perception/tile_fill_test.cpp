#include "perception/tile_fill.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <set>

#include "core/random.hpp"

namespace scanchor {
namespace {

// Beams all around, so that things lie over the edges and corners of the cube's faces.
CanonicalCloud beams_all_around(int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {  // a spiral: evenly spread
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z), a = 2.399963 * i;
    points.push_back(2.0 * Eigen::Vector3d(r * std::cos(a), r * std::sin(a), z));
  }
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  return canonical_cloud(points, all);
}

struct Piece {
  std::set<std::uint32_t> cells, rim;
  bool operator==(const Piece&) const = default;
};

// One cell after the other.
std::vector<Piece> pieces_cell_by_cell(const BeamGrid& grid,
                                       const std::vector<std::uint32_t>& cells) {
  const std::set<std::uint32_t> own(cells.begin(), cells.end());
  std::set<std::uint32_t> waiting = own;
  std::vector<Piece> pieces;
  for (const auto first : cells) {
    if (waiting.erase(first) == 0) continue;
    Piece piece;
    std::vector<std::uint32_t> queue(1, first);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      piece.cells.insert(queue[head]);
      for (const auto next : grid.around<1>(queue[head])) {
        if (own.count(next) == 0) piece.rim.insert(queue[head]);
        if (waiting.erase(next) != 0) queue.push_back(next);
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

TEST(TileFill, TakesWhatACellByCellSearchTakes) {
  SequentialRandom random(4);
  const auto cloud = beams_all_around(20000);
  const BeamGrid grid(cloud, cloud.T_cloud_canonical.inverse().translation());
  TileFill fill(grid);
  std::size_t several = 0, large = 0, quiet = 0;
  for (int round = 0; round < 60; ++round) {
    // Some caps of the sphere, with more or less of their cells.
    std::vector<std::uint32_t> cells;
    const double share = round % 3 == 0 ? 1.0 : random.uniform(0.2, 0.95);
    fill.clear();
    for (int cap = 0; cap < 3; ++cap) {
      const Eigen::Vector3f axis = cloud.point(random.below(20000)).normalized();
      const float cosine = static_cast<float>(random.uniform(0.6, 0.99));
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (cloud.point(i).normalized().dot(axis) < cosine || random.uniform() > share) continue;
        const auto cell = grid.cell_of_point(i);
        const bool is_new = std::find(cells.begin(), cells.end(), cell) == cells.end();
        EXPECT_EQ(fill.add(cell), is_new);
        if (is_new) cells.push_back(cell);
      }
    }
    std::vector<Piece> pieces;
    for (const auto first : cells) {
      const auto near = grid.around<2>(first);
      if (std::any_of(near.begin(), near.end(), [&](auto c) { return fill.is_waiting(c); })) {
        EXPECT_TRUE(fill.waits_near(first));
      } else {
        quiet += fill.waits_near(first) ? 0 : 1;
      }
      if (!fill.is_waiting(first)) continue;
      Piece piece;
      fill.reach(first);
      fill.take([&](std::uint32_t tile, std::uint64_t some, std::uint64_t at_rim) {
        TileFill::each_cell(tile, some, [&](std::uint32_t cell) {
          EXPECT_TRUE(piece.cells.insert(cell).second) << "each once";
        });
        TileFill::each_cell(tile, at_rim, [&](std::uint32_t cell) { piece.rim.insert(cell); });
      });
      pieces.push_back(piece);
    }
    const auto expected = pieces_cell_by_cell(grid, cells);
    EXPECT_TRUE(pieces == expected) << "round " << round;
    several += pieces.size() > 1 ? 1 : 0;
    large += std::any_of(pieces.begin(), pieces.end(),
                         [](const Piece& p) { return p.cells.size() > 2 * p.rim.size(); })
                 ? 1
                 : 0;
  }
  EXPECT_GT(quiet, 1000U);
  EXPECT_GT(several, 20U);
  EXPECT_GT(large, 3U);
}

TEST(TileFill, WhatWasTakenWaitsNoMore) {
  const auto cloud = beams_all_around(3000);
  const BeamGrid grid(cloud, cloud.T_cloud_canonical.inverse().translation());
  TileFill fill(grid);
  const auto cell = grid.cell_of_point(7);
  EXPECT_TRUE(fill.add(cell));
  EXPECT_FALSE(fill.add(cell));
  EXPECT_TRUE(fill.is_waiting(cell));
  int count = 0;
  const auto taken = [&](std::uint32_t, std::uint64_t, std::uint64_t at_rim) {
    count += std::popcount(at_rim);
  };
  fill.take(taken);
  EXPECT_EQ(count, 0) << "nothing was reached";
  fill.reach(cell);
  fill.take(taken);
  EXPECT_EQ(count, 1);
  EXPECT_FALSE(fill.is_waiting(cell));
  EXPECT_FALSE(fill.add(cell)) << "it is still one of them";
  fill.clear();
  EXPECT_TRUE(fill.add(cell));
}

}  // namespace
}  // namespace scanchor
