#include "perception/surface.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Surface, AreaOfARingHasTheSignOfItsDirection) {
  const Ring ring = {{1e6, 1e6}, {1e6 + 2, 1e6}, {1e6 + 2, 1e6 + 3}, {1e6, 1e6 + 3}};
  EXPECT_DOUBLE_EQ(ring_area(ring), 6.0);
  EXPECT_DOUBLE_EQ(ring_area({ring.rbegin(), ring.rend()}), -6.0);
  EXPECT_EQ(ring_area({}), 0.0);
  EXPECT_EQ(ring_area({{1, 2}, {3, 4}}), 0.0);
}

TEST(Surface, HolesAreTakenOffAPolygon) {
  const Polygon polygon{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}, {}};
  EXPECT_DOUBLE_EQ(polygon.area(), 15.0);
}

TEST(Surface, EveryKindOfEdgeHasItsName) {
  EXPECT_EQ(edge_kind_name(EdgeKind::true_edge), "true_edge");
  EXPECT_EQ(edge_kind_name(EdgeKind::occlusion), "occlusion");
  EXPECT_EQ(edge_kind_name(EdgeKind::view_limit), "view_limit");
  EXPECT_EQ(edge_kind_name(EdgeKind::unknown), "unknown");
}

}  // namespace
}  // namespace scanchor
