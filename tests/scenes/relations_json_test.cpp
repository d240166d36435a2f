#include <gtest/gtest.h>

#include "core/json.hpp"
#include "scenes/generator.hpp"
#include "scenes/relations.hpp"

namespace scanchor {
namespace {

TEST(RelationsJson, HasEveryFaceAndReadableRelations) {
  const Scene scene = generate_room({}, 2);
  const Json truth = truth_to_json(scene);
  const auto faces = all_faces(scene);
  ASSERT_EQ(truth["faces"].size(), faces.size());
  for (std::size_t f = 0; f < faces.size(); f += 17) {
    const auto& row = truth["faces"][f];
    EXPECT_EQ(row["face"], f);
    if (!row["planar"].get<bool>()) continue;
    const WorldFace world = world_face(scene, faces[f]);
    EXPECT_EQ(row["offset"].get<double>(), world.normal.dot(world.center));
    EXPECT_LE(row["rectangularness"].get<double>(), 1.0 + 1e-9);
    EXPECT_GE(row["plane"].get<int>(), 0);
  }
  ASSERT_GT(truth["instance_relations"].size(), 20U);
  for (const auto& fact : truth["instance_relations"]) {
    EXPECT_TRUE(find_relation(fact["relation"].get<std::string>()).has_value());
    EXPECT_GE(fact["margin"].get<double>(), 0.0);
    EXPECT_NE(fact["a"], fact["b"]);
  }
}

TEST(RelationsJson, NearMissesAreListedOnRequest) {
  const Scene scene = generate_room({}, 2);
  RelationQuery query;
  query.relations = {SpatialRelation::near};
  const std::size_t clear = truth_to_json(scene, query)["instance_relations"].size();
  query.least_margin = -0.5;
  EXPECT_GT(truth_to_json(scene, query)["instance_relations"].size(), clear);
}

}  // namespace
}  // namespace scanchor
