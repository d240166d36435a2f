#include "reasoning/recut.hpp"

#include <gtest/gtest.h>

#include "tests/reasoning/support/scanned.hpp"

namespace scanchor {
namespace {

/// A plate of 1.2 x 0.35 m that leans and is turned.
test::Scanned strip() {
  test::Scanned scene = test::scanned({{{1, 2, 1}, {0.3, -1, 0.2}, {1, 0.3, 0.1}, 1.2, 0.36}});
  return scene;
}

TEST(Recut, PiecesShareAreaPointsAndPlane) {
  const auto scene = strip();
  const Surface& whole = scene.surfaces.surfaces[0];
  const auto pieces = cut_surface(whole, scene.cloud.points, {-0.2, 0.2});
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 3U);
  double area = 0.0;
  std::size_t points = 0;
  for (const auto& piece : *pieces) {
    area += piece.area.value;
    points += piece.inliers.size();
    EXPECT_NEAR(piece.rectangle.length.value, 0.4, 1e-6);
    EXPECT_NEAR(piece.rectangle.width.value, 0.36, 1e-6);
    EXPECT_NEAR(piece.rectangularness, 1.0, 1e-6);
    EXPECT_NEAR(whole.plane.normal.dot(piece.plane.centroid), whole.plane.offset, 1e-9);
    EXPECT_NEAR((piece.T_cloud_surface.translation() - piece.plane.centroid).norm(), 0.0, 1e-12);
    // The middle of the rectangle is the middle of its points.
    const Eigen::Vector3d middle =
        piece.T_cloud_surface *
        Eigen::Vector3d(piece.rectangle.center.x(), piece.rectangle.center.y(), 0.0);
    EXPECT_NEAR((middle - piece.plane.centroid).norm(), 0.0, 0.02);
    EXPECT_GT(piece.plane.normal_covariance.trace(), whole.plane.normal_covariance.trace());
  }
  EXPECT_NEAR(area, whole.area.value, 1e-6);
  EXPECT_EQ(points, whole.inliers.size());
  EXPECT_FALSE(cut_surface(whole, scene.cloud.points, {0.7})) << "nothing lies beyond its end";
  // Where it is cut it ends; the outer edges stay what they were.
  for (const auto kind : (*pieces)[1].polygons[0].outer_kind) EXPECT_EQ(kind, EdgeKind::true_edge);
}

TEST(Recut, ATallPieceTurnsItsRectangle) {
  const auto scene = strip();
  const auto pieces =
      cut_surface(scene.surfaces.surfaces[0], scene.cloud.points, {-0.4, -0.2, 0.0, 0.2, 0.4});
  ASSERT_TRUE(pieces);
  EXPECT_NEAR((*pieces)[2].rectangle.length.value, 0.36, 1e-6) << "the longer side is the length";
  EXPECT_NEAR((*pieces)[2].rectangle.width.value, 0.2, 1e-6);
}

TEST(Recut, SeamsAreWhereOutlineOrPointsEnd) {
  auto scene = strip();
  EXPECT_TRUE(outline_seams(scene.surfaces.surfaces[0]).empty());
  EXPECT_FALSE(find_seams(scene.surfaces.surfaces[0], scene.cloud.points, 2, 0.02));
  // A bezel without returns, but the outline goes over it.
  const auto polygons = scene.surfaces.surfaces[0].polygons;
  test::take_out(scene, 0, 0.03, 0.07);
  const auto in_outline = outline_seams(scene.surfaces.surfaces[0]);
  ASSERT_EQ(in_outline.size(), 1U);
  EXPECT_NEAR(in_outline[0], 0.05, 1e-6);
  EXPECT_EQ(outline_seams(scene.surfaces.surfaces[0], 0.035).size(), 1U);
  EXPECT_TRUE(outline_seams(scene.surfaces.surfaces[0], 0.045).empty()) << "only wider gaps";
  scene.surfaces.surfaces[0].polygons = polygons;
  EXPECT_TRUE(outline_seams(scene.surfaces.surfaces[0]).empty());
  const auto in_points = find_seams(scene.surfaces.surfaces[0], scene.cloud.points, 2, 0.02);
  ASSERT_TRUE(in_points);
  EXPECT_NEAR((*in_points)[0], 0.05, 0.02);
}

TEST(Recut, ChangedListsKeepTheirOrderAndTheirPoints) {
  const auto scene = test::scanned({{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 2.0, 2.0},
                                    {{0, 3, 1}, {0, 0, 1}, {1, 0, 0}, 1.2, 0.4},
                                    {{0, 6, 1}, {0, 0, 1}, {1, 0, 0}, 0.8, 0.4}});
  const auto pieces = cut_surface(scene.surfaces.surfaces[1], scene.cloud.points, {0.0});
  ASSERT_TRUE(pieces);
  std::vector<std::int32_t> place;
  const Surfaces changed = with_changed(scene.surfaces, {1}, *pieces, &place);
  ASSERT_EQ(changed.surfaces.size(), 4U);
  EXPECT_EQ(place, (std::vector<std::int32_t>{2, 3})) << "behind what has more points";
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(changed.surfaces[i].id, static_cast<std::int32_t>(i));
    if (i > 0) {
      EXPECT_GE(changed.surfaces[i - 1].inlier_count, changed.surfaces[i].inlier_count);
    }
    for (const auto p : changed.surfaces[i].inliers)
      ASSERT_EQ(changed.plane_of_point[p], static_cast<std::int32_t>(i));
  }
  EXPECT_EQ(std::count(changed.plane_of_point.begin(), changed.plane_of_point.end(), -1), 0);
}

}  // namespace
}  // namespace scanchor
