#include "results/draw_surfaces.hpp"

#include <gtest/gtest.h>

#include "tests/results/surface_samples.hpp"

namespace scanchor {
namespace {

TEST(DrawSurfaces, PolygonsStandWhereTheSurfaceIs) {
  const Drawing drawing = draw_surfaces(samples::two_surfaces());
  ASSERT_EQ(drawing.polygons.size(), 2u);
  EXPECT_NEAR(drawing.polygons[0].outer[0].z(), 0.72, 1e-12);
  EXPECT_EQ(drawing.polygons[0].holes.size(), 1u);
  EXPECT_NEAR(drawing.bounds.max().x(), 0.8, 1e-12);
}

TEST(DrawSurfaces, RectangleIsDashedAndTrueToSize) {
  DrawSurfacesOptions options;
  options.polygons = false;
  const Drawing drawing = draw_surfaces(samples::two_surfaces(), options);
  EXPECT_TRUE(drawing.polygons.empty());
  ASSERT_GE(drawing.lines.size(), 2u);
  Eigen::AlignedBox3d box;
  for (const auto& p : drawing.lines[0].ends) {
    if (std::abs(p.z() - 0.72) < 1e-9) box.extend(p);
  }
  EXPECT_NEAR(box.sizes().x(), 1.6, 1e-9);
  EXPECT_NEAR(box.sizes().y(), 0.8, 1e-9);
}

TEST(DrawSurfaces, ShadowEdgesAreMarked) {
  Surfaces surfaces = samples::two_surfaces();
  surfaces.surfaces[0].polygons[0].outer_kind.assign(4, EdgeKind::true_edge);
  surfaces.surfaces[0].polygons[0].outer_kind[1] = EdgeKind::occlusion;
  const Drawing drawing = draw_surfaces(surfaces);
  EXPECT_EQ(drawing.lines.back().ends.size(), 2u);
  DrawSurfacesOptions options;
  options.occlusion = false;
  EXPECT_EQ(draw_surfaces(surfaces, options).lines.size() + 1, drawing.lines.size());
}

TEST(DrawSurfaces, FeaturesAreWrittenWithTheirBounds) {
  Surface surface = samples::two_surfaces().surfaces[0];
  EXPECT_EQ(feature_text(surface), "A 1.28 m², E 1.60 m, R 0.95");
  surface.rectangle.length.at_least = true;
  EXPECT_EQ(feature_text(surface), "A 1.28 m², E ≥1.60 m, R 0.95");
  DrawSurfacesOptions options;
  options.features = true;
  EXPECT_EQ(draw_surfaces(samples::two_surfaces(), options).labels.size(), 2u);
}

TEST(DrawSurfaces, SmallAndTurnedAwayOnesAreLeftOut) {
  Surfaces surfaces = samples::two_surfaces();
  surfaces.surfaces[1].area.value = 5.0;  // a wall that looks to +x
  DrawSurfacesOptions options;
  options.towards_eye = {-1, 0, 0};
  EXPECT_EQ(draw_surfaces(surfaces, options).polygons.size(), 1u);
  options.towards_eye = {1, 0, 0};
  EXPECT_EQ(draw_surfaces(surfaces, options).polygons.size(), 2u);
  options.least_area = 2.0;
  EXPECT_EQ(draw_surfaces(surfaces, options).polygons.size(), 1u);
}

}  // namespace
}  // namespace scanchor
