#include "reasoning/depth_relation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.hpp"
#include "reasoning/check_proof.hpp"
#include "reasoning/reason.hpp"
#include "reasoning/sdl_parser.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

test::Plate upright(double y, double turned_deg = 0.0) {
  test::Plate plate;
  plate.center = {0.3, y, 1.2};
  plate.normal = {std::sin(radians(turned_deg)), -std::cos(radians(turned_deg)), 0.0};
  plate.along = Eigen::Vector3d::UnitZ();
  plate.length = 1.2;
  plate.width = 0.9;
  return plate;
}

Evidence depth(const test::Plate& a, const test::Plate& b, double low, double high,
               std::optional<Eigen::Vector3d> viewpoint = Eigen::Vector3d(0.0, -2.0, 1.3)) {
  RelationTerm term{Relation::set_back, {}};
  term.range.low = low;
  term.range.high = high;
  auto items = make_items(test::make_surfaces({a, b}), Eigen::Matrix3d::Identity());
  Surrounding around;
  around.viewpoint = viewpoint;
  return set_back_relation(term, items[0], items[1], around);
}

TEST(DepthRelation, IsTheDistanceBehindThePlane) {
  const auto wall = upright(2.0);
  for (const double behind : {-0.2, 0.0, 0.1, 0.3, 0.6}) {
    const auto evidence = depth(upright(2.0 + behind), wall, 0.03, 0.35);
    EXPECT_NEAR(evidence.measured, behind, 1e-9);
    EXPECT_EQ(evidence.likelihood > 0.5, behind > 0.03 && behind < 0.35) << behind;
  }
}

TEST(DepthRelation, TurnsAroundWithTheSideItIsSeenFrom) {
  const auto wall = upright(2.0);
  const Eigen::Vector3d beyond(0.0, 6.0, 1.3);
  EXPECT_NEAR(depth(upright(2.1), wall, 0.03, 0.35, beyond).measured, -0.1, 1e-9);
  EXPECT_LT(depth(upright(2.1), wall, 0.03, 0.35, beyond).likelihood, 0.05);
  EXPECT_GT(depth(upright(1.9), wall, 0.03, 0.35, beyond).likelihood, 0.95);
}

TEST(DepthRelation, DoesNotDependOnTheSignOfTheNormal) {
  const auto pane = upright(2.15);
  const auto flipped = upright(2.0, 180.0);
  EXPECT_NEAR(depth(pane, upright(2.0), 0.03, 0.35).likelihood,
              depth(pane, flipped, 0.03, 0.35).likelihood, 1e-9);
}

TEST(DepthRelation, WithoutAPlaceToLookFromItIsNeitherYesNorNo) {
  EXPECT_EQ(depth(upright(2.1), upright(2.0), 0.03, 0.35, std::nullopt).likelihood, 0.5);
}

TEST(DepthRelation, AWallAroundTheCornerHasNoDepth) {
  EXPECT_GT(depth(upright(2.15, 8.0), upright(2.0), 0.03, 0.35).likelihood, 0.9);
  EXPECT_LT(depth(upright(2.15, 90.0), upright(2.0), 0.03, 0.35).likelihood, 0.01);
}

TEST(DepthRelation, TellsAWindowFromAPicture) {
  const auto ontology = parse_ontology(R"(axiom wall:
    area at least 4 m2
    vertical
class window:
    area at most 2 m2
    vertical
    set back 3..35 cm behind a wall
class picture:
    area at most 2 m2
    vertical
    not set back 3..35 cm behind a wall
)",
                                       "x.sdl");
  auto wall = upright(2.0);
  wall.length = 3.0;
  wall.width = 4.0;
  for (const double behind : {0.15, -0.03}) {
    auto surfaces = test::make_surfaces({wall, upright(2.0 + behind)});
    surfaces.sensor_positions = {Eigen::Vector3d(0.0, -2.0, 1.3)};
    auto labelling = reason(surfaces, ontology, {});
    EXPECT_EQ(labelling.entities[1].label, behind > 0.0 ? "window" : "picture") << behind;
    EXPECT_TRUE(check_proof(surfaces, ontology, labelling, 1).empty());
    if (behind < 0.0) continue;
    auto& proof = labelling.entities[1].proof;
    ASSERT_EQ(proof.back().text, "set back 3..35 cm behind a wall");
    EXPECT_NEAR(proof.back().measured, 0.15, 1e-6);
    proof.back().measured = 0.1;
    EXPECT_FALSE(check_proof(surfaces, ontology, labelling, 1).empty());
  }
}

}  // namespace
}  // namespace scanchor
