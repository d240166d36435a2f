// Sweeps, rankings and shrinking as a person runs them.

#include <gtest/gtest.h>

#include <filesystem>

#include "core/file.hpp"
#include "core/json.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;
using testing_support::lines_of;
using testing_support::run_scanchor;
using testing_support::scratch;

const std::string small =
    " quick --split train --scenes 2 --set lidar.lines=40 --set lidar.beams_per_line=100 ";
const std::string noise = "--vary lidar.range_sigma=0,0.03 ";

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(scratch() + folder), fs::directory_iterator()));
}

TEST(SweepCommand, ShardsFillOneFolderAndTheLastRunFinishes) {
  ASSERT_EQ(run_scanchor("sweep" + small + noise + "--out parts --shard 1/2 -q").code, 0);
  EXPECT_FALSE(fs::exists(scratch() + "parts/sweep.json"));
  EXPECT_EQ(files_in("parts/points"), 1U);
  ASSERT_EQ(run_scanchor("sweep" + small + noise + "--out parts --shard 2/2 -q").code, 0);
  EXPECT_EQ(files_in("parts/points"), 2U);
  ASSERT_EQ(run_scanchor("sweep" + small + noise + "--out parts -q").code, 0);
  EXPECT_EQ(files_in("parts/points"), 2U);  // found again, none measured anew
  ASSERT_EQ(run_scanchor("sweep" + small + noise + "--out whole -q").code, 0);
  EXPECT_EQ(read_file(scratch() + "parts/sweep.json"), read_file(scratch() + "whole/sweep.json"));
  EXPECT_TRUE(fs::exists(scratch() + "whole/scores.svg"));
}

TEST(SweepCommand, OtherOptionsAreOtherPoints) {
  ASSERT_EQ(run_scanchor("sweep" + small + noise + "--out kept -q").code, 0);
  ASSERT_EQ(
      run_scanchor("sweep" + small + noise + "--out kept -q --set perceive.noise_sigma=0.03").code,
      0);
  EXPECT_EQ(files_in("kept/points"), 4U);
}

TEST(SweepCommand, MethodsAndBreakingPointAreInTheFile) {
  const auto ran = run_scanchor("sweep" + small + noise +
                                "--against paper --breaking objects.f1 --limit 0.2 --out both");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Json json = read_json(scratch() + "both/sweep.json");
  ASSERT_EQ(json.at("methods").size(), 2U);
  EXPECT_EQ(json.at("methods")[1].at("points").size(), 2U);
  ASSERT_EQ(json.at("breaking").size(), 1U);
  EXPECT_EQ(json.at("breaking")[0].at("metric"), "objects.f1");
  EXPECT_TRUE(fs::exists(scratch() + "both/methods-objects.f1.svg"));
  EXPECT_TRUE(fs::exists(scratch() + "both/sweep-paper.csv"));
}

TEST(SweepCommand, ARankingSetsOneEffectAtATime) {
  const auto ran = run_scanchor("sweep" + small + noise +
                                "--vary lidar.loss=0,0.3 --rank objects.recall --json --out rank");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Json json = Json::parse(ran.out);
  ASSERT_EQ(json.at("effects").size(), 2U);
  const auto loss = [&](std::size_t i) {
    return json.at("effects")[i].at("after").get<double>() -
           json.at("effects")[i].at("before").get<double>();
  };
  EXPECT_LE(loss(0), loss(1));  // most costly first
}

TEST(SweepCommand, MistakesAreSaidBeforeAnythingIsMeasured) {
  for (const std::string arguments :
       {"--vary lidar.range_sgima=0..1", "--vary lidar.range_sigma=1..0",
        "--vary lidar.range_sigma=0..1 --breaking objects.f2",
        "--vary lidar.range_sigma=0..1 --rank nothing",
        "--vary lidar.range_sigma=0..1 --against nobody",
        "--vary lidar.range_sigma=0..1 --shard 3/2"}) {
    const auto ran = run_scanchor("sweep" + small + arguments + " --out mistakes");
    EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran.error;
    EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
    EXPECT_FALSE(fs::exists(scratch() + "mistakes/sweep.json"));
  }
}

TEST(ShrinkCommand, AMissedThingStaysMissedInASmallerScene) {
  const auto ran = run_scanchor(
      "shrink quick --scene 1 --set lidar.lines=60 --set lidar.beams_per_line=150 --json --out "
      "case");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Json json = Json::parse(ran.out);
  EXPECT_LT(json.at("instances").get<int>(), json.at("instances_before").get<int>());
  EXPECT_TRUE(fs::exists(scratch() + "case/scene.json"));
  EXPECT_EQ(read_json(scratch() + "case/case.json"), json);
  const auto unknown = run_scanchor("shrink quick --scene 1 --thing 'nothing 7'");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.error.find("missed are: "), std::string::npos) << unknown.error;
}

}  // namespace
}  // namespace scanchor
