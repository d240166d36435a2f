#include <gtest/gtest.h>

#include "scenes/generator.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::kinds_in;

TEST(StorageRooms, LaboratoriesHaveShelvesAndBenches) {
  auto count = kinds_in("laboratory", 10);
  EXPECT_GE(count["shelf"], 15);
  EXPECT_GE(count["workbench"], 10);
  EXPECT_GE(count["box"], 60);
}

TEST(StorageRooms, AislesRunBetweenRacksWithPallets) {
  auto count = kinds_in("storage aisle", 10);
  EXPECT_GE(count["pallet rack"], 40);
  EXPECT_GE(count["pallet"], 30);
  EXPECT_GE(count["box"], 100);
}

}  // namespace
}  // namespace scanchor
