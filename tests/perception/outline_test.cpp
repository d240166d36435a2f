#include "perception/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/perception/support/shape_scene.hpp"

namespace scanchor {
namespace {

using testing::box_panel;
using testing::Panel;
using testing::scan_panels;
using testing::ScannerSetup;
using testing::ShapeScan;

struct Outlined {
  ShapeScan scan;
  Outline outline;
};

/// Outline of panel 0 of a noise-free scan.
Outlined outline_of_first(const std::vector<Panel>& panels, ScannerSetup setup = {}) {
  Outlined result{scan_panels(panels, setup), {}};
  for (std::size_t i = 0; i < result.scan.panel_of_surface.size(); ++i) {
    if (result.scan.panel_of_surface[i] != 0) continue;
    const Surface& s = result.scan.surfaces.surfaces[i];
    const ShapeView view(result.scan.cloud, setup.position, result.scan.surfaces.plane_of_point);
    const OutlineSamples samples = samples_with_view(view, s, s.T_cloud_surface, 1e-4);
    result.outline = find_outline(result.scan.cloud, result.scan.surfaces, s, samples, 1e-4);
  }
  return result;
}

double area(const Outline& outline) {
  double sum = 0.0;
  for (const BoundaryRing& ring : outline.rings) {
    Ring points;
    for (const auto n : ring.nodes) points.push_back(outline.nodes[n].position);
    sum += ring_area(points);
  }
  return sum;
}

std::map<EdgeKind, double> length_by_kind(const Outline& outline) {
  std::map<EdgeKind, double> length;
  for (const BoundaryRing& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.nodes.size(); ++i) {
      length[ring.kinds[i]] += (outline.nodes[ring.nodes[(i + 1) % ring.nodes.size()]].position -
                                outline.nodes[ring.nodes[i]].position)
                                   .norm();
    }
  }
  return length;
}

const Panel backdrop = box_panel({6, 0, 0}, {0, 1, 0}, {0, 0, 1}, 40, 40);

TEST(Outline, RunsHalfWayBetweenHitAndMiss) {
  double bias = 0.0;
  for (int k = 0; k < 10; ++k) {
    const double width = 0.8 + 0.0073 * k;  // other phases of the rays each time
    const auto outlined = outline_of_first(
        {box_panel({2, 0.1, 0.05}, {0.2, 1, 0.1}, {0, 0, 1}, 1.0, width), backdrop});
    EXPECT_NEAR(area(outlined.outline), width, 0.02 * width);
    bias += (area(outlined.outline) / width - 1.0) / 10.0;
    EXPECT_NEAR(length_by_kind(outlined.outline)[EdgeKind::occlusion], 0.0, 1e-9);
  }
  EXPECT_LT(std::abs(bias), 0.004) << "half a spacing on each side would be -2.5 %";
}

TEST(Outline, AWindowIsAHoleOfTrueEdges) {
  Panel panel = box_panel({2, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.2, 1.0);
  Ring hole = testing::box_ring(0.4, 0.3);
  std::reverse(hole.begin(), hole.end());
  panel.holes.push_back(hole);
  const auto outlined = outline_of_first({panel, backdrop});
  ASSERT_EQ(outlined.outline.rings.size(), 2U);
  EXPECT_NEAR(outlined.outline.rings[1].area, -0.12, 0.01);
  EXPECT_NEAR(area(outlined.outline), 1.08, 0.02);
  EXPECT_NEAR(length_by_kind(outlined.outline)[EdgeKind::occlusion], 0.0, 1e-9);
}

TEST(Outline, AShadowIsToldFromAnEdge) {
  // A post half-way hides a vertical strip 0.2 m wide of the board.
  const auto outlined =
      outline_of_first({box_panel({2, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 0.8), backdrop,
                        box_panel({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.1, 3.0)});
  EXPECT_EQ(outlined.outline.rings.size(), 2U) << "two pieces";
  auto length = length_by_kind(outlined.outline);
  // The raw outline is a little longer than the edges, for it wavers.
  EXPECT_NEAR(length[EdgeKind::occlusion], 1.6, 0.15);
  EXPECT_NEAR(length[EdgeKind::true_edge], 3.2, 0.2);
  EXPECT_NEAR(length[EdgeKind::view_limit], 0.0, 0.02);
}

TEST(Outline, TheEndOfTheViewIsNoEdge) {
  // The board reaches beyond the scan on its left (azimuth 10 degrees and more is not scanned).
  ScannerSetup setup;
  setup.azimuth_from_deg = -40;
  setup.azimuth_to_deg = 10;
  setup.beams = 150;
  const auto outlined =
      outline_of_first({box_panel({2, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.6, 0.8), backdrop}, setup);
  auto length = length_by_kind(outlined.outline);
  EXPECT_NEAR(length[EdgeKind::view_limit], 0.8, 0.1);
  EXPECT_EQ(length[EdgeKind::occlusion], 0.0);
}

TEST(Outline, WhereAWallMeetsTheFloorTheFloorEnds) {
  ScannerSetup setup;
  setup.position = {0, 0, 1.4};
  // A floor to x = 3, the wall on it; and a low box in the way, which throws a shadow behind
  // it.
  const Panel floor = box_panel({1.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3.0, 2.0);
  const Panel end = box_panel({3, 0, 1.4}, {0, 1, 0}, {0, 0, 1}, 2.0, 2.8);
  auto alone = length_by_kind(outline_of_first({floor, end}, setup).outline);
  EXPECT_NEAR(alone[EdgeKind::occlusion], 0.0, 0.05);
  const Panel front = box_panel({1.5, 0, 0.2}, {0, 1, 0}, {0, 0, 1}, 0.5, 0.4);
  auto shaded = length_by_kind(outline_of_first({floor, end, front}, setup).outline);
  // Two sides and the far end of the shadow: it is 0.6 m deep (0.4 of 1.4 m high at 1.5 m),
  // widening from 0.5 to 0.7 m. And the foot of the box: the floor is seen behind it, so it does
  // not end there, as it does at the wall.
  EXPECT_NEAR(shaded[EdgeKind::occlusion], 0.61 + 0.61 + 0.7 + 0.5, 0.15);
}

TEST(Outline, RowsFarApartAtAGrazingAngleAreOneSurface) {
  // A desk top seen from 10 cm above it: rows up to 30 cm apart, points of a row 1 cm.
  ScannerSetup setup;
  setup.position = {0, 0, 0.85};
  const auto outlined =
      outline_of_first({box_panel({2.4, 0, 0.75}, {1, 0, 0}, {0, 1, 0}, 1.6, 0.8), backdrop,
                        box_panel({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 20, 20)},
                       setup);
  EXPECT_EQ(outlined.outline.rings.size(), 1U);
  EXPECT_NEAR(area(outlined.outline), 1.28, 0.3)
      << "five rows in all: each end is known to half of one";
}

TEST(Outline, WithoutAViewItEndsHalfACellOutside) {
  double bias = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Panel panel = box_panel({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1.0, 0.7);
    const ShapeScan scan = testing::flat_scan(
        testing::lattice_in(panel, 0.03, 0.03, 0.1 * static_cast<double>(seed), 0.1, seed));
    const Surface& s = scan.surfaces.surfaces.front();
    const Outline outline =
        find_outline(scan.cloud, scan.surfaces, s,
                     samples_without_view(flatten(scan.cloud, s), s.T_cloud_surface), 1e-6);
    bias += (area(outline) / 0.7 - 1.0) / 20.0;
    EXPECT_GT(length_by_kind(outline)[EdgeKind::unknown], 3.0);
  }
  EXPECT_LT(std::abs(bias), 0.02) << "the triangles alone end 7 % short";
}

}  // namespace
}  // namespace scanchor
