#include "reasoning/catalogue.hpp"

#include <gtest/gtest.h>

#include "core/json.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

const char* const own_classes =
    "axiom floor:\n    lowest\n\n# about something else\n\n# Tables as sold.\nclass desk, table:\n"
    "    area 1..2 m2\n    parallel to a floor\nclass screen part of desk:\n    on a desk that is "
    "near a floor\n";

TEST(Catalogue, MarkdownSaysAllThatIsKnown) {
  const std::string page = catalogue_markdown(parse_ontology(own_classes, "own.sdl"));
  EXPECT_EQ(page.rfind("# own: 3 classes\n", 0), 0U);
  EXPECT_NE(page.find("## desk\n\nalso called table\n\nTables as sold.\n\n| clause |"),
            std::string::npos)
      << page;
  EXPECT_NE(page.find("| area 1..2 m2 | 0.97 | 0.09 | 1.00 |"), std::string::npos) << page;
  EXPECT_NE(page.find("## screen\n\npart of *desk*"), std::string::npos);
  EXPECT_NE(page.find("Asked for by: desk, screen"), std::string::npos) << "floor, further in too";
}

TEST(Catalogue, JsonHasEveryClassOfWhatIsShipped) {
  const auto ontology = test::shipped("home");
  const Json json = catalogue_json(ontology);
  ASSERT_EQ(json["classes"].size(), ontology.classes.size());
  for (const auto& one : json["classes"]) {
    EXPECT_FALSE(one["clauses"].empty() && !one.contains("is_a")) << one["name"];
    EXPECT_GT(one["line"].get<int>(), 0);
  }
  EXPECT_EQ(built_on(ontology, "no such class"), std::vector<std::string>{});
}

}  // namespace
}  // namespace scanchor
