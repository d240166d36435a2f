#include "eval/external.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "core/error.hpp"
#include "eval/truth.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

std::string command_failure(const std::string& command, double limit = 20.0) {
  ExternalOptions options;
  options.command = command;
  options.time_limit = limit;
  const SmallScan made = small_scan();
  try {
    external_method(options).answer(made.scan, "00/0");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(External, TakesTheAnswerOfAProgram) {
  ExternalOptions options;
  // Four zero bytes a point: everything unlabelled.
  const SmallScan made = small_scan();
  options.command = "test -s {scan} && head -c " + std::to_string(4 * made.scan.cloud.size()) +
                    " /dev/zero > {out}";
  const auto answer = external_method(options).answer(made.scan, "00/0");
  EXPECT_EQ(answer.points.class_id, std::vector<std::int32_t>(made.scan.cloud.size(), 0));
}

TEST(External, FailuresHaveACause) {
  EXPECT_THAT(command_failure("echo first >&2; echo 'no licence' >&2; exit 3 # {scan} {out}"),
              testing::StrEq("exit code 3: no licence"));
  EXPECT_THAT(command_failure("kill -SEGV $$ # {scan} {out}"),
              testing::HasSubstr("killed by signal 11"));
  EXPECT_THAT(command_failure("true {scan} {out}"), testing::HasSubstr("left no file"));
  EXPECT_THAT(command_failure("echo garbage > {out} # {scan}"),
              testing::HasSubstr("rows, the scan has"));
  EXPECT_THAT(command_failure("no-such-program {scan} {out}"), testing::HasSubstr("exit code 127"));
}

TEST(External, HangingProgramsAreKilledWithWhatTheyStarted) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(command_failure("sleep 500 & sleep 500 # {scan} {out}", 0.2),
              testing::HasSubstr("killed after 0.2 s"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));
}

TEST(External, CommandMustNameBothFiles) {
  ExternalOptions options;
  options.command = "pipeline {scan}";
  EXPECT_THROW(external_method(options), Error);
}

TEST(External, TheProgramSeesNoTruth) {
  // The file it is given has positions and no field of the truth.
  EXPECT_THAT(
      command_failure("if head -c 2000 {scan} | grep -qa -e label -e instance; then echo leak "
                      ">&2; exit 9; fi; exit 4 # {out}"),
      testing::StrEq("exit code 4"));
}

}  // namespace
}  // namespace scanchor
