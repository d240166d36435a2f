// What `--set` does in the verbs that take a suite.

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/json.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::run_scanchor;
using testing_support::scratch;

TEST(Set, APresetIsLoadedAndThenChanged) {
  const auto ran = run_scanchor(
      "generate quick --scenes 1 --out preset --set lidar.preset=lms-1xx --set lidar.lines=12 "
      "--set lidar.range_sigma=0.03");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Json lidar =
      Json::parse(read_file(scratch() + "preset/dataset.json")).at("suite").at("lidar");
  EXPECT_EQ(lidar.at("preset"), "lms-1xx");
  EXPECT_EQ(lidar.at("lines"), 12);
  EXPECT_EQ(lidar.at("range_sigma"), 0.03);
  EXPECT_GT(lidar.at("divergence").get<double>(), 0.0) << "what the preset says and nobody changed";
}

TEST(Set, OptionsOfTheSuiteAndOfTheStagesAreBothKnown) {
  const auto ran = run_scanchor(
      "run quick --scenes 1 --no-pictures --out both --set room.family=kitchen --set "
      "lidar.lines=40 --set perceive.noise_sigma=0.02");
  ASSERT_EQ(ran.code, 0) << ran.error;
  EXPECT_EQ(Json::parse(read_file(scratch() + "both/summary.json")).at("rooms").at(0).at("family"),
            "kitchen");
  EXPECT_NE(read_file(scratch() + "both/config.resolved.json").find("0.02"), std::string::npos);
  EXPECT_EQ(run_scanchor("run quick --out none --set lidar.preset=lms").code, 2);
  EXPECT_EQ(run_scanchor("run quick --out none --set lidar.liens=4").code, 2);
}

}  // namespace
}  // namespace scanchor
