// A question put to the command as a person would.

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/file.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::run_scanchor;
using testing_support::scratch;

/// A scan of a generated room, and the folder that label made of it.
const std::string& scan() {
  static const std::string file = [] {
    EXPECT_EQ(run_scanchor("run --scenes 1 --seed 60 --no-pictures --out rooms -q").code, 0);
    EXPECT_EQ(run_scanchor("label rooms/00/scan.pcd --no-pictures --out labelled -q").code, 0);
    return std::string("rooms/00/scan.pcd");
  }();
  return file;
}

TEST(Find, AnswersFromAScanAndFromWhatLabelWrote) {
  const auto direct = run_scanchor("find 'wall near a floor' " + scan());
  EXPECT_EQ(direct.code, 0) << direct.out << direct.error;
  EXPECT_EQ(direct.out.rfind("read as: a wall near a floor\nfound ", 0), 0U) << direct.out;
  EXPECT_NE(direct.out.find("near a floor: "), std::string::npos) << "and why";
  EXPECT_EQ(run_scanchor("find 'wall near a floor' labelled").out, direct.out);
  EXPECT_EQ(run_scanchor("find 'wall near a floor' labelled/labels.json").out, direct.out);
}

TEST(Find, SaysWhatItFoundByItsExitCode) {
  scan();
  const auto ask = [](const std::string& question) {
    return run_scanchor("find '" + question + "' labelled");
  };
  EXPECT_EQ(ask("the floor").code, 0);
  EXPECT_EQ(ask("the wall").code, 5) << "there are several";
  EXPECT_EQ(ask("floor that is vertical").code, 4);
  EXPECT_EQ(ask("how many floors above a ceiling").code, 0) << "none is an answer";
  const auto miss = ask("floor that has extension at most 0.5 m");
  EXPECT_EQ(miss.code, 4);
  EXPECT_NE(miss.out.find("it would hold from 0.50 m"), std::string::npos) << miss.out;
  const auto json =
      nlohmann::json::parse(run_scanchor("find 'how many floors' labelled --json").out);
  EXPECT_EQ(json.at("format"), "scanchor answer 1");
  EXPECT_EQ(json.at("count"), 1);
  EXPECT_EQ(json.at("answers").size(), 1U);
}

TEST(Find, RefusesWhatItCannotRead) {
  const auto slip = run_scanchor("find 'screen on a dsek' " + scan());
  EXPECT_EQ(slip.code, 2);
  EXPECT_EQ(slip.error,
            "scanchor: question:1:13: unknown class 'dsek'; did you mean 'desk'?\n"
            "  screen on a dsek\n"
            "              ^\n");
  EXPECT_EQ(run_scanchor("find desk absent").code, 3);
  EXPECT_EQ(run_scanchor("find desk absent/labels.json").code, 3);
  std::filesystem::create_directories(scratch() + "broken");
  write_file(scratch() + "broken/labels.json", "{\"format\": ");
  const auto broken = run_scanchor("find desk broken");
  EXPECT_EQ(broken.code, 3);
  EXPECT_NE(broken.error.find("line 1, column 12"), std::string::npos) << broken.error;
  EXPECT_EQ(run_scanchor("find").code, 2);
  for (const std::string option :
       {"--noise 0.02", "--set reason.alternatives=false", "--up auto"}) {
    const auto twice = run_scanchor("find 'the floor' labelled " + option);
    EXPECT_EQ(twice.code, 2) << option;
    EXPECT_NE(twice.error.find("is labelled already"), std::string::npos) << twice.error;
    EXPECT_EQ(run_scanchor("find 'the floor' " + scan() + " " + option).code, 0) << option;
  }
  const auto blind = run_scanchor("find 'nearest floor' " + scan() + " --sensor none");
  EXPECT_EQ(blind.code, 2);
  EXPECT_NE(blind.error.find("--sensor"), std::string::npos) << blind.error;
}

}  // namespace
}  // namespace scanchor
