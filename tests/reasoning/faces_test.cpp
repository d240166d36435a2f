#include "reasoning/faces.hpp"

#include <gtest/gtest.h>

#include "reasoning/reason.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

/// Halves of tops 0.74 m above a floor, their middles at these places along x.
std::vector<test::Plate> tops(const std::vector<double>& x, double length) {
  std::vector<test::Plate> plates = {test::floor_plate()};
  for (const double at : x) plates.push_back({{at, 0.0, 0.74}, {0, 0, 1}, {1, 0, 0}, length, 0.7});
  return plates;
}

const char* const tops_in_pieces = R"(
axiom floor:
    horizontal
    lowest
class desk:
    several faces
    horizontal
    elevation 0.6..0.9 m above a floor
    extension 0.4..2.6 m
    usually extension 1.2..2 m
)";

TEST(Faces, PiecesOfOnePlaneAreOneThingOfUsualSize) {
  const auto ontology = parse_ontology(tops_in_pieces, "x.sdl");
  // A desk of 1.8 m under a shadow of 20 cm.
  const auto parted = reason(test::make_surfaces(tops({-0.5, 0.5}, 0.8)), ontology, {});
  EXPECT_EQ(test::count_things(parted, "desk"), 1);
  EXPECT_EQ(parted.entity_of_surface, (std::vector<std::int32_t>{0, 1, 1}));
  // Two of 1.4 m side by side, touching: together longer than desks are.
  const auto row = reason(test::make_surfaces(tops({-0.7, 0.71}, 1.4)), ontology, {});
  EXPECT_EQ(test::count_things(row, "desk"), 2);
  // Halves half a metre apart.
  const auto apart = reason(test::make_surfaces(tops({-0.65, 0.65}, 0.6)), ontology, {});
  EXPECT_EQ(test::count_things(apart, "desk"), 2);
}

/// How many windows are two upright faces: 1.2 x 1.2 m at the origin and one of this size at `at`.
int windows_of(const Eigen::Vector3d& at, double length, double width,
               const Eigen::Vector3d& normal = {0, -1, 0}) {
  const auto ontology = parse_ontology(
      "class window:\n    several faces\n    vertical within 50 deg\n    extension 0.3..2 m\n",
      "x.sdl");
  return test::count_things(
      reason(test::make_surfaces({{{0, 0, 1.5}, {0, -1, 0}, {1, 0, 0}, 1.2, 1.2},
                                  {at, normal, {1, 0, 0}, length, width}}),
             ontology, {}),
      "window");
}

TEST(Faces, APaneAndItsFrameAreOneWindow) {
  EXPECT_EQ(windows_of({0.5, -0.15, 1.5}, 0.5, 0.3), 1) << "before the pane";
  EXPECT_EQ(windows_of({0.5, -0.45, 1.5}, 0.5, 0.3), 2) << "no reveal is that deep";
  EXPECT_EQ(windows_of({0.86, -0.04, 1.5}, 0.5, 0.3), 1) << "goes on at its side";
  EXPECT_EQ(windows_of({1.05, -0.04, 1.5}, 0.5, 0.3), 2) << "beside it with a gap";
  EXPECT_EQ(windows_of({1.2, -0.1, 1.5}, 1.2, 1.2), 2) << "together larger than a window";
}

TEST(Faces, LayersMayLeanALittle) {
  const auto leaning = [](double deg) {
    const double a = deg * 3.14159265358979 / 180.0;
    return windows_of({0, -0.15, 1.0}, 0.8, 0.3, {0, -std::cos(a), std::sin(a)});
  };
  EXPECT_EQ(leaning(20), 1);
  EXPECT_EQ(leaning(45), 2);
}

TEST(Faces, APartFitsIntoTheLengthOfItsWhole) {
  const auto ontology = parse_ontology(
      "class screen:\n    vertical\n    width at least 0.3 m\n    extension 0.4..0.8 m\n"
      "class screen piece part of screen:\n    width under 0.2 m\n    within 1 m of a screen\n",
      "x.sdl");
  // A strip of 0.3 m beside a screen of 0.6 m: with it 0.77 m long, or 1.2 m from end to end.
  const auto whole_of_strip = [&](double x) {
    return reason(test::make_surfaces({{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}, 0.6, 0.35},
                                       {{x, 0.1, 1}, {0, -1, 0}, {1, 0, 0}, 0.3, 0.1}}),
                  ontology, {})
        .entities[1]
        .whole;
  };
  EXPECT_EQ(whole_of_strip(0.32), 0);
  EXPECT_EQ(whole_of_strip(0.75), -1);
}

}  // namespace
}  // namespace scanchor
