#include "eval/run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/error.hpp"
#include "eval/truth.hpp"

namespace scanchor {
namespace {

// Few beams: what is tested is the way of the data, not the labels.
Suite tiny_suite() {
  Suite suite;
  suite.name = "tiny";
  suite.scenes = 3;
  suite.split = {0.0, 0.0, 1.0};
  suite.lidar.lines = 40;
  suite.lidar.beams_per_line = 90;
  return suite;
}

RunOptions all_parts() {
  RunOptions options;
  options.split = "";
  return options;
}

// Says what is so; tests of the way may look at the truth.
Method oracle() {
  Method method;
  method.name = "oracle";
  method.answer = [](const Scan& scan, const std::string&) {
    MethodAnswer answer;
    answer.points = perfect_prediction(truth_of(scan, nullptr, Protocol{}));
    return answer;
  };
  return method;
}

TEST(Run, PoolsItsScenesAndDoesNotDependOnThreads) {
  RunOptions options = all_parts();
  options.threads = 1;
  const RunResult one = run_suite(tiny_suite(), oracle(), options);
  options.threads = 2;
  const RunResult two = run_suite(tiny_suite(), oracle(), options);
  ASSERT_EQ(one.rows.size(), 3U);
  EXPECT_EQ(run_to_json(one, false).dump(), run_to_json(two, false).dump());
  Score sum;
  for (const auto& row : one.rows) sum.add(row.score);
  EXPECT_EQ(sum, one.pooled);
  EXPECT_EQ(metric(one.pooled, one.protocol, "objects.recall"), 1.0);
}

TEST(Run, AScenesHashIsThatOfItsScans) {
  const RunResult run = run_suite(tiny_suite(), oracle(), all_parts());
  EXPECT_EQ(run.rows[0].scan_hash.size(), 16U);
  EXPECT_NE(run.rows[0].scan_hash, run.rows[1].scan_hash);
  Suite noisier = tiny_suite();
  noisier.lidar.range_sigma *= 1.01;
  EXPECT_NE(run_suite(noisier, oracle(), all_parts()).rows[0].scan_hash, run.rows[0].scan_hash);
  const RunResult back = run_from_json(run_to_json(run), "run.json");
  EXPECT_EQ(back.rows[2].scan_hash, run.rows[2].scan_hash);
}

TEST(Run, ShardsLaidSideBySideAreTheWhole) {
  const RunResult whole = run_suite(tiny_suite(), oracle(), all_parts());
  std::vector<RunResult> parts;
  for (int index : {1, 0}) {
    RunOptions options = all_parts();
    options.shard = {index, 2};
    parts.push_back(run_suite(tiny_suite(), oracle(), options));
  }
  EXPECT_EQ(run_to_json(merge_runs(parts), false).dump(), run_to_json(whole, false).dump());
  parts.push_back(parts.front());
  EXPECT_THROW(merge_runs(parts), Error);
}

TEST(Run, AMethodThatFailsIsAllMissedAndListed) {
  Method method = oracle();
  const auto good = method.answer;
  method.answer = [good](const Scan& scan, const std::string& name) {
    if (name.rfind("01/", 0) == 0) throw std::runtime_error("out of luck");
    return good(scan, name);
  };
  const RunResult run = run_suite(tiny_suite(), method, all_parts());
  EXPECT_THAT(run.pooled.failed, testing::ElementsAre("01/0: out of luck"));
  EXPECT_EQ(run.rows[1].score.objects.total().found, 0);
  EXPECT_GT(run.rows[1].score.objects.total().truths, 0);
}

TEST(Run, AnEmptyPartIsNothingMeasured) {
  RunOptions options;
  options.split = "valid";
  try {
    run_suite(tiny_suite(), oracle(), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::nothing_measured);
  }
}

TEST(Run, LongerSuitesHaveTheSameStampAndOtherOptionsAnother) {
  Suite suite = tiny_suite();
  const std::string stamp = data_stamp(suite, "test");
  suite.scenes = 30;
  EXPECT_EQ(data_stamp(suite, "test"), stamp);
  suite.lidar.range_sigma += 0.001;
  EXPECT_NE(data_stamp(suite, "test"), stamp);
}

}  // namespace
}  // namespace scanchor
