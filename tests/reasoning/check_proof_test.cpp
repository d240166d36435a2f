#include "reasoning/check_proof.hpp"

#include <gtest/gtest.h>

#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

struct CheckProof : testing::Test {
  Ontology ontology = test::shipped("office");
  Surfaces surfaces = [] {
    auto plates = test::paper_room();
    for (const auto& board : test::shelf_boards(4)) plates.push_back(board);
    return test::make_surfaces(plates);
  }();
  Labelling labelling = reason(surfaces, ontology, {});
  std::size_t faults(std::int32_t entity) const {
    return check_proof(surfaces, ontology, labelling, entity).size();
  }
};

TEST_F(CheckProof, AcceptsEveryProofOfTheMatcher) {
  for (const auto& entity : labelling.entities) {
    for (const auto& fault : check_proof(surfaces, ontology, labelling, entity.id)) {
      ADD_FAILURE() << fault.entity << " " << fault.clause << ": " << fault.text;
    }
  }
}

TEST_F(CheckProof, FindsWhatWasForged) {
  ASSERT_EQ(labelling.entities[7].label, "monitor");
  const auto forged = [&](auto change) {
    const Labelling kept = labelling;
    change(labelling);
    const auto found = faults(7);
    labelling = kept;
    return found;
  };
  EXPECT_GT(forged([](Labelling& l) { l.entities[7].proof[0].measured += 0.01; }), 0U);
  EXPECT_GT(forged([](Labelling& l) { l.entities[7].proof.pop_back(); }), 0U);
  EXPECT_GT(forged([](Labelling& l) { l.entities[7].proof[1].text = "extension 0.1..9 m"; }), 0U);
  std::size_t above = 0;
  const auto& proof = labelling.entities[7].proof;
  while (above < proof.size() && proof[above].text != "usually above a desk") ++above;
  ASSERT_LT(above, proof.size());
  ASSERT_EQ(proof[above].targets, std::vector<std::int32_t>{6});
  EXPECT_GT(forged([&](Labelling& l) { l.entities[7].proof[above].targets = {1}; }), 0U)
      << "a wall is no desk";
  EXPECT_GT(forged([](Labelling& l) { l.entities[7].proof[1].likelihood = 0.01; }), 0U);
  EXPECT_GT(forged([](Labelling& l) { l.entities[7].label = "desk"; }), 0U);
  EXPECT_GT(forged([](Labelling& l) { l.entities[0].proof[0].measured += 0.5; }), 0U)
      << "through the target";
  EXPECT_EQ(check_proof(surfaces, ontology, labelling, 999).size(), 1U);
}

TEST(CheckProofOfTargets, WhatIsSaidOfATargetIsProvedToo) {
  const Ontology ontology = parse_ontology(
      "axiom floor:\n    lowest\n    area at least 4 m2\nclass desk:\n    area 0.9..1.7 m2\n"
      "    parallel to a floor\nclass screen:\n    area 0.1..0.4 m2\n"
      "    above a desk that is rectangular and has elevation 0.6..0.9 m above a floor\n",
      "x.sdl");
  const Surfaces surfaces = test::make_surfaces(test::paper_room());
  const Labelling labelling = reason(surfaces, ontology, {});
  ASSERT_EQ(labelling.entities[7].label, "screen");
  ASSERT_EQ(labelling.entities[7].proof[1].that_is.size(), 2U);
  EXPECT_NEAR(labelling.entities[7].proof[1].that_is[1].measured, 0.74, 0.01);
  EXPECT_TRUE(check_proof(surfaces, ontology, labelling, 7).empty());
  const auto forged = [&](auto change) {
    Labelling other = labelling;
    change(other.entities[7].proof[1]);
    return check_proof(surfaces, ontology, other, 7).size();
  };
  EXPECT_GT(forged([](ProofClause& c) { c.that_is.pop_back(); }), 0U);
  EXPECT_GT(forged([](ProofClause& c) { c.that_is[1].measured += 0.1; }), 0U);
  EXPECT_GT(forged([](ProofClause& c) { c.that_is[0].likelihood = 0.5 * c.likelihood; }), 0U);
}

}  // namespace
}  // namespace scanchor
