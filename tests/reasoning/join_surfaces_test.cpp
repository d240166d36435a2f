#include "reasoning/join_surfaces.hpp"

#include <gtest/gtest.h>

#include "tests/reasoning/support/scanned.hpp"

namespace scanchor {
namespace {

TEST(JoinSurfaces, JoiningCoversBoth) {
  const auto scene = test::scanned({{{0, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 0.7, 0.8},
                                    {{1, 2, 0.74}, {0, 0, -1}, {1, 0, 0}, 0.9, 0.8}});
  const auto& s = scene.surfaces.surfaces;
  for (const auto& joined : {join_surfaces(s[0], s[1]), join_surfaces(s[1], s[0])}) {
    EXPECT_NEAR(joined.rectangle.length.value, 1.8, 1e-6) << "0.35 before to 0.45 behind";
    EXPECT_NEAR(joined.rectangle.width.value, 0.8, 1e-6);
    EXPECT_NEAR(joined.area.value, 1.28, 1e-6) << "what was seen";
    EXPECT_TRUE(joined.area.at_least);
    EXPECT_EQ(joined.inliers.size(), s[0].inliers.size() + s[1].inliers.size());
    double area = 0.0;
    for (const auto& polygon : joined.polygons) {
      EXPECT_GT(ring_area(polygon.outer), 0.0) << "outer rings run counter-clockwise";
      area += polygon.area();
    }
    EXPECT_NEAR(area, 1.28, 1e-6);
  }
}

TEST(JoinSurfaces, FacingSidesAndTheirShadow) {
  auto scene = test::scanned({{{0, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 0.8, 0.6},
                              {{1.1, 2.1, 0.75}, {0, 0, -1}, {1, 0, 0}, 0.8, 0.6}});
  auto& s = scene.surfaces.surfaces;
  const auto seen = facing(s[0], s[1]);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->gap, 0.3, 1e-6);
  EXPECT_NEAR(seen->common, 0.5 / 0.6, 1e-6);
  EXPECT_NEAR(seen->across, 0.01, 1e-6);
  EXPECT_EQ(seen->shadow, 0.0);
  test::shade(scene, 0, {1, 0, 0});
  EXPECT_EQ(facing(s[0], s[1])->shadow, 0.0) << "both sides have to end in the shadow";
  test::shade(scene, 1, {-1, 0, 0});
  EXPECT_EQ(facing(s[0], s[1])->shadow, 1.0);
  EXPECT_EQ(facing(s[1], s[0])->shadow, 1.0);
  for (auto& polygon : s[0].polygons) polygon.outer_kind.clear();
  EXPECT_FALSE(facing(s[0], s[1])) << "not examined";
}

}  // namespace
}  // namespace scanchor
