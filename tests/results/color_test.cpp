#include "results/color.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scanchor {
namespace {

int distance(Color a, Color b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

TEST(Color, PaletteColoursAreApart) {
  for (std::size_t i = 0; i < 21; ++i) {
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GT(distance(palette(i), palette(k)), 40) << i << " " << k;
  }
  EXPECT_EQ(palette(3), palette(24));
}

TEST(Color, NumbersGoRoundThePaletteAndNegativeOnesAreGrey) {
  for (int n = 0; n < 21; ++n) {
    for (int m = 0; m < n; ++m) EXPECT_NE(color_of_number(n), color_of_number(m));
  }
  EXPECT_EQ(color_of_number(2), color_of_number(23));
  const Color none = color_of_number(-1);
  EXPECT_LT(std::abs(none.r - none.b), 20);
}

TEST(Color, MapsRunFromDarkToLightAndTakeAnyNumber) {
  for (const ColorMap map : {ColorMap::cividis, ColorMap::viridis}) {
    int last = -1;
    for (int i = 0; i <= 32; ++i) {
      const Color c = color_map(map, i / 32.0);
      // Rec. 709 luma of the sRGB values rises along both maps.
      const int luma = int(0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b);
      EXPECT_GE(luma, last);
      last = luma;
    }
    EXPECT_EQ(color_map(map, -5.0), color_map(map, 0.0));
    EXPECT_EQ(color_map(map, 7.0), color_map(map, 1.0));
  }
  EXPECT_EQ(color_map(ColorMap::viridis, std::numeric_limits<double>::quiet_NaN()),
            color_of_number(-1));
  EXPECT_GT(color_map(ColorMap::balance, 0.0).b, color_map(ColorMap::balance, 0.0).r);
  EXPECT_GT(color_map(ColorMap::balance, 1.0).r, color_map(ColorMap::balance, 1.0).b);
}

TEST(Color, MixesAndWrites) {
  EXPECT_EQ(mix({0, 0, 0}, {200, 100, 50}, 0.5), (Color{100, 50, 25}));
  EXPECT_EQ(hex({1, 171, 255}), "#01abff");
  EXPECT_EQ(readable_on({255, 255, 200}), ink);
  EXPECT_EQ(readable_on({20, 20, 90}), paper_white);
  EXPECT_EQ(with_alpha(ink, 7).a, 7);
}

TEST(Color, ClassesHaveTheClassListsColour) {
  const auto& rgb = class_info(*find_class("desk")).color;
  EXPECT_EQ(color_of_class(*find_class("desk")), (Color{rgb[0], rgb[1], rgb[2]}));
}

}  // namespace
}  // namespace scanchor
