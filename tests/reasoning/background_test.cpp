#include "reasoning/background.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Background, RatesGoToTheClauseWithTheirWords) {
  auto ontology = parse_ontology(
      "class a:\n    horizontal\n    area 1..2 m2\nclass b:\n    horizontal\n", "x.sdl");
  EXPECT_DOUBLE_EQ(hit_rate_of(ontology.classes[0].clauses[0]),
                   default_hit_rate(ontology.classes[0].clauses[0]));
  EXPECT_DOUBLE_EQ(prior_of(ontology, 0), 0.25);
  Background background;
  background.unknown_prior = 0.3;
  background.temperature = 0.7;
  background.priors = {{"a", 0.6}, {"gone", 0.1}};
  background.rates = {{"a", "area 1..2 m2", 0.9, 0.1},
                      {"a", "no such clause", 0.5, 0.5},
                      {"gone", "horizontal", 0.5, 0.5}};
  apply_background(ontology, background);
  EXPECT_DOUBLE_EQ(hit_rate_of(ontology.classes[0].clauses[1]), 0.9);
  EXPECT_DOUBLE_EQ(background_of(ontology.classes[0].clauses[1]), 0.1);
  EXPECT_DOUBLE_EQ(background_of(ontology.classes[0].clauses[0]), 0.4);
  EXPECT_DOUBLE_EQ(prior_of(ontology, 0), 0.6);
  EXPECT_DOUBLE_EQ(unknown_prior_of(ontology), 0.3);
  EXPECT_DOUBLE_EQ(ontology.temperature, 0.7);
}

TEST(Background, UncountedClassesWeighAsMuchAsCountedOnes) {
  auto ontology = parse_ontology(
      "class a:\n    horizontal\n    area 1..2 m2\nclass b:\n    horizontal\n    area 2..3 m2\n"
      "class mine:\n    horizontal\n    area 4..5 m2\n    on an a\n",
      "x.sdl");
  const auto plain = ontology;
  fill_uncounted(ontology);
  EXPECT_DOUBLE_EQ(weight_of(ontology.classes[2].clauses[1]), 1.0) << "nothing is counted";
  Background background;
  background.priors = {{"a", 0.01}, {"b", 0.04}};
  background.rates = {{"a", "horizontal", 0.9, 0.2, 0.4},
                      {"a", "area 1..2 m2", 0.8, 0.1, 0.5},
                      {"b", "horizontal", 0.7, 0.4, 0.6},
                      {"b", "area 2..3 m2", 0.6, 0.1, 0.7}};
  apply_background(ontology, background);
  fill_uncounted(ontology);
  const auto& mine = ontology.classes[2];
  EXPECT_NEAR(prior_of(ontology, 2), 0.02, 1e-12) << "the geometric mean";
  EXPECT_NEAR(weight_of(mine.clauses[0]), 0.5, 1e-12);
  EXPECT_NEAR(background_of(mine.clauses[0]), 0.3, 1e-12) << "of the same words";
  EXPECT_NEAR(weight_of(mine.clauses[1]), 0.6, 1e-12);
  EXPECT_NEAR(hit_rate_of(mine.clauses[1]), 0.7, 1e-12);
  EXPECT_DOUBLE_EQ(background_of(mine.clauses[1]), default_background(mine.clauses[1]));
  EXPECT_NEAR(weight_of(mine.clauses[2]), 0.55, 1e-12) << "no relation was counted: of all";
  // What was counted stays.
  EXPECT_DOUBLE_EQ(hit_rate_of(ontology.classes[0].clauses[0]), 0.9);
}

}  // namespace
}  // namespace scanchor
