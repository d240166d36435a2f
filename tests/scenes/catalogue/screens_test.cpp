#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

TEST(Screens, MonitorsAreSixteenByNine) {
  const Scene scene = alone({"monitor", "stand", 1, {{"diagonal_inch", 24}, {"tilt_deg", 0}}, 0.0});
  const Face* screen = find_face(*find_part(scene.instances[0], "screen"), "front");
  EXPECT_NEAR(screen->size.x(), 24 * 0.0254 * 16 / std::sqrt(337.0) + 0.014, 1e-3);
  EXPECT_NEAR(screen->size.y(), 24 * 0.0254 * 9 / std::sqrt(337.0) + 0.024, 1e-3);
  EXPECT_NEAR(screen->normal.y(), -1.0, 1e-12);
}

TEST(Screens, TiltedScreensLookUp) {
  const Scene scene = alone({"monitor", "stand", 1, {{"tilt_deg", 10}}, 0.0});
  const WorldFace screen = world_face(scene, {0, 0, 2});
  EXPECT_NEAR(screen.normal.z(), std::sin(10 * 3.14159265358979 / 180), 1e-9);
  EXPECT_LT(screen.normal.y(), -0.9);
}

TEST(Screens, BoardsHangInFrontOfTheWall) {
  for (const char* kind : {"whiteboard", "picture"}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Scene scene = alone({kind, "", seed, {}, 0.0});
      if (scene.instances[0].variant == "on stand") continue;
      EXPECT_LT(local_bounds(scene.instances[0]).max().y(), -0.001);
      EXPECT_GT(local_bounds(scene.instances[0]).max().y(), -0.01);
    }
  }
}

TEST(Screens, AnOpenLaptopLeansBack) {
  const Scene scene = alone({"laptop", "open", 1, {{"opening_deg", 110}}, 0.0});
  const WorldFace screen = world_face(scene, {0, 1, 2});
  EXPECT_NEAR(screen.normal.z(), std::sin(20 * 3.14159265358979 / 180), 1e-9);
}

}  // namespace
}  // namespace scanchor
