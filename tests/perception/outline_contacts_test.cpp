#include "perception/outline_contacts.hpp"

#include <gtest/gtest.h>

#include "tests/perception/support/shape_scene.hpp"

namespace scanchor {
namespace {

using testing::box_panel;
using testing::scan_panels;
using testing::ScannerSetup;
using testing::ShapeScan;

TEST(OutlineContacts, AFloorGoesOnBehindABoxAndEndsAtTheWall) {
  ScannerSetup setup;
  setup.position = {0, 0, 1.4};
  setup.range_sigma = 0.01;
  const ShapeScan scan = scan_panels({box_panel({1.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, 3.0, 2.0),
                                      box_panel({3, 0, 1.4}, {0, 1, 0}, {0, 0, 1}, 2.0, 2.8),
                                      box_panel({1.5, 0, 0.2}, {0, 1, 0}, {0, 0, 1}, 0.5, 0.4)},
                                     setup);
  std::size_t of_panel[3] = {0, 0, 0};
  for (std::size_t i = 0; i < scan.panel_of_surface.size(); ++i)
    of_panel[scan.panel_of_surface[i]] = i;
  const ShapeView view(scan.cloud, setup.position, scan.surfaces.plane_of_point);
  const Surface& floor = scan.surfaces.surfaces[of_panel[0]];
  const OutlineSamples samples = samples_with_view(view, floor, floor.T_cloud_surface, 0.035);
  const std::vector<char> behind = goes_on_behind(scan.surfaces, samples, 0.035);
  ASSERT_EQ(behind.size(), 3U);
  EXPECT_EQ(behind[of_panel[2]], 1) << "the floor is seen behind the box";
  EXPECT_EQ(behind[of_panel[1]], 0) << "and not behind the wall";
}

}  // namespace
}  // namespace scanchor
