#include <gtest/gtest.h>

#include <set>

#include "scenes/generator.hpp"
#include "scenes/pose.hpp"
#include "scenes/relations.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

TEST(RelationLists, TheHighestCarrierWins) {
  // A box on a small table top 10 cm above a large one.
  const Scene scene = testing::boards({{{0.2, 0.2, 0.2}, pose_at({0, 0, 0.9})},
                                       {{0.4, 0.4, 0.02}, pose_at({0, 0, 0.79})},
                                       {{1.6, 0.8, 0.02}, pose_at({0, 0, 0.70})}});
  EXPECT_TRUE(
      relate(instance_body(scene, 0), instance_body(scene, 2), SpatialRelation::on, {0, 0, 0})
          .holds())
      << "as a pair";
  RelationQuery query;
  query.relations = {SpatialRelation::on};
  std::set<std::pair<std::int32_t, std::int32_t>> on;
  for (const auto& fact : instance_relations(scene, query)) on.insert({fact.a, fact.b});
  EXPECT_EQ(on, (std::set<std::pair<std::int32_t, std::int32_t>>{{0, 1}, {1, 2}}));
}

TEST(RelationLists, InOfficesMonitorsAreOnDesks) {
  int monitors = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = generate_room({}, seed);
    RelationQuery query;
    query.relations = {SpatialRelation::on};
    const auto facts = instance_relations(scene, query);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      if (scene.instances[i].kind != "monitor") continue;
      ++monitors;
      bool on_desk = false;
      for (const auto& f : facts)
        on_desk = on_desk || (f.a == static_cast<std::int32_t>(i) &&
                              scene.instances[static_cast<std::size_t>(f.b)].kind == "desk");
      EXPECT_TRUE(on_desk) << scene.name;
    }
  }
  EXPECT_GE(monitors, 12);
}

TEST(RelationLists, CoplanarFacesOfOneThingAreOnePlane) {
  const Scene scene = testing::alone({"pallet", "euro", 1, {}, 0.0});
  const auto groups = coplanar_groups(scene);
  std::set<std::int32_t> tops;
  const auto faces = all_faces(scene);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Part& part = scene.instances[0].parts[static_cast<std::size_t>(faces[f].part)];
    if (part.name.rfind("deck", 0) == 0 &&
        part.faces[static_cast<std::size_t>(faces[f].face)].name == "top")
      tops.insert(groups[f]);
  }
  EXPECT_EQ(tops.size(), 1U);
}

}  // namespace
}  // namespace scanchor
