#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "eval/run.hpp"
#include "eval/truth.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

RunResult small_run() {
  RunResult run;
  run.suite = "small";
  run.data = "small/test (1)";
  run.method = "oracle";
  const SmallScan made = small_scan();
  for (int i = 0; i < 2; ++i) {
    SceneRow row;
    row.index = i;
    row.name = "0" + std::to_string(i);
    row.seed = 0xfedcba9876543210ULL;
    row.times.reason = 0.25;
    row.score = score_scan(made.scan, &made.scene,
                           perfect_prediction(truth_of(made.scan, &made.scene, run.protocol)),
                           run.protocol);
    row.score.data = run.data;
    run.pooled.add(row.score);
    run.rows.push_back(row);
  }
  return run;
}

TEST(RunJson, ReadsBack) {
  const RunResult run = small_run();
  const RunResult read =
      run_from_json(nlohmann::ordered_json::parse(run_to_json(run).dump()), "run.json");
  EXPECT_EQ(read.pooled, run.pooled);
  EXPECT_EQ(read.rows[1].seed, run.rows[1].seed);
  EXPECT_EQ(read.rows[1].score, run.rows[1].score);
  EXPECT_EQ(read.times.reason, 0.5);
  EXPECT_EQ(protocol_stamp(read.protocol), protocol_stamp(run.protocol));
  EXPECT_EQ(run_to_json(read, false).dump(), run_to_json(run, false).dump());
}

TEST(RunJson, AnotherProtocolThanItsStampIsRefused) {
  auto json = run_to_json(small_run());
  json["protocol"] = protocol_to_text(find_protocol("coco"));
  EXPECT_THROW(run_from_json(json, "run.json"), Error);
}

TEST(RunJson, CutFilesAreNoticed) {
  auto json = run_to_json(small_run());
  json["scenes"].erase(1);
  EXPECT_THROW(run_from_json(json, "run.json"), Error);
}

}  // namespace
}  // namespace scanchor
