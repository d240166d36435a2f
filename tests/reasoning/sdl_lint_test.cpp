#include "reasoning/sdl_lint.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

std::vector<std::string> rules(const std::string& text) {
  std::vector<std::string> all;
  for (const auto& finding : lint(parse_ontology(text, "x.sdl"))) all.push_back(finding.rule);
  return all;
}
using Rules = std::vector<std::string>;

TEST(SdlLint, FindsEachRule) {
  EXPECT_EQ(rules("class a:\n    extension at most 1 m\n    extension at least 2 m\n"),
            Rules{"contradiction"});
  EXPECT_EQ(rules("class a:\n    area at least 3 m2\n    extension at most 1 m\n"),
            Rules{"contradiction"});
  EXPECT_EQ(rules("class a:\n    horizontal\n    vertical\n"), Rules{"contradiction"});
  EXPECT_EQ(rules("class f:\n    lowest\nclass a:\n    above and below a f\n"),
            Rules{"contradiction"});
  EXPECT_EQ(rules("class a:\n    horizontal\n    vertical\nclass b:\n    on a a\n"),
            (Rules{"contradiction", "never grounded"}));
  EXPECT_EQ(rules("class a:\n    lowest\n    area at least 0 m2\n"), Rules{"always true"});
  EXPECT_EQ(rules("class a:\n    extension at most 1 m\n    width at most 2 m\n    extension at "
                  "most 3 m\n"),
            Rules{"always true"});
  EXPECT_EQ(rules("class a:\n    lowest\n    lowest\n"), Rules{"always true"});
  EXPECT_EQ(rules("class a:\n    lowest\n    horizontal\nclass b:\n    horizontal\n    lowest\n"),
            Rules{"same description"});
  EXPECT_EQ(rules("class b part of top:\n    vertical\nclass top:\n    lowest\n"),
            Rules{"part without relation"});
  EXPECT_EQ(
      rules("class top:\n    lowest\nclass end part of top:\n    vertical\nclass frame part of "
            "top:\n    at least 2 ends, each pair\n        parallel\n"),
      Rules{})
      << "a group that is a part holds its whole together";
}

TEST(SdlLint, LooksAtWhatIsSaidOfTargets) {
  const std::string base = "class a:\n    horizontal\n    extension 1..2 m\nclass b:\n    ";
  EXPECT_EQ(rules(base + "on an a that is vertical\n"), Rules{"contradiction"});
  EXPECT_EQ(rules(base + "on an a that has extension over 3 m\n"), Rules{"contradiction"});
  EXPECT_EQ(rules(base + "on an a that is horizontal\n"), Rules{"always true"});
  EXPECT_EQ(rules(base + "on an a that is rectangular\n"), Rules{});
  EXPECT_EQ(
      rules("class a:\n    horizontal\n    vertical\nclass c:\n    lowest\nclass b:\n    on a "
            "c that is near an a\n"),
      (Rules{"contradiction", "never grounded"}));
}

TEST(SdlLint, SilentOnWhatIsShipped) {
  for (const std::string name : {"paper", "office", "home", "storage"}) {
    const auto ontology =
        read_ontology(std::string(SCANCHOR_SOURCE_DIR) + "/ontologies/" + name + ".sdl");
    for (const auto& finding : lint(ontology)) ADD_FAILURE() << lint_text(finding);
  }
}

TEST(SdlLint, TextHasPlace) {
  const auto findings = lint(parse_ontology("class a:\n    lowest\n    lowest\n", "x.sdl"));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(lint_text(findings[0]).rfind("x.sdl:3:5: always true: ", 0), 0U);
}

}  // namespace
}  // namespace scanchor
