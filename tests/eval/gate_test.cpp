#include "eval/gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace scanchor {
namespace {

constexpr ClassId desk_id = 8, chair_id = 12;

// A synthetic run: scenes of 40 things whose difficulty differs by 15 points between scenes, and a
// pipeline whose own luck moves a scene by 4 points (the figures of the experiment in the design
// notes). `recall` shifts all scenes; `luck` is the pipeline's seed.
RunResult synthetic(int scenes, double recall, std::uint64_t luck, const Protocol& protocol = {}) {
  RunResult run;
  run.suite = "synthetic";
  run.data = "synthetic/test";
  run.method = "method";
  run.protocol = protocol;
  const CounterRandom difficulty(1), own(1000 + luck);
  for (int i = 0; i < scenes; ++i) {
    SceneRow row;
    row.index = i;
    row.name = std::to_string(i);
    row.seed = static_cast<std::uint64_t>(i);
    const auto u = static_cast<std::uint64_t>(i);
    const double rate =
        std::clamp(recall + 0.15 * difficulty.normal(u) + 0.04 * own.normal(u), 0.0, 1.0);
    row.score.protocol = protocol_stamp(protocol);
    row.score.data = run.data;
    row.score.scans = 1;
    row.score.objects.classes.resize(class_list().size());
    auto& counts = row.score.objects.classes[desk_id];
    counts.truths = 400;
    counts.found = std::llround(400 * rate);
    counts.wrong = std::llround(400 * (1.0 - rate) * 0.5);
    row.score.planes.hoover.resize(protocol.plane_tolerances.size());
    for (auto& h : row.score.planes.hoover) h.correct = counts.found;
    row.score.planes.truths = 400;
    row.score.planes.regions = 420;
    run.pooled.add(row.score);
    run.rows.push_back(row);
  }
  return run;
}

GateOptions quick() {
  GateOptions options;
  options.replicates = 500;
  options.metrics = {"objects.f1", "objects.recall", "planes.f1"};
  return options;
}

int alarms(int scenes, double drop, int trials) {
  int count = 0;
  for (int t = 0; t < trials; ++t) {
    const auto seed = static_cast<std::uint64_t>(t);
    GateOptions options = quick();
    options.class_details = false;
    const auto report = compare_runs(synthetic(scenes, 0.7, 2 * seed),
                                     synthetic(scenes, 0.7 - drop, 2 * seed + 1), options);
    count += report.verdict == Verdict::regressed;
  }
  return count;
}

TEST(Gate, RaisesFewAlarmsWhenNothingChanged) {
  EXPECT_LE(alarms(100, 0.0, 1000), 50);
}  // 5 % of 1000; with 120 trials chance alone gives 2 to 10
TEST(Gate, CatchesTwoPointsWithHundredScenes) {
  EXPECT_GE(alarms(100, 0.02, 200), 185);
}  // 95.8 % measured
TEST(Gate, CatchesOnePointWithTwoHundredScenes) {
  EXPECT_GE(alarms(200, 0.01, 200), 143);
}  // 77.7 % measured - 2 standard deviations

TEST(Gate, HolmIsOfferedAndChargesMore) {
  const RunResult before = synthetic(60, 0.7, 1), after = synthetic(60, 0.68, 2);
  GateOptions holm = quick();
  holm.correction = "holm";
  const auto stepped = compare_runs(before, after, quick());
  const auto plain = compare_runs(before, after, holm);
  for (std::size_t i = 0; i < stepped.gated.size(); ++i) {
    EXPECT_EQ(plain.gated[i].p, stepped.gated[i].p);
    EXPECT_GE(plain.gated[i].p_adjusted, stepped.gated[i].p_adjusted);
  }
  EXPECT_GT(plain.gated[0].p_adjusted, 1.5 * stepped.gated[0].p_adjusted);
}

TEST(Gate, SameRunIsNotWorseAndNothingIsDrawn) {
  const RunResult run = synthetic(20, 0.7, 1);
  const auto report = compare_runs(run, run, quick());
  EXPECT_EQ(report.verdict, Verdict::not_worse);
  EXPECT_EQ(report.exit_code(true), ExitCode::done);
  EXPECT_TRUE(report.classes.empty());
  EXPECT_TRUE(report.worst.empty());
}

TEST(Gate, CatchesTwoLabelsSwapped) {
  const RunResult before = synthetic(30, 0.7, 1);
  RunResult after = before;
  after.pooled = Score{};
  for (auto& row : after.rows) {  // every desk is called a chair
    auto& classes = row.score.objects.classes;
    classes[chair_id].wrong = classes[desk_id].found;
    classes[desk_id].found = 0;
    after.pooled.add(row.score);
  }
  const auto report = compare_runs(before, after, quick());
  EXPECT_EQ(report.verdict, Verdict::regressed);
  EXPECT_EQ(report.exit_code(false), ExitCode::gate_failed);
  ASSERT_FALSE(report.classes.empty());
  EXPECT_EQ(report.classes.front().name, "objects.f1.desk");
  EXPECT_EQ(report.worst.size(), 3U);
}

TEST(Gate, OtherProtocolOrDataIsRefused) {
  const RunResult before = synthetic(5, 0.7, 1);
  const RunResult other = synthetic(5, 0.7, 1, find_protocol("coco"));
  try {
    compare_runs(before, other, quick());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    EXPECT_THAT(error.what(), testing::HasSubstr("scanchor-1 v2"));
    EXPECT_THAT(error.what(), testing::HasSubstr("coco v1"));
  }
  RunResult moved = before;
  moved.pooled.data = "other";
  EXPECT_THROW(compare_runs(before, moved, quick()), Error);
  RunResult redrawn = before;
  redrawn.rows[3].seed = 99;
  EXPECT_THROW(compare_runs(before, redrawn, quick()), Error);
  RunResult locked = before, remade = before;  // the same seed, but the generator changed
  locked.rows[3].scan_hash = "0123456789abcdef";
  remade.rows[3].scan_hash = "fedcba9876543210";
  EXPECT_NO_THROW(compare_runs(before, remade, quick()));  // an old baseline without hashes
  try {
    compare_runs(locked, remade, quick());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    EXPECT_THAT(error.what(), testing::HasSubstr("scene 3: has other scans"));
  }
}

TEST(Gate, NothingInCommonIsNothingMeasured) {
  RunResult before = synthetic(3, 0.7, 1), after = before;
  for (auto& row : after.rows) row.index += 10;
  try {
    compare_runs(before, after, quick());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::nothing_measured);
  }
}

