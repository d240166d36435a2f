#include "perception/polygon_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "perception/polygon_check.hpp"

namespace scanchor {
namespace {

std::vector<BoundarySegment> loop(const std::vector<std::uint32_t>& nodes,
                                  std::uint32_t component) {
  std::vector<BoundarySegment> segments;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    segments.push_back({nodes[i], nodes[(i + 1) % nodes.size()], component, EdgeKind::true_edge});
  return segments;
}

TEST(Rings, TwoTrianglesThatTouchInAPointAreTwoRings) {
  const std::vector<Eigen::Vector2d> nodes = {{0, 0}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}};
  auto segments = loop({0, 1, 2}, 0);
  for (const auto& s : loop({0, 3, 4}, 1)) segments.push_back(s);
  for (int turn = 0; turn < 6; ++turn) {
    std::rotate(segments.begin(), segments.begin() + 1, segments.end());
    const auto rings = chain_rings(nodes, segments);
    ASSERT_EQ(rings.size(), 2U);
    EXPECT_DOUBLE_EQ(rings[0].area, 1.0);
    EXPECT_DOUBLE_EQ(rings[1].area, 1.0);
    EXPECT_EQ(rings[0].nodes.size(), 3U);
  }
}

TEST(Rings, AHoleThatTouchesTheOutlineIsCutOff) {
  // A square and a triangular hole that share node 0.
  const std::vector<Eigen::Vector2d> nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}, {2, 1}};
  auto segments = loop({0, 1, 2, 3}, 0);
  for (const auto& s : loop({0, 4, 5}, 0)) segments.push_back(s);  // clockwise
  for (int turn = 0; turn < 7; ++turn) {
    std::rotate(segments.begin(), segments.begin() + 1, segments.end());
    const auto rings = chain_rings(nodes, segments);
    ASSERT_EQ(rings.size(), 2U);
    EXPECT_DOUBLE_EQ(rings[0].area, 16.0);
    EXPECT_DOUBLE_EQ(rings[1].area, -1.5);
    auto polygons = rings_to_polygons(nodes, rings);
    ASSERT_EQ(polygons.size(), 1U);
    EXPECT_DOUBLE_EQ(polygons[0].area(), 14.5);
    part_touching_holes(polygons[0]);
    EXPECT_NEAR(polygons[0].area(), 14.5, 1e-5);
    EXPECT_TRUE(is_valid(polygons[0])) << "rings of a polygon do not touch";
  }
}

TEST(Rings, KindsStayWithTheirEdges) {
  const std::vector<Eigen::Vector2d> nodes = {{1, 0}, {1, 1}, {0, 1}, {0, 0}};
  auto segments = loop({0, 1, 2, 3}, 0);
  segments[1].kind = EdgeKind::occlusion;  // from (1, 1) to (0, 1)
  const auto rings = chain_rings(nodes, segments);
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(rings[0].nodes.front(), 3U) << "begins at the smallest node";
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(rings[0].kinds[i] == EdgeKind::occlusion, rings[0].nodes[i] == 1U);
}

TEST(Rings, NothingGivesNothing) { EXPECT_TRUE(chain_rings({}, {}).empty()); }

}  // namespace
}  // namespace scanchor
