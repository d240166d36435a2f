#include <gtest/gtest.h>

#include "scenes/generator.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::kinds_in;

TEST(Floors, CorridorsHaveDoorsOnBothSides) {
  auto count = kinds_in("corridor", 10);
  EXPECT_GE(count["door"], 50);
}

TEST(Floors, RoomsJoinTheCorridorThroughTheirDoors) {
  RoomOptions options;
  options.family = "floor";
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scene scene = generate_room(options, seed);
    int floors = 0;
    int doors = 0;
    for (const auto& instance : scene.instances) {
      floors += instance.kind == "floor" ? 1 : 0;
      doors += instance.kind == "door" ? 1 : 0;
    }
    EXPECT_GE(floors, 4) << seed;
    EXPECT_EQ(doors, floors) << "one a room and the corridor's own";
    EXPECT_GE(scene.sensor_poses.size(), static_cast<std::size_t>(floors) - 1);
  }
}

}  // namespace
}  // namespace scanchor
