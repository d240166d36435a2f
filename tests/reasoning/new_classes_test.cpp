#include "reasoning/new_classes.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reasoning/background.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

const char* const counted_text =
    "class slab:\n    horizontal\n    extension 0.5..1 m\n"
    "class panel:\n    vertical\n    extension 0.5..1 m\n";

/// Slabs and panels, and now and then a long slab or something else.
ReferenceRoom room(std::uint64_t seed, int long_slabs, const std::string& name) {
  SequentialRandom random(seed);
  std::vector<test::Plate> plates;
  TrainingScene scene;
  for (int i = 0; i < 30; ++i) {
    test::Plate plate;
    plate.center = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(0, 2)};
    plate.width = 0.2;
    const bool is_long = i < long_slabs;
    plate.length = is_long ? 2.0 : 0.75;
    if (!is_long && i % 2 == 0) plate.normal = Eigen::Vector3d::UnitY();
    scene.classes.push_back(is_long ? name : i % 2 == 0 ? "panel" : "slab");
    plates.push_back(plate);
  }
  scene.surfaces = test::make_surfaces(plates);
  return make_reference_room(scene, {});
}

Ontology with_own(const std::string& own) {
  Ontology ontology = parse_ontology(counted_text + own, "x.sdl");
  Background background;
  background.fitted_on = "by hand";
  background.unknown_prior = 0.2;
  background.priors = {{"slab", 0.4}, {"panel", 0.4}};
  background.rates = {{"slab", "horizontal", 0.95, 0.5, 0.6},
                      {"slab", "extension 0.5..1 m", 0.9, 0.5, 0.6},
                      {"panel", "vertical", 0.95, 0.5, 0.6},
                      {"panel", "extension 0.5..1 m", 0.9, 0.5, 0.6}};
  apply_background(ontology, background);
  return ontology;
}

/// How sure one may be of the new class for a plate that is all that it says.
double believed(const std::string& own, int long_slabs, const std::string& name) {
  Ontology ontology = with_own(own);
  const auto fresh = new_classes(ontology);
  EXPECT_EQ(fresh, std::vector<int>{2});
  fill_uncounted(ontology);
  std::vector<ReferenceRoom> rooms;
  for (std::uint64_t seed = 0; seed < 8; ++seed) rooms.push_back(room(seed, long_slabs, name));
  weigh_new_classes(ontology, fresh, rooms);
  test::Plate plate;
  plate.center = {0, 0, 1};
  plate.length = 2.0;
  plate.width = 0.2;
  const auto labelling = reason(test::make_surfaces({plate}), ontology, {});
  return test::probability_of(labelling.entities[0], "bench");
}

const char* const bench = "class bench:\n    horizontal\n    extension 1.5..2.5 m\n";

TEST(NewClasses, AreAsSureAsTheirWordsAreSeldomTrueOfOtherThings) {
  const double never = believed(bench, 0, "");
  const double seldom = believed(bench, 1, "");  // one a room that is no single thing
  const double often = believed(bench, 8, "");
  EXPECT_GT(never, 0.8);
  EXPECT_LT(often, 0.3) << "one of nine";
  EXPECT_GT(never, seldom + 0.1);
  EXPECT_GT(seldom, often + 0.1);
}

TEST(NewClasses, MeanAtMostOneKindOfThingThatNobodyHasDescribed) {
  // Long slabs are all that the words hold of, and no class describes them: they are what is meant.
  EXPECT_GT(believed(bench, 8, "bank"), 0.8);
  EXPECT_GT(believed(bench, 8, "bench"), 0.8) << "the rooms know its name";
  EXPECT_LT(believed(bench, 8, "slab"), 0.3) << "they are something else";
}

TEST(NewClasses, LeaveCountedClassesAsTheyAre) {
  Ontology ontology = with_own(bench);
  fill_uncounted(ontology);
  const Ontology before = ontology;
  weigh_new_classes(ontology, {2}, {});
  EXPECT_DOUBLE_EQ(ontology.classes[2].prior, before.classes[2].prior) << "without rooms nothing";
  weigh_new_classes(ontology, {2}, {room(1, 3, "")});
  EXPECT_NE(ontology.classes[2].prior, before.classes[2].prior);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(ontology.classes[c].prior, before.classes[c].prior);
    for (std::size_t i = 0; i < before.classes[c].clauses.size(); ++i) {
      EXPECT_EQ(ontology.classes[c].clauses[i].background, before.classes[c].clauses[i].background);
      EXPECT_EQ(ontology.classes[c].clauses[i].hit_rate, before.classes[c].clauses[i].hit_rate);
    }
  }
}

TEST(NewClasses, AreThoseWithoutACountedPriorOrWithOwnWords) {
  Ontology ontology = with_own("");
  EXPECT_TRUE(new_classes(ontology).empty());
  ontology.classes[1].clauses[0].hit_rate = -1.0;
  EXPECT_TRUE(new_classes(ontology).empty()) << "a word more does not make another class";
  ontology.classes[1].clauses[1].hit_rate = -1.0;
  EXPECT_EQ(new_classes(ontology), std::vector<int>{1});
  EXPECT_EQ(new_classes(with_own(bench)), std::vector<int>{2});
}

}  // namespace
}  // namespace scanchor
