#include <gtest/gtest.h>

#include "scenes/generator.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::kinds_in;

TEST(HomeRooms, KitchensHaveARunOfUnits) {
  auto count = kinds_in("kitchen", 10);
  EXPECT_EQ(count["refrigerator"], 10);
  EXPECT_EQ(count["sink counter"], 10);
  EXPECT_EQ(count["oven"], 10);
  EXPECT_GE(count["microwave"], 5);
  EXPECT_GE(count["table"], 6);
}

TEST(HomeRooms, SofasLookAtTheTelevision) {
  auto count = kinds_in("living room", 10);
  EXPECT_GE(count["sofa"], 10);
  EXPECT_GE(count["television"], 7);
  EXPECT_GE(count["coffee table"], 7);
  RoomOptions options;
  options.family = "living room";
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = generate_room(options, seed);
    const Instance* sofa = nullptr;
    const Instance* screen = nullptr;
    for (const auto& instance : scene.instances) {
      if (instance.kind == "sofa" && sofa == nullptr) sofa = &instance;
      if (instance.kind == "television") screen = &instance;
    }
    if (sofa == nullptr || screen == nullptr) continue;
    EXPECT_GT(
        (-sofa->T_world_instance.linear().col(1))
            .dot((screen->T_world_instance.translation() - sofa->T_world_instance.translation())
                     .normalized()),
        0.3);
  }
}

TEST(HomeRooms, BedroomsHaveABedAndAWardrobe) {
  auto count = kinds_in("bedroom", 10);
  EXPECT_EQ(count["bed"], 10);
  EXPECT_EQ(count["wardrobe"], 10);
}

}  // namespace
}  // namespace scanchor
