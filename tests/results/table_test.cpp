#include "results/table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace scanchor {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Table, NumbersStandUnderEachOther) {
  Table table({"class", "precision", "n"});
  table.add_row({"desk", "0.97", "12"});
  table.add_row({"drawer unit", "0.5", "3"});
  const auto lines = lines_of(table.to_text());
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], "class        precision   n");
  EXPECT_EQ(lines[2], "desk              0.97  12");
  EXPECT_EQ(lines[3], "drawer unit        0.5   3");
}

TEST(Table, FitsItsWidthByCuttingTheWidestWords) {
  Table table({"what", "number", "why"});
  table.add_row({std::string(70, 'a'), "0.123456", std::string(60, 'b')});
  for (const int width : {80, 60, 40}) {
    const std::string text = table.to_text({width, false, 2});
    for (const std::string& line : lines_of(text)) EXPECT_LE(display_width(line), width) << line;
    EXPECT_NE(text.find("0.123456"), std::string::npos);
    EXPECT_NE(text.find("…"), std::string::npos);
  }
}

TEST(Table, ColourOnlyWhenAsked) {
  Table table({"score"});
  table.add_row({{"0.9", CellTone::good}});
  EXPECT_EQ(table.to_text().find('\x1b'), std::string::npos);
  EXPECT_NE(table.to_text({80, true, 0}).find("\x1b[32m"), std::string::npos);
}

TEST(Table, RulesAndMissingCells) {
  Table table({"a", "b"});
  table.add_row({"x"});
  table.add_rule();
  table.add_row({"y", "1"});
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(lines_of(table.to_text()).size(), 5u);
}

TEST(Table, Markdown) {
  Table table({"a|b", "n"});
  table.add_row({"x", "1.5"});
  EXPECT_EQ(table.to_markdown(), "| a\\|b | n |\n|---|---:|\n| x | 1.5 |\n");
}

TEST(Table, NoColorAndPipesAreRespected) {
  setenv("TERM", "xterm", 1);
  std::FILE* pipe = std::tmpfile();
  EXPECT_FALSE(wants_color(pipe));
  EXPECT_EQ(terminal_width(pipe), 80);
  setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(wants_color(stdout));
  unsetenv("NO_COLOR");
  std::fclose(pipe);
}

TEST(Table, FractionsAndTones) {
  EXPECT_EQ(fraction_text(0.87345), "0.873");
  EXPECT_EQ(fraction_text(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(tone_of(0.9, 0.8, 0.5), CellTone::good);
  EXPECT_EQ(tone_of(0.6, 0.8, 0.5), CellTone::fair);
  EXPECT_EQ(tone_of(0.1, 0.8, 0.5), CellTone::bad);
  EXPECT_EQ(display_width("σ = 1 cm²"), 9);
}

}  // namespace
}  // namespace scanchor
