#include <gtest/gtest.h>

#include "scenes/generator.hpp"
#include "scenes/relations.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::kinds_in;

TEST(OfficeRooms, OpenPlansHaveManyWorkplaces) {
  auto count = kinds_in("open-plan office", 10);
  EXPECT_GE(count["desk"], 30);
  EXPECT_GE(count["monitor"], count["desk"]);
  EXPECT_GE(count["chair"], count["desk"] / 2);
  EXPECT_GE(count["partition"], 3);
}

TEST(OfficeRooms, MeetingsHaveOneTableAndChairsAround) {
  auto count = kinds_in("meeting room", 10);
  EXPECT_EQ(count["meeting table"], 10);
  EXPECT_GE(count["chair"], 40);
  EXPECT_GE(count["television"] + count["whiteboard"], 8);
}

TEST(OfficeRooms, ShelvesCarryWhatLiesOnThem) {
  RoomOptions options;
  options.clutter = 1.0;
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = generate_room(options, seed);
    RelationQuery query;
    query.relations = {SpatialRelation::inside};
    for (const auto& fact : instance_relations(scene, query)) {
      const auto& b = scene.instances[static_cast<std::size_t>(fact.b)];
      const auto& a = scene.instances[static_cast<std::size_t>(fact.a)];
      inside += b.kind == "shelf" && a.loose ? 1 : 0;
    }
  }
  EXPECT_GE(inside, 12);
}

}  // namespace
}  // namespace scanchor
