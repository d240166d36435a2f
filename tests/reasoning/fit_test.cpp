#include "reasoning/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/random.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

const char* const classes = R"(
class slab:
    horizontal
    extension 0.5..1 m
class panel:
    vertical
    extension 0.5..1 m
)";

/// Slabs of which one in four is too long, panels, and things that are neither.
TrainingScene scene(std::uint64_t seed) {
  SequentialRandom random(seed);
  std::vector<test::Plate> plates;
  TrainingScene result;
  for (int i = 0; i < 60; ++i) {
    test::Plate plate;
    plate.center = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(0, 2)};
    plate.width = 0.1;
    const auto kind = random.below(3);
    if (kind == 0) plate.length = random.chance(0.25) ? 2.0 : 0.75;
    if (kind == 1) {
      plate.normal = Eigen::Vector3d::UnitY();
      plate.length = 0.75;
    }
    if (kind == 2) {
      plate.normal = random.chance(0.5) ? Eigen::Vector3d(1, 0, 1) : Eigen::Vector3d::UnitZ();
      plate.length = random.chance(0.2) ? 0.75 : 0.2;
    }
    plates.push_back(plate);
    result.classes.push_back(kind == 0 ? "slab" : kind == 1 ? "panel" : "");
  }
  result.surfaces = test::make_surfaces(plates);
  return result;
}

double log_loss(const Ontology& ontology, const std::vector<TrainingScene>& scenes) {
  double sum = 0.0;
  for (const auto& s : scenes) {
    const auto labelling = reason(s.surfaces, ontology, {});
    for (std::size_t i = 0; i < s.classes.size(); ++i) {
      const auto& name = s.classes[i].empty() ? std::string("unknown") : s.classes[i];
      sum -= std::log(std::max(1e-3, test::probability_of(labelling.entities[i], name)));
    }
  }
  return sum;
}

TEST(Fit, CountsWhatIsThere) {
  std::vector<TrainingScene> scenes;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) scenes.push_back(scene(seed));
  const auto ontology = parse_ontology(classes, "x.sdl");
  const auto background = fit_backgrounds(ontology, scenes, {}, "built scenes 1 to 12");
  EXPECT_EQ(background.fitted_on, "built scenes 1 to 12");
  ASSERT_EQ(background.rates.size(), 4U);
  EXPECT_EQ(background.rates[1].clause, "extension 0.5..1 m");
  EXPECT_GT(background.rates[0].hit_rate, 0.9)
      << "all are, up to the 2 degrees that gravity is known to";
  EXPECT_GT(background.rates[1].hit_rate, 0.9) << "slabs that are too long teach nothing";
  EXPECT_NEAR(background.rates[1].background, (1.0 + 0.1) / 2.0, 0.1)
      << "panels, and few of the rest";

  // Among its candidates a class is expected as often as it is there.
  Ontology fitted = ontology;
  apply_background(fitted, background);
  double expected = 0.0;
  double there = 0.0;
  for (const auto& s : scenes) {
    const auto labelling = reason(s.surfaces, fitted, {});
    for (std::size_t i = 0; i < s.classes.size(); ++i) {
      const double p = test::probability_of(labelling.entities[i], "slab");
      expected += p;
      if (p > 0.0 && s.classes[i] == "slab") there += 1.0;
    }
  }
  EXPECT_GT(there, 100.0);
  EXPECT_NEAR(expected / there, 1.0, 0.03);

  // On scenes that were not counted the labels are better than with the defaults.
  std::vector<TrainingScene> held_out;
  for (std::uint64_t seed = 101; seed <= 106; ++seed) held_out.push_back(scene(seed));
  EXPECT_LT(log_loss(fitted, held_out), log_loss(ontology, held_out));
}

TEST(Fit, SameScenesSameNumbers) {
  const std::vector<TrainingScene> scenes = {scene(1), scene(2)};
  const auto ontology = parse_ontology(classes, "x.sdl");
  const auto a = fit_backgrounds(ontology, scenes, {}, "x");
  const auto b = fit_backgrounds(ontology, scenes, {}, "x");
  EXPECT_EQ(a.temperature, b.temperature);
  EXPECT_EQ(a.rates[0].background, b.rates[0].background);
}

