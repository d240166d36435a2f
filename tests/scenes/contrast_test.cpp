#include "scenes/contrast.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/error.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

bool same_thing(const Instance& a, const Instance& b) {
  if (a.id != b.id || a.class_id != b.class_id ||
      a.T_world_instance.matrix() != b.T_world_instance.matrix() ||
      a.parts.size() != b.parts.size())
    return false;
  for (std::size_t p = 0; p < a.parts.size(); ++p) {
    if (a.parts[p].vertices != b.parts[p].vertices) return false;
  }
  return true;
}

/// What may change with a relation because one follows from the other.
std::set<SpatialRelation> follows(SpatialRelation relation) {
  switch (relation) {
    case SpatialRelation::left_of:
    case SpatialRelation::right_of:
      return {SpatialRelation::left_of, SpatialRelation::right_of};
    case SpatialRelation::in_front_of:
    case SpatialRelation::behind:
      return {SpatialRelation::in_front_of, SpatialRelation::behind};
    case SpatialRelation::inside:
      return {SpatialRelation::inside,
              SpatialRelation::on};  // one cannot lie in a crate without lying on its bottom
    // A board that is no longer parallel has other plane distances.
    case SpatialRelation::coplanar:
      return {SpatialRelation::coplanar};
    default:
      return {relation};
  }
}

class Contrast : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Contrast, PairsDifferInOneThingAndOneRelation) {
  const auto relation = static_cast<SpatialRelation>(GetParam());
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const ContrastPair pair = contrastive_pair(relation, seed);
    ASSERT_EQ(pair.with.instances.size(), pair.without.instances.size());
    for (std::size_t i = 0; i < pair.with.instances.size(); ++i) {
      EXPECT_EQ(same_thing(pair.with.instances[i], pair.without.instances[i]), i != pair.a) << i;
    }
    const auto value = [&](const Scene& scene, SpatialRelation r) {
      return relate(instance_body(scene, pair.a), instance_body(scene, pair.b), r, pair.viewpoint);
    };
    EXPECT_GE(value(pair.with, relation).margin, 0.15);
    EXPECT_LE(value(pair.without, relation).margin, -0.15);
    const auto allowed = follows(relation);
    for (std::size_t k = 0; k < relation_count; ++k) {
      const auto other = static_cast<SpatialRelation>(k);
      if (allowed.count(other) != 0 || needs_viewpoint(other)) continue;
      EXPECT_EQ(value(pair.with, other).holds(), value(pair.without, other).holds())
          << relation_name(relation) << " also changed " << relation_name(other) << " (seed "
          << seed << ")";
    }
    testing::expect_no_close_faces(pair.with, pair.with.name);
    testing::expect_no_close_faces(pair.without, pair.without.name);
  }
}

INSTANTIATE_TEST_SUITE_P(Relations, Contrast, ::testing::Range(std::size_t{0}, relation_count),
                         [](const auto& relation) {
                           std::string name(
                               relation_name(static_cast<SpatialRelation>(relation.param)));
                           for (char& c : name) c = c == ' ' ? '_' : c;
                           return name;
                         });

TEST(ContrastPairs, AnImpossibleMarginIsAnError) {
  EXPECT_THROW(contrastive_pair(SpatialRelation::parallel, 1, 1.5), Error);
}

}  // namespace
}  // namespace scanchor
