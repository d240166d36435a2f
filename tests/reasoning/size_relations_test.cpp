#include "reasoning/size_relations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "reasoning/relation_model.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

using test::Plate;

const RelationModel usual_model;  // whatever was fitted

Item sized_item(const Plate& plate) {
  return make_items(test::make_surfaces({plate}), Eigen::Matrix3d::Identity()).front();
}
double same_size_of(const Plate& a, const Plate& b, const RelationModel& model = usual_model) {
  return same_size_relation(sized_item(a), sized_item(b), model).likelihood;
}
double aligned_of(const Plate& a, const Plate& b, const RelationModel& model = usual_model) {
  return aligned_relation(sized_item(a), sized_item(b), model).likelihood;
}

const Plate size_board{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, 0.9, 0.3};
Plate moved_board(double x, double z) {
  Plate plate = size_board;
  plate.center += Eigen::Vector3d(x, 0.0, z);
  return plate;
}
Plate turned_board(double deg) {
  Plate plate = moved_board(0.0, 0.4);
  plate.along = {std::cos(radians(deg)), std::sin(radians(deg)), 0.0};
  return plate;
}
Plate longer_board(double by) {
  Plate plate = size_board;
  plate.length *= by;
  return plate;
}

TEST(SizeRelations, SizesMayDifferByAsMuchAsTheWordSays) {
  EXPECT_GT(same_size_of(size_board, size_board), 0.95);
  EXPECT_GT(same_size_of(size_board, longer_board(1.05)), 0.9);
  EXPECT_LT(same_size_of(size_board, longer_board(1.4)), 0.05);
  EXPECT_NEAR(same_size_of(longer_board(1.1), size_board),
              same_size_of(size_board, longer_board(1.1)), 1e-12);
}

TEST(SizeRelations, OfOneMakeIsLikelierWhereThatIsFrequent) {
  RelationModel seldom = usual_model, often = usual_model;
  seldom.twins = 0.001;
  often.twins = 0.5;
  Plate poor = longer_board(1.16);  // past the limit as measured
  poor.edge_sigma = 0.04;
  EXPECT_GT(same_size_of(size_board, poor, often), same_size_of(size_board, poor, seldom) + 0.2);
  // Past all doubt it does not matter.
  EXPECT_LT(same_size_of(size_board, longer_board(2.0), often), 0.01);
}

TEST(SizeRelations, OnlyWhatGoesOnUnseenMayBeLonger) {
  Plate cut = longer_board(0.75);
  const double plain = same_size_of(size_board, cut);
  cut.hidden = 0.8;
  EXPECT_GT(same_size_of(size_board, cut), 5.0 * plain);
  Plate whole = size_board;
  whole.hidden = 0.8;  // the longer one may be longer still
  EXPECT_LE(same_size_of(whole, longer_board(0.75)), plain + 1e-9);
}

TEST(SizeRelations, StackedBoardsAreAligned) {
  EXPECT_GT(aligned_of(size_board, moved_board(0.0, 0.4)), 0.95);
  EXPECT_LT(aligned_of(size_board, moved_board(0.3, 0.4)), 0.05);
  EXPECT_LT(aligned_of(size_board, moved_board(0.0, 0.01)), 0.05) << "in one place, not stacked";
  EXPECT_NEAR(aligned_of(moved_board(0.05, 0.4), size_board),
              aligned_of(size_board, moved_board(0.05, 0.4)), 1e-12);
}

TEST(SizeRelations, LongThingsHaveToLieParallel) {
  EXPECT_LT(aligned_of(size_board, turned_board(30.0)), 0.1);
  Plate square = turned_board(30.0);
  square.width = square.length;
  EXPECT_GT(aligned_of(size_board, square), 0.9) << "nobody sees how a square is turned";
  // A stack is parallel: where the sides are hardly known, a turn is no turn.
  Plate poor = turned_board(20.0);
  poor.edge_sigma = 0.15;
  EXPECT_GT(aligned_of(size_board, poor), aligned_of(size_board, turned_board(20.0)) + 0.1);
}

TEST(SizeRelations, AShadowMovesTheMiddleAlongTheSideItHides) {
  Item wide = sized_item(size_board), cut = sized_item(moved_board(0.0, 0.4));
  const double plain = aligned_relation(wide, cut, usual_model).likelihood;
  cut.open = {0.0, 0.0, 0.0, 1.0};
  const double across = aligned_relation(wide, cut, usual_model).likelihood;
  cut.open = {0.0, 1.0, 0.0, 0.0};
  const double along = aligned_relation(wide, cut, usual_model).likelihood;
  EXPECT_LT(across, plain);
  EXPECT_LT(along, across - 0.05);
}

TEST(SizeRelations, NothingIsNoSize) {
  Item nothing;
  EXPECT_EQ(same_size_relation(nothing, sized_item(size_board), usual_model).likelihood, 0.0);
  EXPECT_TRUE(
      std::isfinite(aligned_relation(nothing, sized_item(size_board), usual_model).likelihood));
}

}  // namespace
}  // namespace scanchor
