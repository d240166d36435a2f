#include "perception/rectangle_sides.hpp"

#include <gtest/gtest.h>

#include "core/math.hpp"

namespace scanchor {
namespace {

/// Edges of a ring, all of one kind, gap and waver 1 cm.
std::vector<OutlineEdge> edges_of(const Ring& ring, double angle,
                                  EdgeKind kind = EdgeKind::true_edge) {
  const Eigen::Rotation2Dd turn(angle);
  std::vector<OutlineEdge> edges;
  for (std::size_t i = 0; i < ring.size(); ++i)
    edges.push_back({turn * ring[i], turn * ring[(i + 1) % ring.size()], kind, 0.01, 0.01});
  return edges;
}

const Ring box = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};

TEST(MainDirection, IsThatOfTheLongEdges) {
  for (const double angle : {-0.7, -0.2, 0.0, 0.4, 0.7})
    EXPECT_NEAR(main_direction(edges_of(box, angle)), angle, 1e-12);
  // A cut corner does not turn it.
  EXPECT_NEAR(main_direction(edges_of({{0, 0}, {2, 0}, {2, 0.7}, {1.7, 1}, {0, 1}}, 0.3)), 0.3,
              0.01);
  EXPECT_EQ(main_direction({}), 0.0);
}

TEST(MainDirection, ShadowsCountLittle) {
  auto edges = edges_of(box, 0.0);
  // The shadow of a slanted thing is longer than any side.
  for (int i = 0; i < 2; ++i)
    edges.push_back(
        {{0, 0}, {2.5 * std::cos(0.5), 2.5 * std::sin(0.5)}, EdgeKind::occlusion, 0.01, 0.01});
  EXPECT_NEAR(main_direction(edges), 0.0, 0.01);
}

TEST(GuessSide, LiesWhereTheEdgeLies) {
  for (int k = 0; k < 4; ++k) {
    RectangleSide side;
    side.turn = 0.5 * pi * k;
    guess_side(edges_of(box, 0.0), 0.0, side);
    const double expected[] = {2.0, 1.0, 0.0, 0.0};
    EXPECT_NEAR(side.position, expected[k], 1e-9);
    EXPECT_NEAR(side.support, 1.0, 1e-9);
    EXPECT_FALSE(side.censored);
    EXPECT_NEAR(side.gap, 0.01, 1e-12);
  }
}

TEST(GuessSide, ASpikeIsNoSide) {
  // 3 cm wide and 20 cm high: a fiftieth of the side, of a hundredth of the area.
  RectangleSide side;
  side.turn = 0.5 * pi;
  guess_side(
      edges_of({{0, 0}, {2, 0}, {2, 1}, {1.03, 1}, {1.03, 1.2}, {1, 1.2}, {1, 1}, {0, 1}}, 0.0),
      0.0, side);
  EXPECT_NEAR(side.position, 1.0, 1e-9);
}

TEST(GuessSide, ATabBeyondALongEdgeIsNoSide) {
  // A twentieth of the side, 5 cm high: of three samples and more, but the long edge is the side.
  const Ring tab = {{0, 0}, {2, 0}, {2, 1}, {0.1, 1}, {0.1, 1.05}, {0, 1.05}};
  RectangleSide side;
  side.turn = 0.5 * pi;
  guess_side(edges_of(tab, 0.0), 0.0, side);
  EXPECT_NEAR(side.position, 1.0, 1e-9);
  // What looks out of a shadow as short as that is the side: there is no long true edge.
  auto edges = edges_of(tab, 0.0);
  edges[2].kind = EdgeKind::occlusion;
  guess_side(edges, 0.0, side);
  EXPECT_NEAR(side.position, 1.05, 1e-9);
}

TEST(GuessSide, AShadowIsCensored) {
  auto edges = edges_of(box, 0.0);
  edges[1].kind = EdgeKind::occlusion;
  RectangleSide side;
  guess_side(edges, 0.0, side);
  EXPECT_TRUE(side.censored);
  EXPECT_NEAR(side.position, 2.0, 0.03);
  EXPECT_EQ(side.support, 0.0);
}

// Half as broad as the rest, and as likely another thing: the side stays where it was, and what
// lies beyond most of the edge is told.
TEST(GuessSide, WhatSticksOutIsLoose) {
  RectangleSide side;
  side.turn = 0.5 * pi;
  const Ring stepped = {{0, 0}, {2, 0}, {2, 1.5}, {1.2, 1.5}, {1.2, 1}, {0, 1}};
  guess_side(edges_of(stepped, 0.0), 0.0, side);
  EXPECT_NEAR(side.position, 1.5, 1e-9);
  EXPECT_NEAR(side.loose, 0.5, 1e-9);
  EXPECT_NEAR(side.loose_area, 0.4, 1e-9);
  for (int k = 0; k < 4; ++k) {
    RectangleSide plain;
    plain.turn = 0.5 * pi * k;
    guess_side(edges_of(box, 0.0), 0.0, plain);
    EXPECT_EQ(plain.loose, 0.0);
    EXPECT_EQ(plain.loose_area, 0.0);
  }
}

// In a shadow only the breadth tells.
TEST(GuessSide, AThinEndInAShadowIsLoose) {
  RectangleSide side;
  side.turn = 0.5 * pi;
  const Ring stepped = {{0, 0}, {2, 0}, {2, 1}, {1.3, 1}, {1.3, 1.2}, {1, 1.2}, {1, 1}, {0, 1}};
  guess_side(edges_of(stepped, 0.0, EdgeKind::occlusion), 0.0, side);
  EXPECT_TRUE(side.censored);
  EXPECT_GT(side.loose, 0.15);
  EXPECT_NEAR(side.position - side.loose, 0.95, 0.06);
  RectangleSide plain;
  plain.turn = 0.5 * pi;
  guess_side(edges_of(box, 0.0, EdgeKind::occlusion), 0.0, plain);
  EXPECT_EQ(plain.loose, 0.0);
}

}  // namespace
}  // namespace scanchor
