#include "reasoning/paper_mode.hpp"

#include <gtest/gtest.h>

#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

Labelling as_paper(const std::vector<test::Plate>& plates, const std::string& ontology_text = "") {
  ReasonOptions options;
  options.mode = "paper";
  const auto ontology =
      ontology_text.empty() ? test::shipped("paper") : parse_ontology(ontology_text, "x.sdl");
  return reason(test::make_surfaces(plates), ontology, options);
}

TEST(PaperMode, NamesThePapersRoom) {
  const auto all = test::labels(as_paper(test::paper_room()));
  EXPECT_EQ(all[0], "floor");
  EXPECT_EQ(all[6], "desk");
  EXPECT_EQ(all[7], "screen");
  EXPECT_EQ(all[8], "screen");
}

// Section 3: "an object on the table can be identified as a monitor with likelihood 0.8. Because
// the likelihood of the table is 0.5, the likelihood of being a monitor for the object is reduced
// to 0.4" (S15).
TEST(PaperMode, ChainIsTheProduct) {
  // The table misses its area by one third and its extension by one sixth: 1 - 1/2 = 0.5 with the
  // disparity just below delta.
  const std::string text =
      "class table:\n    extension at least 1.9999998 m\n    area 0..0.75 m2\nclass monitor:\n    "
      "extension at least 0.5 m\n"
      "    higher than a table\n";
  std::vector<test::Plate> plates = {{{0, 0, 0.7}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.7},
                                     {{0, 0, 1.2}, {0, 1, 0}, {1, 0, 0}, 0.4, 0.3}};
  const auto labelling = as_paper(plates, text);
  EXPECT_NEAR(test::probability_of(labelling.entities[0], "table"), 0.5, 1e-6);
  // Own likelihood 0.4 / 0.5 = 0.8, the relation is certain: 0.8 x 0.5 = 0.4. Its disparity 0.2 +
  // (1 - 0.5) is not below delta, so the two combinations of the paper contradict each other here
  // (S15): the chain says 0.4, the disparity says no monitor.
  EXPECT_EQ(labelling.entities[1].label, "unknown");
  std::string certain = text;
  certain.replace(certain.find("1.9999998"), 9, "1.25");
  const auto likely = as_paper(plates, certain);
  EXPECT_NEAR(test::probability_of(likely.entities[0], "table"), 0.8, 1e-6);
  EXPECT_NEAR(test::probability_of(likely.entities[1], "monitor"), 0.8 * 0.8, 1e-6);
}

TEST(PaperMode, MonitorOfEightyPercentOnATableOfFiftyIsOneOfForty) {
  EXPECT_DOUBLE_EQ(chained(0.8, 0.5), 0.4);
  static_assert(chained(1.0, 0.5) == 0.5 && chained(0.8, 0.0) == 0.0);
}

TEST(PaperMode, ParallelAndOrthogonalAreNotTrueForEveryPair) {
  const std::string text =
      "axiom floor:\n    lowest\n    horizontal\nclass a:\n    extension under 1 m\n    parallel "
      "to a floor\n"
      "class b:\n    extension under 1 m\n    orthogonal to a floor\n";
  const test::Plate low = test::floor_plate();
  const auto flat = as_paper({low, {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, 0.5, 0.5}}, text);
  EXPECT_EQ(flat.entities[1].label, "a")
      << "S8, S9: anti-parallel normals are parallel and not orthogonal";
  const auto standing = as_paper({low, {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 0.5, 0.5}}, text);
  EXPECT_EQ(standing.entities[1].label, "b");
}

TEST(PaperMode, DisparityIsWithoutUnits) {
  // S11: a 20 m2 floor against (2.0, 2, 0, 1) gave 18 + 3 + 1 = 22; as a lower limit it is no
  // disparity at all.
  EXPECT_EQ(as_paper({test::floor_plate()}).entities[0].label, "floor");
  EXPECT_NEAR(as_paper({test::floor_plate()}).entities[0].probability, 1.0, 0.02);
}

}  // namespace
}  // namespace scanchor
