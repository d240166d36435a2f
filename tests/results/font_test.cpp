#include "results/font.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace scanchor {
namespace {

Eigen::AlignedBox2d box(const std::vector<std::vector<Eigen::Vector2d>>& rings) {
  Eigen::AlignedBox2d result;
  for (const auto& ring : rings) {
    for (const auto& p : ring) result.extend(p);
  }
  return result;
}

TEST(Font, CapitalsStandOnTheBaselineAndHaveTheirHeight) {
  const auto h = box(text_rings("H", 100.0));
  EXPECT_NEAR(h.max().y(), 0.0, 0.5);
  EXPECT_NEAR(h.min().y(), -73.0, 1.0);
  EXPECT_GT(box(text_rings("g", 100.0)).max().y(), 10.0);  // below the baseline
}

TEST(Font, HasHolesWhereLettersHaveThem) {
  EXPECT_EQ(text_rings("o", 20.0).size(), 2u);
  EXPECT_EQ(text_rings("B", 20.0).size(), 3u);
  EXPECT_EQ(text_rings("l", 20.0).size(), 1u);
  EXPECT_TRUE(text_rings(" ", 20.0).empty());
}

TEST(Font, WidthAddsUpAndScales) {
  EXPECT_DOUBLE_EQ(text_width("ab", 20.0), text_width("a", 20.0) + text_width("b", 20.0));
  EXPECT_DOUBLE_EQ(text_width("room", 40.0), 2.0 * text_width("room", 20.0));
  EXPECT_GT(text_width("room", 20.0, FontWeight::bold), text_width("room", 20.0));
  EXPECT_GT(text_width("W", 20.0), text_width("i", 20.0));
  EXPECT_EQ(text_width("", 20.0), 0.0);
}

TEST(Font, ReadsUtf8AndDrawsABoxForWhatItDoesNotHave) {
  EXPECT_EQ(text_rings("σ", 20.0).size(), 2u);
  EXPECT_EQ(text_rings("\xE4\xB8\xAD", 20.0).size(),
            2u);                                       // a Chinese character: one box of two rings
  EXPECT_EQ(text_rings("\xFF\xC3", 20.0).size(), 4u);  // two malformed bytes
  EXPECT_EQ(text_rings("°", 20.0, FontWeight::bold).size(), 2u);
}

TEST(Font, CutsTextToAWidth) {
  const std::string text = "a rather long description";
  EXPECT_EQ(fit_text(text, 1000.0, 12.0), text);
  const std::string cut = fit_text(text, 80.0, 12.0);
  EXPECT_LE(text_width(cut, 12.0), 80.0);
  EXPECT_GT(text_width(cut, 12.0), 60.0);
  EXPECT_EQ(cut.substr(cut.size() - 3), "…");
  EXPECT_EQ(text.rfind(cut.substr(0, cut.size() - 3), 0), 0u);
}

}  // namespace
}  // namespace scanchor
