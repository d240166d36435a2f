#include "perception/shape_paper.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "perception/polygon_check.hpp"
#include "tests/perception/support/shape_scene.hpp"

namespace scanchor {
namespace {

using testing::flat_scan;
using testing::lattice_in;
using testing::Panel;
using testing::ShapeScan;

Surface shaped(const Ring& outer, double spacing, std::uint64_t seed) {
  Panel panel;
  panel.outer = outer;
  ShapeScan scan = flat_scan(lattice_in(panel, spacing, spacing, 0.15, 0.15, seed));
  shape_as_paper(scan.cloud, scan.surfaces.surfaces.front());
  return scan.surfaces.surfaces.front();
}

TEST(PaperShape, AMonitorIsARectangleOfTheRightSize) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Surface s = shaped(testing::box_ring(0.57, 0.42), 0.012, seed);
    EXPECT_TRUE(s.is_rectangle);
    EXPECT_GT(s.rectangularness, 0.85);
    // The alpha shape ends at the outermost points: up to a spacing short, as the paper's own chain
    // is.
    EXPECT_NEAR(s.rectangle.length.value, 0.57, 0.025);
    EXPECT_NEAR(s.rectangle.width.value, 0.42, 0.025);
    EXPECT_LT(s.area.value, 0.57 * 0.42);
    EXPECT_GT(s.area.value, 0.90 * 0.57 * 0.42);
  }
}

TEST(PaperShape, AnEllIsNone) {
  const Surface s = shaped(
      {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.0}, {0.0, 0.0}, {0.0, 0.5}, {-0.5, 0.5}}, 0.015, 3);
  EXPECT_FALSE(s.is_rectangle);
  EXPECT_LT(s.rectangularness, 0.85);
}

TEST(PaperShape, PointsOnALineHaveAnExtentButNoArea) {
  std::vector<Eigen::Vector2d> line;
  for (int i = 0; i < 30; ++i) line.emplace_back(0.01 * i, 0.0);
  ShapeScan scan = flat_scan(line);
  Surface& s = scan.surfaces.surfaces.front();
  shape_as_paper(scan.cloud, s);
  EXPECT_TRUE(s.polygons.empty());
  EXPECT_NEAR(s.rectangle.length.value, 0.29, 1e-9);
  EXPECT_EQ(s.area.value, 0.0);
  EXPECT_FALSE(s.is_rectangle);
}

}  // namespace
}  // namespace scanchor
