#include "reasoning/answer.hpp"

#include <gtest/gtest.h>

#include "tests/reasoning/support/labelled.hpp"

namespace scanchor {
namespace {

using test::Named;
using Status = Answer::Status;

/// Floor 0; desks 1 (left, with screen 3 on it, window 5 beside it) and 2 (right, larger, bare);
/// chair 4 before desk 1; board stack 6, 7, 8 at the back with its shelf 9.
std::vector<Named> named_room() {
  return {{test::floor_plate(), "floor"},
          {{{-1.5, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.6, 0.8}, "desk"},
          {{{1.5, 2, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.8, 0.9}, "desk"},
          {{{-1.5, 2.1, 1.05}, {0, -1, 0}, {1, 0, 0}, 0.57, 0.42}, "monitor"},
          {{{-1.5, 1.3, 0.45}, {0, 0, 1}, {1, 0, 0}, 0.45, 0.45}, "chair"},
          {{{-2.6, 2, 1.5}, {1, 0, 0}, {0, 1, 0}, 1.2, 1.0}, "window"},
          {{{0, -2, 0.3}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.35}, "unknown"},
          {{{0, -2, 0.7}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.35}, "unknown"},
          {{{0, -2, 1.1}, {0, 0, 1}, {1, 0, 0}, 1.0, 0.35}, "unknown"}};
}

struct Asked {
  Answer answer;
  std::string text;
  std::vector<std::int32_t> ids;
};

Asked ask(const std::string& question, const std::vector<Named>& named, bool shelf = true) {
  auto scene = test::labelled(named);
  if (shelf && named.size() > 8) test::add_group(scene, {6, 7, 8}, "shelf");
  const SceneThings things(scene.surfaces, test::office(), scene.labelling);
  Asked asked;
  asked.answer = answer(parse_query(question, test::office()), things);
  asked.text = answer_text(asked.answer, things);
  for (const auto& thing : asked.answer.things) asked.ids.push_back(thing.id);
  std::sort(asked.ids.begin(), asked.ids.end());
  return asked;
}
using Ids = std::vector<std::int32_t>;

struct Truth {
  const char* question;
  Status status;
  Ids ids;
};

class AnswerTable : public testing::TestWithParam<Truth> {};

TEST_P(AnswerTable, IsTheTruthOfTheRoom) {
  const Asked asked = ask(GetParam().question, named_room());
  EXPECT_EQ(status_word(asked.answer.status), status_word(GetParam().status)) << asked.text;
  EXPECT_EQ(asked.ids, GetParam().ids) << asked.text;
}

INSTANTIATE_TEST_SUITE_P(
    Room, AnswerTable,
    testing::Values(
        Truth{"desk", Status::ok, {1, 2}}, Truth{"the desk", Status::ambiguous, {1, 2}},
        Truth{"screen on a desk", Status::ok, {3}}, Truth{"desk with a screen", Status::ok, {1}},
        Truth{"desk with no screen", Status::ok, {2}},
        Truth{"desk that is near a window", Status::ok, {1}},
        Truth{"screen on a desk that is near a window", Status::ok, {3}},
        Truth{"chair near a desk with no screen", Status::not_found, {}},
        Truth{"largest desk", Status::ok, {2}}, Truth{"smallest desk", Status::ok, {1}},
        Truth{"second largest desk", Status::ok, {1}},
        Truth{"third largest desk", Status::not_found, {}}, Truth{"leftmost desk", Status::ok, {1}},
        Truth{"desk nearest to the chair", Status::ok, {1}},
        Truth{"desk farthest from the chair", Status::ok, {2}},
        Truth{"second board from the top of the shelf", Status::ok, {7}},
        Truth{"top board of the shelf", Status::ok, {8}},
        Truth{"last board from the top of the shelf", Status::ok, {6}},
        Truth{"window left of a desk", Status::ok, {5}},
        Truth{"window right of a desk", Status::not_found, {}},
        Truth{"desk within 0.5 m of a window", Status::ok, {1}},
        Truth{"desk that has area over 1.5 m2", Status::ok, {2}},
        Truth{"desk that is not near a window", Status::ok, {2}},
        Truth{"chair between the desk near a window and a shelf", Status::ok, {4}},
        Truth{"thing on a desk", Status::ok, {3}}, Truth{"door", Status::not_found, {}},
        Truth{"how many desks", Status::ok, {1, 2}}, Truth{"how many doors", Status::ok, {}},
        Truth{"is there a chair near a window", Status::ok, {}}),
    [](const auto& row) { return "q" + std::to_string(row.index); });

struct Contrast {
  const char* question;
  std::size_t moved;  ///< thing
  Eigen::Vector3d by;
  Ids before, after;
};

class ContrastTable : public testing::TestWithParam<Contrast> {};

TEST_P(ContrastTable, OneThingMovedChangesTheAnswer) {
  auto named = named_room();
  EXPECT_EQ(ask(GetParam().question, named).ids, GetParam().before);
  named[GetParam().moved].plate.center += GetParam().by;
  EXPECT_EQ(ask(GetParam().question, named).ids, GetParam().after);
}

INSTANTIATE_TEST_SUITE_P(
    Room, ContrastTable,
    testing::Values(
        Contrast{"screen on a desk", 3, {0, 0, 0.8}, {3}, {}},
        Contrast{"desk with no screen", 3, {3, 0, 0}, {2}, {1}},
        Contrast{"chair near a desk", 4, {0, -2, 0}, {4}, {}},
        Contrast{"desk near a window", 5, {5.2, 0, 0}, {1}, {2}},
        Contrast{"leftmost desk", 1, {5, 0, 0}, {1}, {2}},
        Contrast{"second board from the top of the shelf", 6, {0, 0, 0.6}, {7}, {6}},
        Contrast{"chair between the desk near a window and a shelf", 4, {-1.4, 0, 0}, {4}, {}}),
    [](const auto& row) { return "q" + std::to_string(row.index); });

TEST(Answer, CountsAndDistances) {
  const auto two = ask("how many desks", named_room());
  EXPECT_EQ(two.answer.count, 2);
  EXPECT_NEAR(two.answer.expected, 1.8, 1e-9);
  ASSERT_EQ(two.answer.distribution.size(), 3U);
  EXPECT_NEAR(two.answer.distribution[0], 0.01, 1e-9);
  EXPECT_NEAR(two.answer.distribution[1], 0.18, 1e-9);
  EXPECT_NEAR(two.answer.distribution[2], 0.81, 1e-9);
  EXPECT_NEAR(two.answer.exists, 0.99, 1e-9) << "noisy-or";
  EXPECT_EQ(ask("how many doors", named_room()).answer.distribution, std::vector<double>{1.0});
  const auto far = ask("distance from the chair to the smallest desk", named_room());
  ASSERT_TRUE(far.answer.distance);
  // The chair reaches y = 1.525 at z = 0.45, the desk begins at y = 1.6 at z = 0.74.
  EXPECT_NEAR(far.answer.distance->measured, std::hypot(0.29, 0.075), 1e-6);
  const auto apart = ask("distance from the chair to a door", named_room());
  EXPECT_EQ(apart.answer.status, Status::not_found);
  EXPECT_NE(apart.text.find("nothing in the scene is a door"), std::string::npos) << apart.text;
}

TEST(Answer, TheClosestMissNamesTheClauseAndTheChange) {
  const auto miss = ask("chair within 0.3 m of a window", named_room());
  EXPECT_EQ(miss.answer.status, Status::not_found);
  ASSERT_TRUE(miss.answer.closest);
  EXPECT_EQ(miss.answer.closest->id, 4);
  EXPECT_EQ(miss.answer.failing, "within 0.3 m of a window");
  ASSERT_EQ(miss.answer.closest->steps.size(), 1U);
  const auto& step = miss.answer.closest->steps[0];
  EXPECT_EQ(step.targets, Ids{5});
  ASSERT_TRUE(step.needed);
  EXPECT_DOUBLE_EQ(*step.needed, 0.3);
  EXPECT_GT(step.measured, 0.9);
  EXPECT_NE(miss.text.find("it would hold from 0.30 m"), std::string::npos) << miss.text;
  // Of two desks the one that fails in one clause is closer than the one that fails in two.
  const auto desks = ask(
      "desk with a screen and within 0.3 m of a window and that has area over 2 m2", named_room());
  ASSERT_TRUE(desks.answer.closest);
  EXPECT_EQ(desks.answer.closest->id, 1);
}

TEST(Answer, WhatWasNotSeenIsNoNo) {
  auto named = named_room();
  named[2].plate.hidden = 0.8;
  const auto bare = ask("desk with no screen", named);
  EXPECT_EQ(status_word(bare.answer.status), "not_seen") << bare.text;
  named[1].plate.hidden = 0.8;
  named[3].plate.center.z() += 1.0;
  const auto on = ask("the screen on the leftmost desk", named);
  EXPECT_EQ(status_word(on.answer.status), "not_seen") << on.text;
  named[1].plate.hidden = 0.0;
  EXPECT_EQ(status_word(ask("the screen on the leftmost desk", named).answer.status), "not_found");
  const auto box = ask("box on a desk", named);
  EXPECT_EQ(status_word(box.answer.status), "not_seen") << "desk 2 is hidden: " << box.text;
}

TEST(Answer, AmbiguousAsksWhatWouldTellApart) {
  const auto which = ask("the desk", named_room());
  EXPECT_EQ(which.answer.status, Status::ambiguous);
  EXPECT_NE(which.answer.ask.find("the smallest (1 at 1.28 m2) or the largest (2 at 1.62 m2)?"),
            std::string::npos)
      << which.answer.ask;
  auto sure = named_room();
  sure[2].probability = 0.6;
  EXPECT_EQ(ask("the desk", sure).answer.status, Status::ok) << "one is much likelier";
}

TEST(Answer, AnchorsAreWhatARobotGoesBy) {
  const auto screen = ask("screen on a desk that is near a window", named_room());
  ASSERT_EQ(screen.answer.things.size(), 1U);
  EXPECT_EQ(screen.answer.things[0].anchors, Ids{1});
  ASSERT_EQ(screen.answer.things[0].steps.size(), 1U);
  const auto& because = screen.answer.things[0].steps[0].because;
  ASSERT_EQ(because.size(), 2U) << "a desk, and near a window";
  EXPECT_EQ(because[1].targets, Ids{5});
  EXPECT_NEAR(screen.answer.things[0].probability, 0.9 * 0.9 * 0.9, 0.08);
}

}  // namespace
}  // namespace scanchor
