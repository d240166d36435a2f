#include "results/depth_shading.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "results/paint.hpp"

namespace scanchor {
namespace {

/// Inverse depth falls linearly over the picture: a plane in perspective.
Frame slanted_plane() {
  Frame frame{blank_image(80, 60, {200, 200, 200}), std::vector<float>(80 * 60)};
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x)
      frame.distance[std::size_t(y) * 80 + std::size_t(x)] = 1.0F / (0.5F - 0.004F * float(x));
  }
  return frame;
}

TEST(DepthShading, LeavesAPlaneAlone) {
  Frame frame = slanted_plane();
  shade_by_depth(frame, 1.0, 500.0, false, false);
  const auto [low, high] = std::minmax_element(frame.image.rgb.begin(), frame.image.rgb.end());
  EXPECT_GE(*low, 198);
  EXPECT_EQ(*high, 200);
}

TEST(DepthShading, DarkensACreaseAndNothingElse) {
  Frame frame{blank_image(80, 60, {200, 200, 200}), std::vector<float>(80 * 60)};
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 80; ++x) {
      // A trough of two planes with its deepest line at x = 40: over a plane, 1 / distance is
      // linear.
      frame.distance[std::size_t(y) * 80 + std::size_t(x)] =
          1.0F / (0.333F + 0.003F * float(std::abs(x - 40)));
    }
  }
  shade_by_depth(frame, 1.0, 300.0, false, false);
  const auto value = [&](int x) { return int(frame.image.rgb[3 * (30 * 80 + std::size_t(x))]); };
  EXPECT_LT(value(40), 170);
  EXPECT_GE(value(10), 199);
  EXPECT_GE(value(70), 199);
}

TEST(DepthShading, StrengthZeroAndBackgroundStay) {
  Frame frame = slanted_plane();
  frame.distance[30 * 80 + 40] = 0.0F;
  Frame copy = frame;
  shade_by_depth(copy, 0.0, 500.0, false, false);
  EXPECT_EQ(copy.image.rgb, frame.image.rgb);
  shade_by_depth(copy, 2.0, 500.0, false, true);
  EXPECT_EQ(copy.image.rgb[3 * (30 * 80 + 40)], 200);
}

}  // namespace
}  // namespace scanchor
