// The suite that every build measures: its gate says what it should, through the command.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "core/file.hpp"
#include "core/json.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::run_scanchor;
using testing_support::scratch;

/// The baseline of all test rooms, measured once.
const std::string& baseline() {
  static const std::string name = [] {
    const auto ran = run_scanchor("baseline quick --baseline quick.json --quiet");
    EXPECT_EQ(ran.code, 0) << ran.error;
    return std::string("quick.json");
  }();
  return name;
}

TEST(QuickSuite, HasEnoughTestRoomsForAVerdictAndIsNotWorseThanItself) {
  const auto ran = run_scanchor("check quick --json --baseline " + baseline());
  ASSERT_EQ(ran.code, 0) << ran.out << ran.error;
  const Json json = Json::parse(ran.out);
  EXPECT_EQ(json.at("verdict"), "not worse");
  EXPECT_EQ(json.at("scenes"), 32);
}

TEST(QuickSuite, TwoLabelsSwappedFailTheGate) {
  std::string text = read_file(std::string(SCANCHOR_SOURCE_DIR) + "/ontologies/office.sdl");
  text = std::regex_replace(text, std::regex("\\bfloor\\b"), "FLOOR");
  text = std::regex_replace(text, std::regex("\\bceiling\\b"), "floor");
  text = std::regex_replace(text, std::regex("\\bFLOOR\\b"), "ceiling");
  write_file(scratch() + "swapped.sdl", text);
  const auto ran = run_scanchor(
      "check quick --ontology swapped.sdl --junit gate.xml --markdown gate.md "
      "--bencher gate.json --baseline " +
      baseline());
  EXPECT_EQ(ran.code, 1) << ran.out << ran.error;
  EXPECT_NE(ran.out.find("regressed"), std::string::npos) << ran.out;
  EXPECT_NE(read_file(scratch() + "gate.xml").find("<failure"), std::string::npos);
  EXPECT_NE(read_file(scratch() + "gate.md").find("| objects.f1 |"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(scratch() + "gate.json"));
}

TEST(QuickSuite, OtherScansThanTheBaselinesAreNotCompared) {
  Json json = read_json(scratch() + baseline());
  json["run"]["scenes"][3]["scan_hash"] = "0000000000000000";
  write_json(scratch() + "other.json", json);
  const auto ran = run_scanchor("check quick --baseline other.json");
  EXPECT_EQ(ran.code, 3) << ran.out;
  EXPECT_NE(ran.error.find("has other scans than in the baseline"), std::string::npos) << ran.error;
}

TEST(QuickSuite, ABaselineChangesOnlyForAReason) {
  std::filesystem::copy_file(scratch() + baseline(), scratch() + "moved.json",
                             std::filesystem::copy_options::overwrite_existing);
  const std::string update = "baseline quick --method paper --baseline moved.json";
  EXPECT_EQ(run_scanchor(update).code, 2);
  const auto ran = run_scanchor(update + " --reason 'the paper is our method now'");
  EXPECT_EQ(ran.code, 0) << ran.error;
  EXPECT_NE(ran.out.find("objects.f1: "), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace scanchor