TEST(Fit, RefusesWhatDoesNotMatch) {
  const auto ontology = parse_ontology(classes, "x.sdl");
  EXPECT_THROW(fit_backgrounds(ontology, {}, {}, "x"), Error);
  auto broken = scene(1);
  broken.classes.pop_back();
  EXPECT_THROW(fit_backgrounds(ontology, {broken}, {}, "x"), Error);
}

/// What is truly a panel teaches the kind of panel that its relations make it.
TEST(Fit, KindsAreTaughtByTheirOwnWords) {
  const auto ontology = parse_ontology(std::string(classes) + R"(
class lone panel is a panel:
    not within 20 cm of a slab
class close panel is a panel:
    within 20 cm of a slab
)",
                                       "x.sdl");
  const auto room = [](bool close) {
    TrainingScene result;
    std::vector<test::Plate> plates(2);
    plates[0].length = 0.75;
    plates[1].length = 0.75;
    plates[1].normal = Eigen::Vector3d::UnitY();
    plates[1].center = {0, close ? 0.1 : 2.0, 0};
    result.classes = {"slab", "panel"};
    result.surfaces = test::make_surfaces(plates);
    return result;
  };
  std::vector<TrainingScene> scenes;
  for (int i = 0; i < 40; ++i) scenes.push_back(room(i % 4 != 0));
  const auto background = fit_backgrounds(ontology, scenes, {}, "x");
  std::map<std::string, double> prior(background.priors.begin(), background.priors.end());
  EXPECT_LT(prior["panel"], 0.1 * prior["lone panel"]) << "each is of one kind or the other";
  Ontology fitted = ontology;
  apply_background(fitted, background);
  for (const bool close : {true, false}) {
    const auto labelling = reason(room(close).surfaces, fitted, {});
    EXPECT_EQ(labelling.entities[1].label, close ? "close panel" : "lone panel");
    EXPECT_GT(test::probability_of(labelling.entities[1], "panel"), 0.8) << "kinds count for it";
  }
}

/// Two ends that face each other, and two that stand one behind the other.
TrainingScene ends(std::uint64_t seed) {
  SequentialRandom random(seed);
  TrainingScene result;
  std::vector<test::Plate> plates;
  for (int i = 0; i < 6; ++i) {
    const bool desk = i % 2 == 0;
    for (int k = 0; k < 2; ++k) {
      test::Plate plate;
      plate.center = {5.0 * i + 1.5 * k, random.uniform(0, 20), 0.4};
      if (k == 1) plate.center.y() = plates.back().center.y();
      plate.normal = Eigen::Vector3d::UnitX();
      plate.along = Eigen::Vector3d::UnitY();
      plate.length = 0.8;
      plate.width = desk ? 0.75 : 0.45;
      plates.push_back(plate);
      result.classes.push_back(desk ? "desk" : "cabinet");
    }
  }
  result.surfaces = test::make_surfaces(plates);
  return result;
}

TEST(Fit, AGroupThatIsAPartIsTaughtByItsWhole) {
  const auto ontology = parse_ontology(
      "class desk:\n    horizontal\nclass end part of desk:\n    extension 0.5..1 m\n    vertical\n"
      "class frame part of desk:\n    exactly 2 ends, each pair\n        parallel\n        within "
      "2 m\n"
      "    usually height at least 0.6 m\nclass cabinet:\n    horizontal\n",
      "x.sdl");
  std::vector<TrainingScene> scenes;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) scenes.push_back(ends(seed));
  const auto background = fit_backgrounds(ontology, scenes, {}, "ends");
  const auto rate =
      std::find_if(background.rates.begin(), background.rates.end(),
                   [](const auto& r) { return r.clause == "usually height at least 0.6 m"; });
  ASSERT_NE(rate, background.rates.end());
  EXPECT_GT(rate->hit_rate, 0.8) << "frames of desks are frames";
  EXPECT_LT(rate->background, 0.3) << "pairs of cabinets are none";
}

}  // namespace
}  // namespace scanchor
