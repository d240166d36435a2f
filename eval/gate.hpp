#pragma once
// The regression gate: is this run worse than the baseline? docs/why/gate.md tells how the rules
// were chosen and what they catch.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "eval/run.hpp"
#include "eval/statistics.hpp"

namespace scanchor {

struct GateOptions {
  double margin =
      0.01;  ///< a drop up to that is accepted (non-inferiority), in units of the metric
  double alpha =
      0.05;  ///< one-sided error rate of the whole gate: at most this share of false alarms
  int replicates = 10000;  ///< of the bootstrap and of the sign flips
  std::uint64_t seed = 1;
  std::string correction = "westfall-young";  ///< for several metrics; or "holm"
  bool class_details = true;                  ///< F1 by class for the report
  bool strict = false;                        ///< inconclusive is exit code 5 instead of 0
  std::vector<std::string> metrics = {"objects.f1", "panoptic.pq", "points.miou",
                                      "planes.f1"};  ///< names of gate_metrics
  void describe(OptionList& list);
};

enum class Verdict : std::uint8_t { not_worse, improved, inconclusive, regressed };
std::string verdict_word(Verdict verdict);

struct GateMetric {
  std::string name;
  double before = 0, after = 0;
  Interval change;        ///< BCa, confidence 1 - 2 alpha: its upper end is the one-sided bound
  double p = 1;           ///< sign flip, one-sided
  double p_adjusted = 1;  ///< stepped down over the gated metrics (GateOptions::correction)
  Verdict verdict = Verdict::inconclusive;
  [[nodiscard]] double difference() const { return after - before; }
};

struct GateScene {
  int index = 0;
  std::string name, family;
  std::uint64_t seed = 0;
  double difference = 0;  ///< in the first gated metric
};

struct GateReport {
  std::string suite, data, protocol, before_method, after_method;
  std::size_t scenes = 0;   ///< paired
  double confidence = 0.9;  ///< of the intervals: two-sided, so that each end is a one-sided bound
  Verdict verdict = Verdict::inconclusive;
  std::vector<GateMetric> gated;
  std::vector<GateMetric>
      classes;  ///< F1 of things by class, for information: no verdict is drawn from them
  std::vector<GateScene> worst;           ///< up to three, largest drop first
  std::vector<std::string> newly_failed;  ///< scans that have an answer in the baseline only
  std::string next;                       ///< what to do where inconclusive: "run 200 scenes"
  [[nodiscard]] ExitCode exit_code(bool strict) const;
};

/// The metrics a gate can be set on: objects.f1, objects.precision, objects.recall,
/// objects.f1.CLASS, panoptic.pq, points.miou, planes.f1, planes.precision, planes.recall (at
/// geometry_tolerance). Counts of the scenes of both runs, paired by index.
PairedCounts paired_counts(const std::string& metric, const std::vector<const Score*>& before,
                           const std::vector<const Score*>& after, const Protocol& protocol);

/// Compares over the scenes that both runs have. `level`: one-sided error rate of this look; 0:
/// GateOptions::alpha. regressed: upper bound below 0, drop larger than half the margin, and
/// adjusted p below the level. not_worse: lower bound above -margin. improved: lower bound above 0.
/// Throws Error(bad_data) for another protocol or other data, Error(nothing_measured) without
/// common scenes.
GateReport compare_runs(const RunResult& before, const RunResult& after, const GateOptions& options,
                        double level = 0.0);

/// Looks at the first `looks[i]` scenes, and goes on to more while inconclusive and the baseline
/// has them. `run` returns the candidate's run over the first n scenes of the baseline's part (it
/// may reuse the scenes it ran before).
GateReport check_against(const RunResult& baseline, const std::function<RunResult(int scenes)>& run,
                         const GateOptions& options, std::vector<int> looks = {50, 100, 200, 400});

nlohmann::ordered_json gate_to_json(const GateReport& report);
std::string gate_to_markdown(const GateReport& report);  ///< for a pull request
std::string gate_to_junit(const GateReport& report);     ///< one test case a metric
std::string gate_to_text(const GateReport& report);      ///< for a terminal
/// Bencher's metric format: {name: {measure: {value, lower_value, upper_value}}}.
nlohmann::ordered_json gate_to_bencher(const GateReport& report);

}  // namespace scanchor
