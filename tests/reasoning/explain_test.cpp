#include "reasoning/explain.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

struct Explain : testing::Test {
  std::vector<test::Plate> plates = test::paper_room();
  Ontology ontology = test::shipped("paper");
  Surfaces surfaces;
  Labelling labelling;
  void label() {
    surfaces = test::make_surfaces(plates);
    labelling = reason(surfaces, ontology, {});
  }
  WhyNot ask(int entity, const std::string& name) {
    return why_not(surfaces, ontology, labelling, entity, name);
  }
};

TEST_F(Explain, GoesDownToTheAxiom) {
  label();
  const auto text = explain(labelling, 7);
  const auto screen = text.find("7 is a screen");
  const auto desk = text.find("6 is a desk");
  const auto floor = text.find("0 is a floor");
  ASSERT_NE(screen, std::string::npos) << text;
  ASSERT_NE(desk, std::string::npos);
  ASSERT_NE(floor, std::string::npos);
  EXPECT_LT(screen, desk);
  EXPECT_LT(desk, floor);
  EXPECT_NE(text.find("orthogonal to and above a desk: "), std::string::npos);
  EXPECT_NE(text.find("area 0.1..0.35 m2: 0.24 +- 0.00 m2, holds"), std::string::npos) << text;
  EXPECT_THROW(explain(labelling, 99), Error);
}

TEST_F(Explain, WhyNotNamesTheFirstFailingClauseAndTheSmallestChange) {
  plates[6].length = 0.9;  // the desk top is too short: 0.72 m2 and 0.9 m
  label();
  const auto answer = ask(6, "desk");
  EXPECT_FALSE(answer.holds);
  EXPECT_EQ(answer.clause, "area 0.9..1.7 m2");
  EXPECT_NEAR(answer.measured, 0.72, 1e-9);
  ASSERT_TRUE(answer.has_needed);
  EXPECT_NEAR(answer.needed, 0.9, 1e-9);
  EXPECT_NE(answer.text.find("6 is not a desk: 'area 0.9..1.7 m2' fails, measured 0.72"),
            std::string::npos)
      << answer.text;
  EXPECT_NE(answer.text.find("a change of +0.18 m2"), std::string::npos) << answer.text;
}

TEST_F(Explain, TheChangeThatIsNamedFlipsTheClause) {
  plates[6].center.z() = 1.45;
  label();
  const auto answer = ask(6, "desk");
  EXPECT_EQ(answer.clause, "elevation 0.5..1 m above a floor");
  EXPECT_EQ(answer.target, "0 (floor)");
  ASSERT_TRUE(answer.has_needed);
  plates[6].center.z() += answer.needed - answer.measured - 0.05;
  label();
  EXPECT_TRUE(ask(6, "desk").holds);
  EXPECT_EQ(labelling.entities[6].label, "desk");
}

TEST_F(Explain, MissingTargetsAndUnknownNames) {
  plates.erase(plates.begin() + 6);
  label();
  const auto answer = ask(6, "screen");
  EXPECT_EQ(answer.clause, "orthogonal to and above a desk");
  EXPECT_NE(answer.text.find("nothing in the scene satisfies it"), std::string::npos)
      << answer.text;
  EXPECT_THROW(ask(6, "scren"), Error);
  EXPECT_THROW(ask(66, "screen"), Error);
}

}  // namespace
}  // namespace scanchor
