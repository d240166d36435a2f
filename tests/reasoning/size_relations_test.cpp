#include "reasoning/size_relations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "reasoning/relation_model.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

using test::Plate;

const RelationModel usual;  // whatever was fitted

Item item(const Plate& plate) {
  return make_items(test::make_surfaces({plate}), Eigen::Matrix3d::Identity()).front();
}
double same(const Plate& a, const Plate& b, const RelationModel& model = usual) {
  return same_size_relation(item(a), item(b), model).likelihood;
}
double aligned(const Plate& a, const Plate& b, const RelationModel& model = usual) {
  return aligned_relation(item(a), item(b), model).likelihood;
}

const Plate board{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, 0.9, 0.3};
Plate moved(double x, double z) {
  Plate plate = board;
  plate.center += Eigen::Vector3d(x, 0.0, z);
  return plate;
}
Plate turned(double deg) {
  Plate plate = moved(0.0, 0.4);
  plate.along = {std::cos(radians(deg)), std::sin(radians(deg)), 0.0};
  return plate;
}
Plate longer(double by) {
  Plate plate = board;
  plate.length *= by;
  return plate;
}

TEST(SizeRelations, SizesMayDifferByAsMuchAsTheWordSays) {
  EXPECT_GT(same(board, board), 0.95);
  EXPECT_GT(same(board, longer(1.05)), 0.9);
  EXPECT_LT(same(board, longer(1.4)), 0.05);
  EXPECT_NEAR(same(longer(1.1), board), same(board, longer(1.1)), 1e-12);
}

TEST(SizeRelations, OfOneMakeIsLikelierWhereThatIsFrequent) {
  RelationModel seldom = usual, often = usual;
  seldom.twins = 0.001;
  often.twins = 0.5;
  Plate poor = longer(1.16);  // past the limit as measured
  poor.edge_sigma = 0.04;
  EXPECT_GT(same(board, poor, often), same(board, poor, seldom) + 0.2);
  // Past all doubt it does not matter.
  EXPECT_LT(same(board, longer(2.0), often), 0.01);
}

TEST(SizeRelations, OnlyWhatGoesOnUnseenMayBeLonger) {
  Plate cut = longer(0.75);
  const double plain = same(board, cut);
  cut.hidden = 0.8;
  EXPECT_GT(same(board, cut), 5.0 * plain);
  Plate whole = board;
  whole.hidden = 0.8;  // the longer one may be longer still
  EXPECT_LE(same(whole, longer(0.75)), plain + 1e-9);
}

TEST(SizeRelations, StackedBoardsAreAligned) {
  EXPECT_GT(aligned(board, moved(0.0, 0.4)), 0.95);
  EXPECT_LT(aligned(board, moved(0.3, 0.4)), 0.05);
  EXPECT_LT(aligned(board, moved(0.0, 0.01)), 0.05) << "in one place, not stacked";
  EXPECT_NEAR(aligned(moved(0.05, 0.4), board), aligned(board, moved(0.05, 0.4)), 1e-12);
}

TEST(SizeRelations, LongThingsHaveToLieParallel) {
  EXPECT_LT(aligned(board, turned(30.0)), 0.1);
  Plate square = turned(30.0);
  square.width = square.length;
  EXPECT_GT(aligned(board, square), 0.9) << "nobody sees how a square is turned";
  // A stack is parallel: where the sides are hardly known, a turn is no turn.
  Plate poor = turned(20.0);
  poor.edge_sigma = 0.15;
  EXPECT_GT(aligned(board, poor), aligned(board, turned(20.0)) + 0.1);
}

TEST(SizeRelations, AShadowMovesTheMiddleAlongTheSideItHides) {
  Item wide = item(board), cut = item(moved(0.0, 0.4));
  const double plain = aligned_relation(wide, cut, usual).likelihood;
  cut.open = {0.0, 0.0, 0.0, 1.0};
  const double across = aligned_relation(wide, cut, usual).likelihood;
  cut.open = {0.0, 1.0, 0.0, 0.0};
  const double along = aligned_relation(wide, cut, usual).likelihood;
  EXPECT_LT(across, plain);
  EXPECT_LT(along, across - 0.05);
}

TEST(SizeRelations, NothingIsNoSize) {
  Item nothing;
  EXPECT_EQ(same_size_relation(nothing, item(board), usual).likelihood, 0.0);
  EXPECT_TRUE(std::isfinite(aligned_relation(nothing, item(board), usual).likelihood));
}

}  // namespace
}  // namespace scanchor
