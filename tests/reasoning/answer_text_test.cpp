#include <gtest/gtest.h>

#include <regex>

#include "core/json.hpp"
#include "reasoning/answer.hpp"
#include "tests/reasoning/support/labelled.hpp"

namespace scanchor {
namespace {

struct AnswerText : testing::Test {
  Ontology ontology = test::shipped("office");
  test::LabelledScene scene =
      test::labelled({{test::desk_plate(), "desk", 0.9}, {test::screen_plate(), "monitor", 0.8}});
  SceneThings things{scene.surfaces, ontology, scene.labelling};
  std::string text(const std::string& question) {
    return answer_text(answer(parse_query(question, ontology), things), things);
  }
  Json json(const std::string& question) {
    return answer_to_json(answer(parse_query(question, ontology), things), things);
  }
};

TEST_F(AnswerText, IsInTheWordsOfTheLanguage) {
  const std::string found = text("screen on a desk");
  EXPECT_EQ(found.rfind("read as: a monitor on a desk\nfound one:\n   1  monitor", 0), 0U) << found;
  // How sure it is that it stands there follows the constants of relations.
  EXPECT_TRUE(std::regex_search(found, std::regex("      on a desk: 0\\.11 \\+- 0\\.01 m, holds "
                                                  "\\((0\\.9[0-9]|1\\.00)\\) on 0 \\(desk\\)\n"
                                                  "        is a desk: holds \\(0\\.90\\)\n")))
      << found;
  EXPECT_NE(text("how many desks").find("there is 1 (expected 0.9; 0: 0.10; 1: 0.90)"),
            std::string::npos);
  EXPECT_NE(text("is there a door").find("no (probability of at least one: 0.00)"),
            std::string::npos);
  EXPECT_NE(text("door on a desk").find("not found\nnothing in the scene is a door"),
            std::string::npos);
}

TEST_F(AnswerText, JsonHasTheDocumentedKeys) {
  const Json found = json("screen on a desk");
  EXPECT_EQ(found["format"], "scanchor answer 1");
  EXPECT_EQ(found["query"], "screen on a desk");
  EXPECT_EQ(found["read_as"], "a monitor on a desk");
  EXPECT_EQ(found["kind"], "find");
  EXPECT_EQ(found["status"], "ok");
  ASSERT_EQ(found["answers"].size(), 1U);
  const Json& one = found["answers"][0];
  for (const auto* key : {"id", "class", "center", "size", "pose", "probability", "of_class",
                          "completeness", "anchors", "why"})
    EXPECT_TRUE(one.contains(key)) << key;
  EXPECT_EQ(one["anchors"][0]["id"], 0);
  EXPECT_EQ(one["why"][0]["clause"], "on a desk");
  EXPECT_EQ(one["why"][0]["because"][0]["clause"], "is a desk");
  const Json missed = json("screen within 2 cm of a desk");
  EXPECT_EQ(missed["status"], "not_found");
  EXPECT_EQ(missed["fails_at"], "within 2 cm of a desk");
  EXPECT_EQ(missed["closest_miss"]["id"], 1);
  EXPECT_DOUBLE_EQ(missed["closest_miss"]["why"][0]["needed"].get<double>(), 0.02);
  EXPECT_EQ(json("how many desks")["count"], 1);
  EXPECT_EQ(json("distance from a desk to a screen")["unit"], "m");
}

}  // namespace
}  // namespace scanchor
