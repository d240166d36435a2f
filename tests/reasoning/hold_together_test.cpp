#include "reasoning/hold_together.hpp"

#include <gtest/gtest.h>

#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

const char* const words = R"(
axiom floor:
    area at least 4 m2
    horizontal
    lowest
class desk:
    area 0.1..3 m2
    extension 0.3..2.2 m
    horizontal
    elevation 0.7..0.8 m above a floor
class desk end part of desk:
    extension 0.5..0.9 m
    width 0.5..0.85 m
    vertical
    top 0.6..0.85 m above a floor
class desk frame part of desk:
    exactly 2 desk ends, each pair
        parallel
        within 1.9 m
    extension 1.2..1.8 m
    width 0.7..0.8 m
    height 0.7..0.8 m
)";

test::Plate end(double x) {
  test::Plate plate;
  plate.center = {x, 1.0, 0.37};
  plate.normal = Eigen::Vector3d::UnitX();
  plate.along = Eigen::Vector3d::UnitY();
  plate.length = 0.76;
  plate.width = 0.72;
  return plate;
}

test::Plate table_top(double x, double length) {
  test::Plate plate;
  plate.center = {x, 1.0, 0.74};
  plate.length = length;
  plate.width = 0.8;
  return plate;
}

Labelling labelled(std::vector<test::Plate> plates) {
  plates.insert(plates.begin(), test::floor_plate());
  return reason(test::make_surfaces(plates), parse_ontology(words, "x.sdl"), {});
}

TEST(HoldTogether, AFrameWithoutATopIsADesk) {
  const auto labelling = labelled({end(0.0), end(1.5)});
  EXPECT_EQ(test::count_things(labelling, "desk"), 1);
  EXPECT_EQ(labelling.entity_of_surface[1], labelling.entity_of_surface[2]);
  EXPECT_EQ(labelling.entities[labelling.entity_of_surface[1]].label, "desk");
}

TEST(HoldTogether, OneEndOrEndsTooFarApartAreNone) {
  EXPECT_EQ(test::count_things(labelled({end(0.0)}), "desk"), 0);
  EXPECT_EQ(test::count_things(labelled({end(0.0), end(2.6)}), "desk"), 0);
  auto across = end(1.5);
  across.normal = Eigen::Vector3d::UnitY();
  across.along = Eigen::Vector3d::UnitX();
  EXPECT_EQ(test::count_things(labelled({end(0.0), across}), "desk"), 0);
}

TEST(HoldTogether, PiecesOfATopAndTheFrameAreOneDeskNamedAfterTheLargest) {
  const auto labelling = labelled({end(0.0), end(1.5), table_top(0.2, 0.3), table_top(1.1, 0.7)});
  EXPECT_EQ(test::count_things(labelling, "desk"), 1);
  for (const int s : {1, 2, 3, 4}) EXPECT_EQ(labelling.entity_of_surface[s], 4) << s;
  EXPECT_EQ(labelling.entities[4].surfaces.size(), 4U);
}

TEST(HoldTogether, ADeskBesideTheFrameStaysItsOwn) {
  const auto labelling = labelled({end(0.0), end(1.5), table_top(2.4, 1.4)});
  EXPECT_EQ(test::count_things(labelling, "desk"), 2);
  EXPECT_EQ(labelling.entity_of_surface[3], 3);
  EXPECT_NE(labelling.entity_of_surface[1], 3);
}

TEST(HoldTogether, AFrameOnItsOwnTakesInWhatHasNoNameAndLiesWhollyWithinIt) {
  test::Plate bar;  // between the ends, half way up
  bar.center = {0.75, 1.0, 0.4};
  bar.normal = Eigen::Vector3d::UnitY();
  bar.along = Eigen::Vector3d::UnitX();
  bar.length = 1.2;
  bar.width = 0.05;
  auto sticks_out = bar;
  sticks_out.center.x() = 1.4;
  const auto labelling = labelled({end(0.0), end(1.5), bar, sticks_out});
  const auto desk = labelling.entity_of_surface[1];
  EXPECT_EQ(labelling.entities[desk].label, "desk");
  EXPECT_EQ(labelling.entity_of_surface[3], desk);
  EXPECT_EQ(labelling.entity_of_surface[4], 4);
}

