#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "eval/sweep.hpp"
#include "eval/truth.hpp"

namespace scanchor {
namespace {

Suite one_room_suite() {
  Suite suite;
  suite.scenes = 1;
  suite.lidar.lines = 20;
  suite.lidar.beams_per_line = 60;
  return suite;
}

TEST(SweepJson, FinishedPointsAreFoundAgain) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("scanchor-sweep-" + std::to_string(getpid()));
  int asked = 0;
  Method method;
  method.name = "oracle";
  method.answer = [&asked](const Scan& scan, const std::string&) {
    ++asked;
    MethodAnswer answer;
    answer.points = perfect_prediction(truth_of(scan, nullptr, Protocol{}));
    return answer;
  };
  SweepOptions options;
  options.run.split = "";
  options.folder = folder;
  options.replicates = 10;
  const std::vector<Axis> axes = {parse_axis("lidar.range_sigma=0,0.02")};
  const auto first = sweep(one_room_suite(), axes, method, options);
  EXPECT_EQ(asked, 2);
  const auto second = sweep(one_room_suite(), axes, method, options);
  EXPECT_EQ(asked, 2);
  EXPECT_EQ(sweep_to_json(first).dump(), sweep_to_json(second).dump());
  const std::string csv = sweep_to_csv(second);
  EXPECT_THAT(csv, testing::StartsWith(
                       "lidar.range_sigma,scenes,objects.f1,objects.f1.low,objects.f1.high"));
  EXPECT_THAT(csv, testing::HasSubstr("\n0.02,1,"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace scanchor
