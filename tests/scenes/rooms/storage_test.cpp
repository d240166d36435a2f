#include <gtest/gtest.h>

#include <map>

#include "scenes/generator.hpp"
#include "scenes/relations.hpp"

namespace scanchor {
namespace {

std::map<std::string, int> kinds(const std::string& family, std::uint64_t seeds) {
  std::map<std::string, int> count;
  RoomOptions options;
  options.family = family;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    for (const auto& instance : generate_room(options, seed).instances) ++count[instance.kind];
  }
  return count;
}

TEST(StorageRooms, LaboratoriesHaveShelvesAndBenches) {
  auto count = kinds("laboratory", 10);
  EXPECT_GE(count["shelf"], 15);
  EXPECT_GE(count["workbench"], 10);
  EXPECT_GE(count["box"], 60);
}

TEST(StorageRooms, AislesRunBetweenRacksWithPallets) {
  auto count = kinds("storage aisle", 10);
  EXPECT_GE(count["pallet rack"], 40);
  EXPECT_GE(count["pallet"], 30);
  EXPECT_GE(count["box"], 100);
}

}  // namespace
}  // namespace scanchor
