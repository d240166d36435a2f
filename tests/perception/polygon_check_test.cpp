#include "perception/polygon_check.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(PolygonCheck, KnowsSimpleRings) {
  EXPECT_TRUE(is_simple({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_TRUE(is_simple({{0, 0}, {1, 0}, {2, 0}, {1, 1}}))
      << "a vertex on a straight edge is allowed";
  EXPECT_FALSE(is_simple({{0, 0}, {1, 1}, {1, 0}, {0, 1}})) << "bow-tie";
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {1, 0}, {1, 1}})) << "folded back";
  EXPECT_FALSE(is_simple({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}})) << "a vertex on another edge";
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {1, 0}, {0, 1}})) << "an edge without length";
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_FALSE(is_simple({{0, 0}, {1, 0}}));
}

TEST(PolygonCheck, HolesMustLieInside) {
  const Ring outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Ring hole = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  EXPECT_TRUE(is_valid({outer, {hole}, {}}));
  EXPECT_FALSE(is_valid({{outer.rbegin(), outer.rend()}, {hole}, {}})) << "outer ring clockwise";
  EXPECT_FALSE(is_valid({outer, {{hole.rbegin(), hole.rend()}}, {}})) << "hole counter-clockwise";
  EXPECT_FALSE(is_valid({outer, {{{3, 3}, {3, 5}, {5, 5}, {5, 3}}}, {}}))
      << "hole across the border";
  EXPECT_FALSE(is_valid({outer, {{{5, 5}, {5, 6}, {6, 6}, {6, 5}}}, {}})) << "hole outside";
  EXPECT_FALSE(is_valid({outer, {hole, hole}, {}})) << "two holes in one place";
}

TEST(PolygonCheck, ContainsLeavesHolesOut) {
  const Polygon polygon{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}, {}};
  EXPECT_TRUE(contains(polygon, {0.5, 0.5}));
  EXPECT_FALSE(contains(polygon, {1.5, 1.5}));
  EXPECT_FALSE(contains(polygon, {5.0, 1.5}));
}

}  // namespace
}  // namespace scanchor
