#include "perception/outline_polygons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"
#include "perception/polygon_check.hpp"

namespace scanchor {
namespace {

constexpr double gap = 0.02;

/// Adds a ring with a node each `gap`, which waver by up to half of that across the edge;
/// counter-clockwise around a rectangle, clockwise for a hole.
void add_rectangle(Outline& outline, const Eigen::Vector2d& from, const Eigen::Vector2d& size,
                   bool hole, std::uint32_t component, SequentialRandom& random,
                   EdgeKind first = EdgeKind::true_edge) {
  std::vector<Eigen::Vector2d> corners = {
      from, {from.x() + size.x(), from.y()}, from + size, {from.x(), from.y() + size.y()}};
  if (hole) std::reverse(corners.begin(), corners.end());
  BoundaryRing ring;
  ring.component = component;
  Ring points;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d along = corners[(k + 1) % 4] - corners[k];
    const int steps = std::max(1, static_cast<int>(std::lround(along.norm() / gap)));
    const Eigen::Vector2d out(along.y() / along.norm(), -along.x() / along.norm());
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d p =
          corners[k] + along * ((i + 0.5) / steps) + random.uniform(-0.5 * gap, 0.5 * gap) * out;
      ring.nodes.push_back(static_cast<std::uint32_t>(outline.nodes.size()));
      ring.kinds.push_back(k == 0 ? first : EdgeKind::true_edge);
      outline.nodes.push_back({p, 0.5 * gap});
      points.push_back(p);
    }
  }
  ring.area = ring_area(points);
  outline.rings.push_back(ring);
}

TEST(OutlinePolygons, AWaveringRectangleHasFourStraightSides) {
  SequentialRandom random(1);
  Outline outline;
  add_rectangle(outline, {0.0, 0.0}, {1.2, 0.8}, false, 0, random);
  std::vector<OutlineEdge> edges;
  const auto polygons = outline_polygons(outline, &edges);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_TRUE(is_valid(polygons.front()));
  EXPECT_NEAR(polygons.front().area(), 1.2 * 0.8, 0.01);
  ASSERT_EQ(edges.size(), polygons.front().outer.size());
  double straight = 0.0;
  for (const OutlineEdge& e : edges) {
    EXPECT_NEAR(e.gap, gap, 0.2 * gap);
    const Eigen::Vector2d d = (e.to - e.from).cwiseAbs();
    if (d.minCoeff() < 0.05 * d.maxCoeff()) straight += d.maxCoeff();
    if (d.maxCoeff() > 0.5) {
      EXPECT_GT(e.waver, 0.1 * gap);
      EXPECT_LT(e.waver, 0.5 * gap);
    }
  }
  EXPECT_GT(straight, 0.9 * 4.0) << "of the whole way round";
}

TEST(OutlinePolygons, TheLargestComesFirstAndKeepsItsHole) {
  SequentialRandom random(2);
  Outline outline;
  add_rectangle(outline, {3.0, 0.0}, {0.4, 0.4}, false, 0, random);
  add_rectangle(outline, {0.0, 0.0}, {1.2, 0.8}, false, 1, random);
  add_rectangle(outline, {0.4, 0.3}, {0.3, 0.2}, true, 1, random);
  const auto polygons = outline_polygons(outline);
  ASSERT_EQ(polygons.size(), 2U);
  ASSERT_EQ(polygons[0].holes.size(), 1U);
  EXPECT_TRUE(polygons[1].holes.empty());
  EXPECT_NEAR(polygons[0].area(), 1.2 * 0.8 - 0.06, 0.015);
  EXPECT_NEAR(polygons[1].area(), 0.16, 0.01);
}

TEST(OutlinePolygons, SpecksAreLeftOutBesideLargerPieces) {
  SequentialRandom random(3);
  Outline outline;
  add_rectangle(outline, {0.0, 0.0}, {gap, gap}, false, 0, random);  // four nodes
  EXPECT_EQ(outline_polygons(outline).size(), 1U) << "alone it is all there is";
  add_rectangle(outline, {1.0, 0.0}, {0.4, 0.4}, false, 1, random);
  EXPECT_EQ(outline_polygons(outline).size(), 1U);
}

TEST(HiddenShare, CountsShadowsOfOuterRingsAndOfHolesApart) {
  SequentialRandom random(4);
  Outline outline;
  add_rectangle(outline, {0.0, 0.0}, {2.0, 0.5}, false, 0, random, EdgeKind::occlusion);
  add_rectangle(outline, {0.5, 0.2}, {0.4, 0.1}, true, 0, random, EdgeKind::view_limit);
  const OutlineShare share = hidden_share(outline);
  EXPECT_NEAR(share.hidden / share.total, 2.0 / 5.0, 0.03);
  EXPECT_NEAR(share.hidden_holes, 0.4, 0.05);
}

}  // namespace
}  // namespace scanchor
