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

}  // namespace
}  // namespace scanchor
