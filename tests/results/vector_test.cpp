#include "results/vector.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

TEST(Vector, SvgSaysWhatWasDrawn) {
  VectorPicture picture{120, 80, {}};
  picture.fill_rectangle(10, 20, 30, 40, {255, 0, 0});
  picture.line({0, 0}, {100, 50}, {0, 0, 255, 128}, 2.5, {4, 2});
  picture.text(5, 15, "a < b & \"c\"", 12, ink, TextAnchor::middle, FontWeight::bold);
  const std::string svg = to_svg(picture);
  EXPECT_NE(svg.find("viewBox=\"0 0 120 80\""), std::string::npos);
  EXPECT_NE(svg.find("M10 20L40 20L40 60L10 60Z"), std::string::npos);
  EXPECT_NE(svg.find("fill=\"#ff0000\""), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray=\"4 2\""), std::string::npos);
  EXPECT_NE(svg.find("stroke-opacity=\"0.5\""), std::string::npos);
  EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_NE(svg.find("text-anchor=\"middle\" font-weight=\"bold\""), std::string::npos);
  EXPECT_EQ(svg, to_svg(picture));
}

TEST(Vector, AppendMovesEverything) {
  VectorPicture inner{10, 10, {}};
  inner.text(1, 2, "x", 10);
  inner.line({0, 0}, {1, 1}, ink);
  VectorPicture outer{100, 100, {}};
  outer.append(inner, 50, 60);
  EXPECT_EQ(std::get<VectorText>(outer.items[0]).position, Eigen::Vector2d(51, 62));
  EXPECT_EQ(std::get<VectorShape>(outer.items[1]).paths[0][1], Eigen::Vector2d(51, 61));
}

TEST(Vector, AnArrowOfNoLengthIsNothing) {
  VectorPicture picture{10, 10, {}};
  picture.arrow({3, 3}, {3, 3}, ink);
  EXPECT_TRUE(picture.items.empty());
  picture.arrow({3, 3}, {9, 3}, ink);
  EXPECT_EQ(picture.items.size(), 2u);
}

TEST(Vector, WritesAFile) {
  const auto path = samples::scratch("vector") / "a.svg";
  write_svg(path, VectorPicture{10, 10, {}});
  EXPECT_EQ(read_file(path).rfind("<svg", 0), 0u);
}

}  // namespace
}  // namespace scanchor
