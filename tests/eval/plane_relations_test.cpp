#include "eval/plane_relations.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "eval/blame.hpp"
#include "eval/score.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

struct RelationCase {
  SmallScan made = small_scan();
  Protocol protocol;
  ScanTruth truth = truth_of(made.scan, &made.scene, protocol);
  Surfaces surfaces = perfect_shapes(made.scan, made.scene, truth, protocol);

  PlaneRelations lists() const {
    PlaneMatch match;
    score_planes(truth.plane, truth.ignored_planes, surfaces.plane_of_point, protocol, &match);
    return plane_relations(made.scan, made.scene, truth, match, surfaces, Eigen::Vector3d::UnitZ(),
                           0.0, protocol);
  }
  /// The plane whose first face is a level one of that instance at that height.
  std::int32_t level(double z) const {
    for (std::size_t p = 0; p < truth.planes.size(); ++p) {
      const auto& plane = truth.planes[p];
      const double height = plane.offset + made.scan.T_world_sensor.translation().z();
      if (plane.normal.z() > 0.9 && std::abs(height - z) < 1e-6)
        return static_cast<std::int32_t>(p);
    }
    return -1;
  }
};

bool lists_pair(const std::vector<NamedRelation>& facts, const std::string& relation,
                std::int32_t a, std::int32_t b) {
  return std::any_of(facts.begin(), facts.end(), [&](const NamedRelation& f) {
    return f.relation == relation && f.a == a && f.b == b && f.holds && f.probability >= 0.5;
  });
}

TEST(PlaneRelations, TheDeskIsAboveTheFloorInTruthAndClaim) {
  const RelationCase c;
  const std::int32_t floor = c.level(0.0), desk = c.level(0.72);
  ASSERT_GE(floor, 0);
  ASSERT_GE(desk, 0);
  const PlaneRelations lists = c.lists();
  for (const auto* facts : {&lists.truth, &lists.claims}) {
    EXPECT_TRUE(lists_pair(*facts, "above", desk, floor));
    EXPECT_FALSE(lists_pair(*facts, "above", floor, desk));
    EXPECT_TRUE(lists_pair(*facts, "parallel", std::min(floor, desk), std::max(floor, desk)));
    EXPECT_FALSE(lists_pair(*facts, "orthogonal", std::min(floor, desk), std::max(floor, desk)));
  }
}

TEST(PlaneRelations, PerfectShapesGivePerfectClearRelations) {
  const RelationCase c;
  PlaneRelations lists = c.lists();
  const RelationScore score = score_relations(lists.truth, lists.claims);
  ASSERT_FALSE(score.clear.empty());
  for (const auto& [name, counts] : score.clear) {
    EXPECT_EQ(counts.missed, 0) << name;
    // For "above" the reasoner asks for a share of the smaller footprint, the scene for one of the
    // upper thing's: the floor below a desk is all of the desk's footprint, and little of its own.
    if (name != "above") {
      EXPECT_EQ(counts.wrong, 0) << name;
    }
  }
}

TEST(PlaneRelations, ATurnedSurfaceLosesItsRelations) {
  RelationCase c;
  const std::int32_t floor = c.level(0.0);
  for (auto& surface : c.surfaces.surfaces) {
    if (c.truth.plane[surface.inliers.front()] != floor) continue;
    const Eigen::AngleAxisd turn(0.3, Eigen::Vector3d::UnitX());
    surface.plane.normal = turn * surface.plane.normal;
    surface.T_cloud_surface.linear() = turn * surface.T_cloud_surface.linear();
  }
  PlaneRelations lists = c.lists();
  const RelationScore score = score_relations(lists.truth, lists.claims);
  EXPECT_GT(score.clear.at("parallel").missed, 0);
  EXPECT_GT(score.clear.at("orthogonal").missed, 0);
}

TEST(PlaneRelations, AreScoredWithTheAnswer) {
  const RelationCase c;
  Labelling labelling;
  labelling.entity_of_surface.assign(c.surfaces.surfaces.size(), -1);
  ScanAnswer answer;
  answer.points = perfect_prediction(c.truth);
  answer.points.plane = c.surfaces.plane_of_point;
  answer.surfaces = &c.surfaces;
  answer.labelling = &labelling;
  const Score score = score_scan(c.made.scan, &c.made.scene, answer, c.protocol);
  EXPECT_DOUBLE_EQ(metric(score, c.protocol, "relations.recall"), 1.0);
  EXPECT_DOUBLE_EQ(metric(score, c.protocol, "relations.precision.parallel"), 1.0);
  answer.labelling = nullptr;  // without a reasoner nothing was claimed
  EXPECT_TRUE(score_scan(c.made.scan, &c.made.scene, answer, c.protocol).relations.clear.empty());
}

TEST(PlaneRelations, EachInverseIsScoredOnce) {
  const auto& list = scored_relations();
  for (const auto relation : list) {
    if (inverse(relation) == relation) continue;
    EXPECT_EQ(std::count(list.begin(), list.end(), inverse(relation)), 0)
        << relation_name(relation);
  }
}

}  // namespace
}  // namespace scanchor
