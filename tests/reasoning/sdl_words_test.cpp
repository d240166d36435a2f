#include "reasoning/sdl_words.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanchor {
namespace {

// Every clause of every class file that is shipped reads back from its own words to the same
// clause.
TEST(SdlWords, ClausesReadBackFromTheirText) {
  for (const std::string name : {"paper", "office", "home", "storage"}) {
    const auto ontology =
        read_ontology(std::string(SCANCHOR_SOURCE_DIR) + "/ontologies/" + name + ".sdl");
    for (const auto& description : ontology.classes) {
      for (const auto& clause : description.clauses) {
        std::string others;
        for (const auto& other : ontology.class_names())
          others += "class " + other + ":\n    lowest\n";
        const auto again = parse_ontology(
            others + "class the subject:\n    " + clause_text(clause) + "\n", "again.sdl");
        EXPECT_EQ(clause_text(again.classes.back().clauses[0]), clause_text(clause));
        EXPECT_EQ(again.classes.back().clauses[0].range, clause.range) << clause_text(clause);
        EXPECT_EQ(again.classes.back().clauses[0].relations, clause.relations)
            << clause_text(clause);
      }
    }
  }
}

TEST(SdlWords, Ranges) {
  Range range;
  range.low = 0.09;
  range.high = 0.17;
  range.unit = "cm2";
  EXPECT_EQ(range_text(range), "900..1700 cm2");
  range.high = INFINITY;
  range.unit = "m2";
  EXPECT_EQ(range_text(range), "at least 0.09 m2");
  range.strict = true;
  EXPECT_EQ(range_text(range), "over 0.09 m2");
}

TEST(SdlWords, EveryWordIsThereOnce) {
  EXPECT_EQ(relation_words(Relation::aligned), "vertically aligned with");
  EXPECT_EQ(feature_word(Feature::rectangularness), "rectangularness");
  EXPECT_EQ(extremum_word(Extremum::outermost), "outermost");
  for (const auto& a : relation_vocabulary()) {
    for (const auto& b : relation_vocabulary()) {
      EXPECT_TRUE(&a == &b || (a.words != b.words && a.relation != b.relation));
    }
  }
  EXPECT_EQ(find_unit("km"), nullptr);
  EXPECT_DOUBLE_EQ(find_unit("cm2")->scale, 1e-4);
}

}  // namespace
}  // namespace scanchor
