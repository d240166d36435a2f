#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "sensors/suite.hpp"

namespace scanchor {
namespace {

std::string error(const std::string& yaml) {
  try {
    (void)parse_suite(yaml, "s.yaml");
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::bad_data);
    return e.what();
  }
  return "nothing was thrown";
}

TEST(SuiteYaml, ReadsEveryKey) {
  const Suite suite = parse_suite(R"(
name: mine
text: for a test
seed: 18446744073709551615
scenes: 40
scans: 3
split: {train: 8, test: 2}
families: {office: 2}
vary:
  room.clutter: [0.1, 0.9]
room: {clutter: 0.25}
settle: {maximum_time: 4}
lidar.range_sigma: 0.02
lidar: {preset: utm-30lx, lines: 50}
)",
                                  "s.yaml");
  EXPECT_EQ(suite.name, "mine");
  EXPECT_EQ(suite.seed, 18446744073709551615ULL);
  EXPECT_EQ(suite.scenes, 40);
  EXPECT_EQ(suite.scans, 3);
  EXPECT_EQ(suite.split.train, 8.0);
  EXPECT_EQ(suite.split.valid, 0.0);
  ASSERT_EQ(suite.vary.size(), 1U);
  EXPECT_EQ(suite.room.clutter, 0.25);
  EXPECT_EQ(suite.settle.maximum_time, 4.0);
  EXPECT_EQ(suite.lidar.preset, "utm-30lx");
  EXPECT_EQ(suite.lidar.range_sigma, 0.02) << "an option changes its preset, wherever it stands";
  EXPECT_EQ(suite.lidar.lines, 50);
  EXPECT_EQ(suite.lidar.beams_per_line, lidar_preset("utm-30lx").beams_per_line);
}

TEST(SuiteYaml, ErrorsNameTheLineAndWhatWasMeant) {
  EXPECT_EQ(error("name: a\nscens: 3\n"),
            "s.yaml: line 2: unknown key 'scens'; did you mean 'scenes'?");
  EXPECT_EQ(
      error("lidar:\n  range_sgima: 0.1\n"),
      "s.yaml: line 2: unknown option 'lidar.range_sgima'; did you mean 'lidar.range_sigma'?");
  EXPECT_EQ(error("room:\n  clutter: 2\n"),
            "s.yaml: line 2: option room.clutter: 2 is outside 0 .. 1 1");
  EXPECT_EQ(error("families:\n  ofice: 1\n"),
            "s.yaml: line 2: unknown family 'ofice'; did you mean 'office'?");
  EXPECT_EQ(error("scenes: 0\n").substr(0, 40), "s.yaml: line 1: scenes must be a number ");
  EXPECT_EQ(error("scenes: 2.5\n"), "s.yaml: line 1: scenes must be a whole number");
  EXPECT_EQ(error("seed: -4\n"), "s.yaml: line 1: seed must be a whole number from 0 to 2^64 - 1");
  EXPECT_EQ(error("split: {trian: 1}\n"),
            "s.yaml: line 1: unknown part 'trian'; did you mean 'train'?");
  EXPECT_EQ(error("split: {train: 0}\n"), "s.yaml: line 1: split has no share above 0");
  EXPECT_EQ(error("families: {office: 0}\n"), "s.yaml: line 1: no family has a weight above 0");
  EXPECT_EQ(error("name: a\nname: b\n"), "s.yaml: line 2: the key 'name' comes twice");
  EXPECT_EQ(error("vary: {room.clutter: [0.5]}\n"),
            "s.yaml: line 1: room.clutter must be [minimum, maximum]");
  EXPECT_EQ(error("vary: {room.clutter: [0.5, 3]}\n"),
            "s.yaml: line 1: option room.clutter: 3 is outside 0 .. 1 1");
  EXPECT_EQ(error("vary: {lidar.glass: [0, 1]}\n"),
            "s.yaml: line 1: lidar.glass is no number and cannot be varied");
  EXPECT_NE(error("vary: {lidar.line: [1, 2]}\n").find("did you mean 'lidar.lines'?"),
            std::string::npos);
  EXPECT_NE(error("room.family: office\n").find("comes from the suite's families"),
            std::string::npos);
  EXPECT_NE(error("lidar: {preset: utm-30l}\n").find("line 1"), std::string::npos);
  EXPECT_NE(error("lidar: {minimum_range: 5, maximum_range: 2}\n").find("minimum_range"),
            std::string::npos);
  EXPECT_NE(error("a: [1\n").find("is no valid YAML"), std::string::npos);
  EXPECT_EQ(error("- 1\n- 2\n"), "s.yaml: line 1: a suite is a map of keys to values");
}

TEST(SuiteYaml, TheResolvedSuiteHasEveryOption) {
  Suite suite;
  suite.vary = {{"room.clutter", 0.0, 1.0}};
  const auto json = suite_to_json(suite);
  EXPECT_EQ(json.at("families").dump(), R"({"office":1.0})");
  EXPECT_EQ(json.at("vary").at("room.clutter").dump(), "[0.0,1.0]");
  EXPECT_EQ(json.at("lidar").at("lines"), suite.lidar.lines);
  EXPECT_FALSE(json.at("room").contains("family"));
  OptionList list;
  suite.describe(list);
  std::size_t options = 0;
  for (const char* group : {"room", "settle", "lidar"}) options += json.at(group).size();
  EXPECT_EQ(options + 1, list.options().size());
}

TEST(SuiteYaml, EverySuiteThatWeShipIsRead) {
  int found = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SCANCHOR_SOURCE_DIR) + "/suites")) {
    const Suite suite = read_suite(entry.path());
    EXPECT_EQ(suite.name, entry.path().stem().string());
    EXPECT_FALSE(suite.text.empty()) << entry.path();
    EXPECT_FALSE(scene_tasks(suite).empty());
    ++found;
  }
  EXPECT_GE(found, 5);
}

}  // namespace
}  // namespace scanchor