TEST(Gate, AScanThatLostItsAnswerFailsTheGate) {
  const RunResult before = synthetic(10, 0.7, 1);
  RunResult after = before;
  after.rows[4].score.failed.push_back("4/0: killed after 60 s");
  const auto report = compare_runs(before, after, quick());
  EXPECT_EQ(report.verdict, Verdict::regressed);
  EXPECT_THAT(gate_to_junit(report), testing::HasSubstr("killed after 60 s"));
}

TEST(Gate, GoesOnToMoreScenesWhileInconclusive) {
  const RunResult baseline = synthetic(400, 0.7, 2), candidate = synthetic(400, 0.694, 3);
  std::vector<int> asked;
  const auto run = [&](int scenes) {
    asked.push_back(scenes);
    RunResult part = candidate;
    part.rows.resize(static_cast<std::size_t>(scenes));
    return part;
  };
  const auto report = check_against(baseline, run, quick());
  EXPECT_GT(asked.size(), 1U);
  EXPECT_EQ(asked.front(), 50);
  if (report.verdict == Verdict::inconclusive) {
    EXPECT_EQ(report.exit_code(true), ExitCode::inconclusive);
    EXPECT_EQ(report.exit_code(false), ExitCode::done);
    EXPECT_THAT(report.next, testing::HasSubstr("800"));
  }
}

TEST(Gate, AnswersAtTheFirstLookWhenNothingMoved) {
  const RunResult baseline = synthetic(200, 0.7, 2);
  int asked = 0;
  const auto report = check_against(
      baseline,
      [&](int scenes) {
        ++asked;
        RunResult part = baseline;
        part.rows.resize(static_cast<std::size_t>(scenes));
        return part;
      },
      quick());
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(report.verdict, Verdict::not_worse);
}

TEST(Gate, UnknownMetricSaysWhatWasMeant) {
  GateOptions options = quick();
  options.metrics = {"objects.f2"};
  const RunResult run = synthetic(3, 0.7, 1);
  try {
    compare_runs(run, run, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_usage);
    EXPECT_THAT(error.what(), testing::HasSubstr("objects.f1"));
  }
}

}  // namespace
}  // namespace scanchor
