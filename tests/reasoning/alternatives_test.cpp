#include "reasoning/alternatives.hpp"

#include <gtest/gtest.h>

#include "core/json.hpp"
#include "reasoning/check_proof.hpp"
#include "reasoning/explain.hpp"
#include "tests/reasoning/support/scanned.hpp"

namespace scanchor {
namespace {

/// Descriptions by hand, so that no counted rate decides these tests.
const Ontology& described() {
  static const Ontology ontology = parse_ontology(
      "axiom floor:\n    area at least 4 m2\n    horizontal\n    lowest\n"
      "class desk:\n    area 0.6..1.7 m2\n    extension 1.1..2 m\n    width 0.5..1 m\n"
      "    rectangular\n    horizontal\n    elevation 0.6..0.9 m above a floor\n"
      "class monitor:\n    extension 0.4..0.8 m\n    width 0.25..0.5 m\n    rectangular\n"
      "    vertical\n    above a desk\n"
      "class board:\n    extension 1.5..3 m\n    width 0.8..1.4 m\n    vertical\n    rectangular\n",
      "own.sdl");
  return ontology;
}

std::vector<test::Plate> room_with(const test::Plate& more) {
  return {test::floor_plate(), {{0, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.8, 0.8}, more};
}
/// Two monitors of 0.56 x 0.34 m side by side, found as one plane.
test::Plate pair() { return {{0, 2.1, 1.05}, {0, -1, 0}, {1, 0, 0}, 1.16, 0.34}; }

Labelling read(test::Scanned& scene, bool alternatives = true) {
  ReasonOptions options;
  options.alternatives = alternatives;
  return interpret(scene.surfaces, scene.cloud, described(), options);
}

TEST(Alternatives, AMergedPairIsFoundAsTwo) {
  auto scene = test::scanned(room_with(pair()));
  test::take_out(scene, 2, -0.02, 0.02);  // the bezels between them
  auto as_one = scene;
  EXPECT_EQ(test::count_things(read(as_one, false), "monitor"), 0);
  const std::size_t points = scene.surfaces.surfaces[2].inliers.size();
  const auto labelling = read(scene);
  EXPECT_EQ(test::count_things(labelling, "monitor"), 2);
  ASSERT_EQ(labelling.alternatives.size(), 1U);
  const auto& cut = labelling.alternatives[0];
  EXPECT_EQ(cut.kind, "cut at seams");
  EXPECT_EQ(cut.class_name, "monitor");
  EXPECT_EQ(cut.of, 1);
  ASSERT_EQ(cut.surfaces.size(), 2U);
  EXPECT_GT(cut.log_ratio, 0.0);
  EXPECT_LT(cut.log_prior, 0.0);
  // Every point belongs to one of the two now, and their proofs hold.
  std::size_t after = 0;
  for (const auto s : cut.surfaces) {
    after += scene.surfaces.surfaces[s].inliers.size();
    for (const auto& fault : check_proof(scene.surfaces, described(), labelling, s))
      ADD_FAILURE() << fault.clause << ": " << fault.text;
  }
  EXPECT_EQ(after, points);
  EXPECT_NE(explain(labelling, cut.surfaces[0]).find("one surface cut at seams: as a monitor e^"),
            std::string::npos);
}

TEST(Alternatives, WithoutASeamItTakesMore) {
  auto with = test::scanned(room_with(pair()));
  auto without = with;
  test::take_out(with, 2, -0.02, 0.02);
  const auto at_seam = read(with).alternatives;
  const auto evenly = read(without).alternatives;
  ASSERT_EQ(at_seam.size(), 1U);
  ASSERT_EQ(evenly.size(), 1U) << "all else says that these are two";
  EXPECT_EQ(evenly[0].kind, "cut evenly");
  EXPECT_LT(evenly[0].log_prior, at_seam[0].log_prior - 2.0);
  EXPECT_LT(evenly[0].log_ratio, at_seam[0].log_ratio - 2.0);
  // What is only half a monitor by its height, too, is left alone without a seam.
  auto low = test::scanned(room_with({{0, 2.1, 1.0}, {0, -1, 0}, {1, 0, 0}, 1.16, 0.26}));
  auto low_with = low;
  test::take_out(low_with, 2, -0.02, 0.02);
  EXPECT_EQ(read(low_with).alternatives.size(), 1U);
}

TEST(Alternatives, AVagueClassIsNoReasonToCut) {
  const Ontology vague =
      parse_ontology("class strip:\n    vertical\n    extension at most 0.7 m\n", "x.sdl");
  auto scene = test::scanned(room_with(pair()));
  const auto labelling = interpret(scene.surfaces, scene.cloud, vague, {});
  EXPECT_TRUE(labelling.alternatives.empty());
}

TEST(Alternatives, UnequalPiecesAreNoPair) {
  auto scene = test::scanned(room_with(pair()));
  test::take_out(scene, 2, 0.12, 0.16);  // 0.70 m and 0.42 m
  EXPECT_TRUE(read(scene).alternatives.empty());
}

TEST(Alternatives, AWideThingStaysOne) {
  // A board of 1.8 x 0.9 m with a joint in its middle: as it is it fits a class.
  auto scene = test::scanned(room_with({{0, 2.4, 1.4}, {0, -1, 0}, {1, 0, 0}, 1.8, 0.9}));
  test::take_out(scene, 2, -0.02, 0.02);
  const auto labelling = read(scene);
  EXPECT_TRUE(labelling.alternatives.empty());
  EXPECT_EQ(test::count_things(labelling, "board"), 1);
}

TEST(Alternatives, ARowWithWideGapsIsSeveralThings) {
  // Two boards of 1.6 and 1.7 m in one plane: as one they are no worse a "panel", but a gap of 0.8
  // m says that they are two; one of 0.4 m may be a shadow's.
  const Ontology panels = parse_ontology(
      "class panel:\n    extension 1.5..6 m\n    width 0.8..1.4 m\n    vertical\n", "own.sdl");
  const auto count = [&](double gap) {
    auto scene = test::scanned(room_with({{0, 2.4, 1.4}, {0, -1, 0}, {1, 0, 0}, 3.3 + gap, 0.9}));
    test::take_out(scene, 2, -0.05 - gap / 2, -0.05 + gap / 2);
    const auto labelling = interpret(scene.surfaces, scene.cloud, panels, {});
    EXPECT_EQ(labelling.alternatives.size(), gap > 0.6 ? 1U : 0U);
    return test::count_things(labelling, "panel");
  };
  EXPECT_EQ(count(0.8), 2);
  EXPECT_EQ(count(0.4), 1);
}

TEST(Alternatives, ADeskPartedByAShadowIsJoined) {
  std::vector<test::Plate> plates = {test::floor_plate(),
                                     {{-0.5, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 0.8, 0.8},
                                     {{0.55, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 0.8, 0.75}};
  auto parted = test::scanned(plates);
  auto seen = parted;
  EXPECT_EQ(test::count_things(read(seen), "desk"), 0)
      << "two small tables with a gap that was seen";
  EXPECT_TRUE(read(seen).alternatives.empty());
  test::shade(parted, 1, {1, 0, 0});
  test::shade(parted, 2, {-1, 0, 0});
  auto as_two = parted;
  const int before = test::count_things(read(as_two, false), "desk");
  const auto labelling = read(parted);
  EXPECT_EQ(test::count_things(labelling, "desk"), 1) << before;
  ASSERT_EQ(labelling.alternatives.size(), 1U);
  EXPECT_EQ(labelling.alternatives[0].kind, "joined over a shadow");
  EXPECT_EQ(labelling.alternatives[0].of, 2);
  ASSERT_EQ(parted.surfaces.surfaces.size(), 2U);
  EXPECT_NEAR(parted.surfaces.surfaces[1].rectangle.length.value, 1.85, 1e-6);
  for (const auto& fault : check_proof(parted.surfaces, described(), labelling, 1))
    ADD_FAILURE() << fault.clause << ": " << fault.text;
}

TEST(Alternatives, TwoDesksWithAGapThatWasSeenStayTwo) {
  const std::vector<test::Plate> plates = {test::floor_plate(),
                                           {{-0.9, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.5, 0.8},
                                           {{0.9, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.5, 0.8}};
  auto scene = test::scanned(plates);
  const auto labelling = read(scene);
  EXPECT_EQ(test::count_things(labelling, "desk"), 2);
  EXPECT_TRUE(labelling.alternatives.empty());
  auto shaded = test::scanned(plates);
  test::shade(shaded, 1, {1, 0, 0});
  test::shade(shaded, 2, {-1, 0, 0});
  EXPECT_EQ(test::count_things(read(shaded), "desk"), 2) << "3.3 m is no desk";
}

TEST(Alternatives, AreWrittenAndReadBack) {
  auto scene = test::scanned(room_with(pair()));
  test::take_out(scene, 2, -0.02, 0.02);
  const auto labelling = read(scene);
  const auto back = labelling_from_json(labelling_to_json(labelling, {}), "labels.json");
  ASSERT_EQ(back.alternatives.size(), 1U);
  EXPECT_EQ(back.alternatives[0].kind, labelling.alternatives[0].kind);
  EXPECT_EQ(back.alternatives[0].surfaces, labelling.alternatives[0].surfaces);
  EXPECT_DOUBLE_EQ(back.alternatives[0].log_ratio, labelling.alternatives[0].log_ratio);
}

TEST(Alternatives, NothingToReadAnewChangesNothing) {
  Surfaces none;
  EXPECT_TRUE(read_anew(none, {}, described(), {}).empty());
  auto scene = test::scanned(room_with(pair()));
  for (auto& s : scene.surfaces.surfaces) s.inliers.clear();  // read from a file that left them out
  EXPECT_TRUE(read(scene).alternatives.empty());
  ReasonOptions paper;
  paper.mode = "paper";
  test::take_out(scene, 2, -0.02, 0.02);
  EXPECT_TRUE(read_anew(scene.surfaces, scene.cloud, described(), paper).empty());
}

}  // namespace
}  // namespace scanchor
