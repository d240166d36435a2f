#include "eval/objects.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

struct Case {
  SmallScan made = small_scan();
  Protocol protocol;
  ScanTruth truth = truth_of(made.scan, &made.scene, protocol);
  PointPrediction said = perfect_prediction(truth);
  [[nodiscard]] ObjectSummary summary(std::vector<ClassId> described = {}) const {
    return summarize_objects(truth, said, protocol, described);
  }
  // All points of an instance, or of one of its planes, are said to be something else.
  void rename(std::int32_t instance, const char* name, std::int32_t entity) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (truth.instance[i] != instance) continue;
      said.class_id[i] = *find_class(name);
      said.instance[i] = entity;
    }
  }
};

const ThingResult& thing(const ObjectSummary& summary, const char* name) {
  for (const auto& t : summary.things) {
    if (t.name.rfind(name, 0) == 0) return t;
  }
  throw std::runtime_error(name);
}

TEST(Objects, PerfectAnswerFindsEverythingThatCounts) {
  const ObjectSummary summary = Case{}.summary();
  EXPECT_EQ(summary.score.total().truths, 3);
  EXPECT_EQ(summary.score.total().found, 3);
  EXPECT_EQ(summary.score.total().precision(), 1.0);
  EXPECT_EQ(summary.score.ignored, 1);  // the cup
  EXPECT_EQ(summary.things.front().name, "floor");
}

TEST(Objects, AThingIsFoundByItsTopAlone) {
  Case c;
  // The desk's front is said to be nothing: the top has more than a quarter of the points.
  for (std::size_t i = 0; i < c.truth.size(); ++i) {
    if (c.truth.instance[i] != 2) continue;
    if (c.truth.planes[static_cast<std::size_t>(c.truth.plane[i])].normal.z() < 0.9)
      c.said.class_id[i] = unlabelled;
  }
  const auto summary = c.summary();
  EXPECT_EQ(thing(summary, "desk").status, ThingStatus::found);
  EXPECT_LT(thing(summary, "desk").coverage, 0.8);
}

TEST(Objects, CalledSomethingElseIsMissedAndWrong) {
  Case c;
  c.rename(3, "desk", 77);
  const auto summary = c.summary();
  EXPECT_EQ(thing(summary, "cabinet").status, ThingStatus::missed);
  EXPECT_EQ(thing(summary, "cabinet").called, *find_class("desk"));
  EXPECT_EQ(summary.score.classes[static_cast<std::size_t>(*find_class("desk"))].wrong, 1);
  EXPECT_NEAR(summary.score.total().precision(), 2.0 / 3.0, 1e-12);
  const std::string text = objects_to_text(summary);
  EXPECT_THAT(text, testing::HasSubstr("missed: cabinet 3"));
  EXPECT_THAT(text, testing::HasSubstr("called desk"));
  EXPECT_THAT(text, testing::HasSubstr("wrong: desk"));
}

TEST(Objects, TwoClaimsOnOneThingAreOneFoundOneRepeated) {
  Case c;
  for (std::size_t i = 0; i < c.truth.size(); ++i) {
    if (c.truth.instance[i] == 2 &&
        c.truth.planes[static_cast<std::size_t>(c.truth.plane[i])].normal.z() < 0.9)
      c.said.instance[i] = 50;
  }
  const auto counts = c.summary().score.classes[static_cast<std::size_t>(*find_class("desk"))];
  EXPECT_EQ(counts.found, 1);
  EXPECT_EQ(counts.repeated, 1);
  EXPECT_EQ(counts.wrong, 0);
}

TEST(Objects, AClaimAcrossTwoThingsFindsNeither) {
  Case c;
  c.rename(2, "desk", 9);
  c.rename(3, "desk", 9);
  std::size_t floor = 0;
  for (std::size_t i = 0; i < c.truth.size() && floor < 3000; ++i) {
    if (c.truth.instance[i] == 1)
      c.said.class_id[i] = *find_class("desk"), c.said.instance[i] = 9, ++floor;
  }
  EXPECT_EQ(thing(c.summary(), "desk").status, ThingStatus::missed);
}

TEST(Objects, ClaimOnWhatCouldNotBeSeenIsIgnored) {
  Case c;
  c.rename(4, "bottle", 60);
  EXPECT_EQ(c.summary().score.total().wrong, 0);
}

TEST(Objects, ClassesWithoutAWordAreNotMissed) {
  Case c;
  c.rename(3, "unlabelled", -1);
  const auto summary = c.summary({*find_class("desk"), *find_class("floor")});
  EXPECT_EQ(thing(summary, "cabinet").status, ThingStatus::not_described);
  EXPECT_EQ(summary.score.total().recall(), 1.0);
  EXPECT_EQ(summary.score.not_described, 2);
}

TEST(Objects, PoolingAddsCounts) {
  Case good, bad;
  bad.rename(3, "desk", 77);
  ObjectScore pooled = good.summary().score;
  pooled.add(bad.summary().score);
  EXPECT_EQ(pooled.total().truths, 6);
  EXPECT_EQ(pooled.total().found, 5);
  EXPECT_NEAR(pooled.total().f1(), 10.0 / 12.0, 1e-12);
}

}  // namespace
}  // namespace scanchor
