#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

TEST(Building, ClosedDoorLiesInItsFrameAndOpenOneStandsInTheRoom) {
  const Scene closed =
      alone({"door", "closed", 1, {{"width", 0.885}, {"height", 2.005}, {"wall", 0.12}}, 0.0});
  const Eigen::AlignedBox3d bounds = local_bounds(closed.instances[0]);
  EXPECT_LT(bounds.sizes().x(), 0.885);
  EXPECT_LT(bounds.max().z(), 2.005);
  EXPECT_GT(bounds.min().y(), -0.1) << "only the handle stands out";
  const Scene open =
      alone({"door", "open", 1, {{"width", 0.885}, {"height", 2.005}, {"wall", 0.12}}, 0.0});
  EXPECT_LT(local_bounds(open.instances[0]).min().y(), -0.7);
}

TEST(Building, AjarDoorsAreALittleOpen) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const double angle =
        alone({"door", "ajar", seed, {}, 0.0}).instances[0].parameters.at("angle_deg");
    EXPECT_GE(angle, 8.0);
    EXPECT_LE(angle, 23.0);
  }
}

TEST(Building, WindowsHaveGlassInAFrame) {
  const Scene scene = alone({"window", "two panes", 1, {}, 0.0});
  for (const char* name : {"glass 1", "glass 2"}) {
    const Part* pane = find_part(scene.instances[0], name);
    ASSERT_NE(pane, nullptr);
    EXPECT_GT(scene.materials[static_cast<std::size_t>(pane->material)].transmittance, 0.5);
  }
}

TEST(Building, PillarsReachTheCeiling) {
  for (const char* variant : {"square", "round"}) {
    const auto bounds =
        local_bounds(alone({"pillar", variant, 1, {{"height", 3.0}}, 0.0}).instances[0]);
    EXPECT_NEAR(bounds.max().z(), 3.0, 0.002);
    EXPECT_NEAR(bounds.min().z(), 0.0, 0.002);
  }
}

}  // namespace
}  // namespace scanchor
