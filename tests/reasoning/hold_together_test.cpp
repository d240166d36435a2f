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

}  // namespace
}  // namespace scanchor
