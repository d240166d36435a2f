#include "reasoning/groups.hpp"

#include <gtest/gtest.h>

#include "reasoning/check_proof.hpp"
#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Groups, CountProbabilityAgainstAllSubsets) {
  const std::vector<double> p = {0.9, 0.4, 0.7, 0.2, 0.55};
  for (int low = 0; low <= 5; ++low) {
    for (int high = low; high <= 5; ++high) {
      double sum = 0.0;
      for (unsigned subset = 0; subset < 32; ++subset) {
        double product = 1.0;
        int members = 0;
        for (unsigned i = 0; i < 5; ++i) {
          const bool in = (subset >> i & 1U) != 0;
          product *= in ? p[i] : 1.0 - p[i];
          members += in ? 1 : 0;
        }
        if (members >= low && members <= high) sum += product;
      }
      EXPECT_NEAR(count_probability(p, low, high), sum, 1e-12);
    }
  }
}

struct Shelf : testing::Test {
  std::vector<test::Plate> plates = [] {
    auto all = std::vector<test::Plate>{test::floor_plate()};
    for (const auto& board : test::shelf_boards(4)) all.push_back(board);
    return all;
  }();
  Labelling label() const {
    return reason(test::make_surfaces(plates), test::shipped("paper"), {});
  }
  int shelves() const { return test::count_things(label(), "shelf"); }
};

TEST_F(Shelf, AllSixSentencesHold) {
  const auto labelling = label();
  ASSERT_EQ(test::count_things(labelling, "shelf"), 1);
  const auto& shelf = labelling.entities.back();
  EXPECT_EQ(shelf.label, "shelf");
  EXPECT_EQ(shelf.members, (std::vector<std::int32_t>{1, 2, 3, 4})) << "boards from below";
  EXPECT_NEAR(shelf.size.x(), 1.2, 0.02);
  EXPECT_NEAR(shelf.center.z(), 0.9, 0.01);
  EXPECT_GT(shelf.probability, 0.5);
}

// Each negative differs from the shelf in one property.
TEST_F(Shelf, SentenceOneElongationUnderTwoMetres) {
  for (std::size_t i = 1; i < plates.size(); ++i) plates[i].length = 2.6;
  EXPECT_EQ(shelves(), 0);
}
TEST_F(Shelf, SentenceTwoMoreThanOne) {
  plates.resize(2);
  EXPECT_EQ(shelves(), 0);
}
TEST_F(Shelf, SentenceThreeAreaUnderTwoSquareMetres) {
  for (std::size_t i = 1; i < plates.size(); ++i)
    plates[i].length = plates[i].width = 1.65;  // sides under 2 m, 2.7 m2
  EXPECT_EQ(shelves(), 0);
}
TEST_F(Shelf, SentenceFourParallelToEachOther) {
  for (std::size_t i = 2; i < plates.size(); i += 2) plates[i].normal = {0.25, 0, 1};
  plates.resize(3);
  EXPECT_EQ(shelves(), 0);
}
TEST_F(Shelf, SentenceFourParallelToTheFloor) {
  for (std::size_t i = 1; i < plates.size(); ++i) plates[i].normal = {0.3, 0, 1};
  EXPECT_EQ(shelves(), 0);
}
TEST_F(Shelf, SentenceFiveSameSize) {
  plates.resize(3);
  plates[2].length = 0.6;
  EXPECT_EQ(shelves(), 0);
}
TEST_F(Shelf, SentenceSixSameVerticalAlignment) {
  plates.resize(3);
  plates[2].center.x() += 1.5;
  EXPECT_EQ(shelves(), 0);
}

TEST_F(Shelf, TwoShelvesSideBySideAreTwo) {
  for (auto board : test::shelf_boards(4)) {
    board.center.x() += 1.3;
    plates.push_back(board);
  }
  EXPECT_EQ(shelves(), 2);
}

TEST_F(Shelf, MembersAreCounted) {
  // Its own description, with a weight for each number of boards.
  const auto tall = parse_ontology(
      "class board part of tall shelf:\n    horizontal\n    extension 1..2 m\n    width 0.2..0.6 "
      "m\n"
      "class tall shelf:\n    at least 2 boards, each pair\n        parallel\n        stacked\n"
      "    members 3..4\n",
      "x.sdl");
  for (const int boards : {2, 3, 4, 5}) {
    auto some = test::shelf_boards(boards);
    some.insert(some.begin(), test::floor_plate());
    const auto surfaces = test::make_surfaces(some);
    const auto labelling = reason(surfaces, tall, {});
    EXPECT_EQ(test::count_things(labelling, "tall shelf"), boards == 3 || boards == 4 ? 1 : 0)
        << boards;
    for (std::size_t e = 0; e < labelling.entities.size(); ++e) {
      for (const auto& fault : check_proof(surfaces, tall, labelling, static_cast<int>(e)))
        ADD_FAILURE() << fault.clause << ": " << fault.text;
    }
  }
}

TEST_F(Shelf, OrderOfTheBoardsDoesNotMatter) {
  const double p = label().entities.back().probability;
  std::reverse(plates.begin(), plates.end());
  const auto labelling = label();
  EXPECT_EQ(test::count_things(labelling, "shelf"), 1);
  EXPECT_NEAR(labelling.entities.back().probability, p, 1e-9);
}

}  // namespace
}  // namespace scanchor
