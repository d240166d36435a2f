#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::alone;
using testing::find_face;
using testing::find_part;

// EN 13698-1: 1200 x 800 x 144 mm.
TEST(Logistics, EuroPalletHasItsStandardSize) {
  const Scene scene = alone({"pallet", "euro", 1, {}, 0.0});
  const Eigen::Vector3d size = local_bounds(scene.instances[0]).sizes();
  EXPECT_NEAR(size.x(), 1.2, 1e-9);
  EXPECT_NEAR(size.y(), 0.8, 1e-9);
  EXPECT_NEAR(size.z(), 0.144, 1e-9);
  int blocks = 0;
  for (const auto& part : scene.instances[0].parts)
    blocks += part.name.rfind("block", 0) == 0 ? 1 : 0;
  EXPECT_EQ(blocks, 9);
}

TEST(Logistics, OpenBoxesAreHollow) {
  const Scene scene =
      alone({"box", "open", 1, {{"width", 0.4}, {"depth", 0.3}, {"height", 0.25}}, 0.0});
  double solid = 0.0;
  for (const auto& part : scene.instances[0].parts) solid += testing::volume(part);
  EXPECT_LT(solid, 0.2 * 0.4 * 0.3 * 0.25);
}

TEST(Logistics, RackDecksLieOnTheirBeams) {
  const Scene scene = alone({"pallet rack", "low bay", 1, {{"levels", 3}, {"pitch", 1.2}}, 0.0});
  for (int i = 1; i <= 3; ++i) {
    const Part* deck = find_part(scene.instances[0], "deck " + std::to_string(i));
    ASSERT_NE(deck, nullptr);
    EXPECT_NEAR(find_face(*deck, "top")->center.z(), 0.16 + 1.2 * (i - 1), 1e-9);
  }
}

}  // namespace
}  // namespace scanchor
