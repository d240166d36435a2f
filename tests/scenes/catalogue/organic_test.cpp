#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

// Distractors: hardly any of their surface is planar.
TEST(Organic, RoundThingsAreRound) {
  for (const char* kind : {"plant", "mannequin", "bottle", "bag", "cushion", "bowl"}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const Scene scene = alone({kind, "", seed, {}, 0.0});
      double planar = 0.0;
      double all = 0.0;
      for (const auto& part : scene.instances[0].parts) {
        for (const auto& face : part.faces) {
          all += face.area;
          if (face.planar) planar += face.area;
        }
      }
      EXPECT_LT(planar, 0.25 * all) << kind;
    }
  }
}

TEST(Organic, MannequinsAreAsTallAsPeople) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = alone({"mannequin", "standing", seed, {}, 0.0});
    EXPECT_NEAR(local_bounds(scene.instances[0]).max().z(),
                scene.instances[0].parameters.at("height"), 0.03);
  }
}

TEST(Organic, CeilingLampsHangBelowTheCeiling) {
  for (const char* variant : {"linear", "globe", "shade"}) {
    const auto bounds =
        local_bounds(alone({"ceiling lamp", variant, 1, {{"drop", 0.5}}, 0.0}).instances[0]);
    EXPECT_LT(bounds.max().z(), -0.001) << variant;
    EXPECT_GT(bounds.min().z(), -0.9) << variant;
  }
}

}  // namespace
}  // namespace scanchor
