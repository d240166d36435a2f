#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

TEST(Tables, DeskTopIsAsHighAndWideAsAsked) {
  for (const char* variant : {"four legs", "panel legs", "height-adjustable"}) {
    const Scene scene =
        alone({"desk", variant, 3, {{"width", 1.6}, {"depth", 0.8}, {"height", 0.74}}, 0.0});
    const Face* top = find_face(*find_part(scene.instances[0], "top"), "top");
    EXPECT_NEAR(top->center.z(), 0.74, 1e-12) << variant;
    EXPECT_NEAR(top->area, 1.28, 1e-12) << variant;
    EXPECT_NEAR(top->size.x(), 1.6, 1e-12) << variant;
  }
}

// EN 527: fixed desks about 740 mm, sit-stand 650 .. 1250 mm.
TEST(Tables, DeskHeightsKeepToTheStandard) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = alone({"desk", "", seed, {}, 0.0});
    const double height = scene.instances[0].parameters.at("height");
    const bool adjustable = scene.instances[0].variant == "height-adjustable";
    EXPECT_GE(height, adjustable ? 0.65 : 0.72);
    EXPECT_LE(height, adjustable ? 1.25 : 0.76);
  }
}

TEST(Tables, LShapedTopHasItsOwnArea) {
  const Scene scene =
      alone({"desk", "L-shape", 1, {{"width", 1.6}, {"depth", 0.8}, {"return", 0.9}}, 0.0});
  const Face* top = find_face(*find_part(scene.instances[0], "top"), "top");
  EXPECT_NEAR(top->area, 1.6 * 0.8 + 0.6 * 0.9, 1e-12);
  EXPECT_LT(top->area, 0.95 * top->size.prod());
}

TEST(Tables, RoundTopIsARegularPolygonOfItsDiameter) {
  const Scene scene = alone({"table", "round pedestal", 1, {{"diameter", 1.0}}, 0.0});
  const Face* top = find_face(*find_part(scene.instances[0], "top"), "top");
  EXPECT_NEAR(top->area, 0.5 * 32 * 0.25 * std::sin(2 * 3.14159265358979 / 32), 1e-9);
}

}  // namespace
}  // namespace scanchor
