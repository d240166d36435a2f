#include "reasoning/assign.hpp"

#include <gtest/gtest.h>

#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

const Ontology& kinds() {
  static const Ontology ontology = parse_ontology(
      "class table:\n    horizontal\nclass desk is a table:\n    area 1..2 m2\nclass lid:\n    "
      "area 1..2 m2\n",
      "x.sdl");
  return ontology;
}

Entity decided(std::vector<ClassProbability> classes) {
  Entity entity;
  entity.classes = std::move(classes);
  decide(entity, kinds(), {});
  return entity;
}

TEST(Assign, TheMostSpecificLikelyClassWins) {
  EXPECT_EQ(decided({{"table", 0.9}, {"desk", 0.7}, {"unknown", 0.1}}).label, "desk");
  EXPECT_EQ(decided({{"table", 0.9}, {"desk", 0.4}, {"unknown", 0.1}}).label, "table");
}

TEST(Assign, ThinMarginsAreAmbiguousAndLittleIsUnknown) {
  const auto thin = decided({{"desk", 0.48}, {"table", 0.48}, {"lid", 0.42}, {"unknown", 0.1}});
  EXPECT_EQ(thin.label, "ambiguous");
  ASSERT_GE(thin.also, 0);
  EXPECT_EQ(thin.classes[thin.also].name, "lid");
  const auto little = decided({{"unknown", 0.7}, {"lid", 0.2}, {"table", 0.1}});
  EXPECT_EQ(little.label, "unknown");
  EXPECT_DOUBLE_EQ(little.probability, 0.7);
  EXPECT_EQ(decided({{"unknown", 1.0}}).label, "unknown");
}

TEST(Assign, ProbabilitiesOfAnEntityAddUpAlongTheTaxonomy) {
  const auto labelling = reason(test::make_surfaces({test::desk_plate()}), kinds(), {});
  const auto& entity = labelling.entities[0];
  const double table = test::probability_of(entity, "table");
  const double desk = test::probability_of(entity, "desk");
  EXPECT_GT(desk, 0.0);
  EXPECT_GE(table, desk);
  EXPECT_NEAR(table + test::probability_of(entity, "lid") + test::probability_of(entity, "unknown"),
              1.0, 1e-9);
}

TEST(Assign, UniqueGoesToOne) {
  const auto ontology = parse_ontology(
      "class hatch:\n    unique\n    horizontal\n    area 0.5..3 m2\n    extension 1..2 m\n    "
      "rectangular\n",
      "x.sdl");
  auto other = test::desk_plate();
  other.center.x() -= 3;
  other.length = 1.97;  // at the limit: less likely than the first
  const auto labelling = reason(test::make_surfaces({other, test::desk_plate()}), ontology, {});
  EXPECT_EQ(labelling.entities[0].label, "unknown");
  EXPECT_EQ(labelling.entities[1].label, "hatch");
}

TEST(Assign, PartsAndFacesBelongToOneThing) {
  const auto ontology = parse_ontology(R"(
axiom floor:
    area at least 4 m2
    horizontal
    lowest
class desk:
    horizontal
    extension 1.2..2 m
    elevation 0.6..0.9 m above a floor
class desk side part of desk:
    vertical
    lower than and near a desk
    top 0.5..0.8 m above a floor
class cabinet:
    several faces
    vertical
    bottom at most 0.1 m above a floor
    top 0.85..1.2 m above a floor
class cabinet top part of cabinet:
    horizontal
    orthogonal to and touching a cabinet
    extension under 1.1 m
)",
                                       "x.sdl");
  const std::vector<test::Plate> plates = {
      test::floor_plate(),
      test::desk_plate(),
      {{-2.0, -2.1, 0.45}, {0, 1, 0}, {1, 0, 0}, 1.0, 0.9},  // front of a cabinet
      {{-1.5, -2.3, 0.45}, {1, 0, 0}, {0, 1, 0}, 0.4, 0.9},  // its side
      {{-2.0, -2.3, 0.9}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.4},   // its top
      {{1.75, 1.5, 0.37}, {1, 0, 0}, {0, 1, 0}, 0.7, 0.7}};  // a panel under the desk
  const auto labelling = reason(test::make_surfaces(plates), ontology, {});
  EXPECT_EQ(labelling.entity_of_surface, (std::vector<std::int32_t>{0, 1, 2, 2, 2, 1}));
  EXPECT_EQ(labelling.entities[1].surfaces, (std::vector<std::int32_t>{1, 5}));
  EXPECT_EQ(labelling.entities[5].whole, 1);
  EXPECT_EQ(test::count_things(labelling, "cabinet"), 1);
}

TEST(Assign, APartWithoutItsWholeIsJudgedAgain) {
  const char* const lid_or_side = R"(
axiom floor:
    area at least 4 m2
    horizontal
    lowest
class desk:
    horizontal
    extension 1.2..2 m
    elevation 0.6..0.9 m above a floor
class desk side part of desk:
    vertical
    lower than and near a desk
    top 0.5..0.8 m above a floor
    extension 0.6..0.8 m
class screen:
    vertical
    extension 0.5..3 m
)";
  const auto ontology = parse_ontology(lid_or_side, "x.sdl");
  const test::Plate panel = {{1.75, 1.5, 0.37}, {1, 0, 0}, {0, 1, 0}, 0.7, 0.7};
  const auto with =
      reason(test::make_surfaces({test::floor_plate(), test::desk_plate(), panel}), ontology, {});
  EXPECT_EQ(with.entities[2].label, "desk side");
  EXPECT_EQ(with.entities[2].whole, 1);
  // A top that is nearly a desk, but unknown, keeps no side: what remains is a screen.
  auto doubtful = test::desk_plate();
  doubtful.length = 1.03;
  const auto without =
      reason(test::make_surfaces({test::floor_plate(), doubtful, panel}), ontology, {});
  ASSERT_NE(without.entities[1].label, "desk");
  ASSERT_GT(test::probability_of(without.entities[1], "desk"), 0.02);
  EXPECT_EQ(without.entities[2].label, "screen");
  EXPECT_EQ(test::probability_of(without.entities[2], "desk"), 0.0);
  EXPECT_EQ(without.entities[2].whole, -1);
}

}  // namespace
}  // namespace scanchor