TEST(HoldTogether, AFrameTakesNothingInWhereThereIsATop) {
  test::Plate bar;
  bar.center = {0.75, 1.0, 0.4};
  bar.normal = Eigen::Vector3d::UnitY();
  bar.along = Eigen::Vector3d::UnitX();
  bar.length = 1.2;
  bar.width = 0.05;
  const auto labelling = labelled({end(0.0), end(1.5), bar, table_top(0.75, 1.4)});
  EXPECT_EQ(labelling.entity_of_surface[1], 4);
  EXPECT_EQ(labelling.entity_of_surface[3], 3);
}

TEST(HoldTogether, BoardsAndThePanelsAroundThemAreOneShelf) {
  const char* const shelf = R"(
axiom floor:
    area at least 4 m2
    horizontal
    lowest
class board part of shelf:
    extension 0.6..1.2 m
    width 0.2..0.6 m
    horizontal
    bottom at least 0.1 m above a floor
class shelf:
    at least 2 boards, each pair
        parallel
        stacked
class panel part of shelf:
    extension 1.4..2.2 m
    width 0.3..0.5 m
    vertical
class carcass part of shelf:
    exactly 2 panels, each pair
        parallel
        within 1.3 m
)";
  const auto board = [](double z) {
    test::Plate plate;
    plate.center = {0.5, 1.0, z};
    plate.length = 0.9;
    plate.width = 0.38;
    return plate;
  };
  const auto panel = [](double x) {
    test::Plate plate;
    plate.center = {x, 1.0, 0.9};
    plate.normal = Eigen::Vector3d::UnitX();
    plate.along = Eigen::Vector3d::UnitZ();
    plate.length = 1.8;
    plate.width = 0.4;
    return plate;
  };
  std::vector<test::Plate> plates = {test::floor_plate(), board(0.4), board(0.8),
                                     board(1.2),          panel(0.0), panel(1.0)};
  const auto labelling = reason(test::make_surfaces(plates), parse_ontology(shelf, "x.sdl"), {});
  EXPECT_EQ(test::count_things(labelling, "shelf"), 1);
  for (const int s : {2, 3, 4, 5})
    EXPECT_EQ(labelling.entity_of_surface[s], labelling.entity_of_surface[1]) << s;

  // A second pair of panels further on is another shelf.
  plates.push_back(panel(2.5));
  plates.push_back(panel(3.5));
  const auto two = reason(test::make_surfaces(plates), parse_ontology(shelf, "x.sdl"), {});
  EXPECT_EQ(test::count_things(two, "shelf"), 2);
  EXPECT_NE(two.entity_of_surface[6], two.entity_of_surface[1]);
  EXPECT_EQ(two.entity_of_surface[6], two.entity_of_surface[7]);
}

// One end of a shelf is seen, and what shadows leave of its boards begins before it.
TEST(HoldTogether, AnEndBesideItsBoardsIsNoShelfOfItsOwn) {
  const char* const shelf = R"(
axiom floor:
    area at least 4 m2
    horizontal
    lowest
class board part of shelf:
    extension 0.5..1 m
    width 0.3..0.45 m
    horizontal
class shelf:
    at least 2 boards, each pair
        parallel
        stacked
class panel part of shelf:
    extension 1.4..2.2 m
    width 0.3..0.5 m
    vertical
class gable part of shelf:
    exactly 1 panels, each pair
        parallel
)";
  const auto shelves = [&](double gap) {
    std::vector<test::Plate> plates = {test::floor_plate()};
    for (const double z : {0.4, 0.8, 1.2}) {
      test::Plate board;
      board.center = {0.35, 1.0, z};
      board.length = 0.7;
      board.width = 0.38;
      plates.push_back(board);
    }
    test::Plate panel;
    panel.center = {0.7 + gap, 1.0, 0.9};
    panel.normal = Eigen::Vector3d::UnitX();
    panel.along = Eigen::Vector3d::UnitZ();
    panel.length = 1.8;
    panel.width = 0.4;
    plates.push_back(panel);
    return reason(test::make_surfaces(plates), parse_ontology(shelf, "x.sdl"), {});
  };
  const auto one = shelves(0.2);
  EXPECT_EQ(test::count_things(one, "shelf"), 1);
  EXPECT_EQ(one.entity_of_surface[4], one.entity_of_surface[1]);
  const auto two = shelves(0.8);
  EXPECT_EQ(test::count_things(two, "shelf"), 2) << "an end further on is another's";
  EXPECT_NE(two.entity_of_surface[4], two.entity_of_surface[1]);
}

}  // namespace
}  // namespace scanchor
