// scanchor run from several places of a room.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::run_scanchor;
using testing_support::scratch;

TEST(RunCommand, ScansARoomFromAsManyPlacesAsAsked) {
  const auto ran = run_scanchor(
      "run --scenes 1 --scans 2 --no-pictures --json --out places"
      " --set lidar.beams_per_turn=360 --set lidar.lines_per_second=10");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const auto rooms = nlohmann::json::parse(ran.out)["rooms"];
  ASSERT_EQ(rooms.size(), 2U);
  EXPECT_EQ(rooms[0]["name"], "00");
  EXPECT_EQ(rooms[1]["name"], "00.2");
  const std::string folder = scratch() + "places/";
  EXPECT_EQ(read_file(folder + "00/scene.json"), read_file(folder + "00.2/scene.json"));
  EXPECT_NE(read_file(folder + "00/scan.pcd"), read_file(folder + "00.2/scan.pcd"));
  const auto one = run_scanchor(
      "run --scenes 1 --no-pictures --json --out place"
      " --set lidar.beams_per_turn=360 --set lidar.lines_per_second=10");
  ASSERT_EQ(one.code, 0) << one.error;
  EXPECT_EQ(read_file(scratch() + "place/00/scan.pcd"), read_file(folder + "00/scan.pcd"));
  EXPECT_FALSE(std::filesystem::exists(scratch() + "place/00.2"));
}

}  // namespace
}  // namespace scanchor
