#pragma once
// How scores fall as something gets worse: curves, breaking points, rankings and maps over the
// options of a suite.

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "eval/run.hpp"
#include "eval/statistics.hpp"

namespace scanchor {

/// One option and the values it takes.
struct Axis {
  std::string option;          ///< "lidar.range_sigma"
  std::vector<double> values;  ///< rising
};

/// "lidar.range_sigma=0..0.05" (6 values), "=0..0.05/11" (11 values), "=0,0.01,0.03" (these).
/// Throws Error(wrong_usage).
Axis parse_axis(const std::string& text);

struct SweepPoint {
  std::vector<double> values;  ///< one an axis
  RunResult run;
  std::vector<std::pair<std::string, Interval>>
      intervals;  ///< 95 % BCa over scenes, of the gated metrics
};

struct SweepResult {
  std::string method;  ///< name
  std::vector<Axis> axes;
  std::vector<SweepPoint> points;  ///< last axis fastest
  bool interrupted = false;
  std::size_t elsewhere = 0;  ///< points that belong to other shards
};

struct SweepOptions {
  RunOptions run;
  std::vector<std::string> metrics = {"objects.f1",  "objects.recall", "objects.precision",
                                      "panoptic.pq", "points.miou",    "planes.f1"};
  int replicates = 2000;
  std::filesystem::path
      folder;    ///< finished points are kept there and found again; empty: not kept
  Shard points;  ///< of the points; those of other shards are left out
  /// What else decides the counts of a point: the program, options of the method. Points that were
  /// kept under another stamp are not found.
  std::string stamp;
  std::function<void(std::size_t done, std::size_t total, const SweepPoint&)> progress;
};

/// A gated metric (gate_metrics) of a run, over all its scenes.
double value_of(const RunResult& run, const std::string& metric);

/// The run of one set of values: by default run_suite with the suite's options set. Replaceable for
/// tests and other sources of runs.
using PointRunner = std::function<RunResult(const Suite& suite)>;

/// Runs a method over a suite; finished runs are kept in SweepOptions::folder, each as a file named
/// after everything that decides its counts, and found again.
PointRunner kept_runs(const Method& method, const SweepOptions& options);

/// All combinations of the axes' values. The scenes are the same at every point (same seeds), so
/// the points are paired.
SweepResult sweep(const Suite& suite, const std::vector<Axis>& axes, const Method& method,
                  const SweepOptions& options);
SweepResult sweep(const Suite& suite, const std::vector<Axis>& axes, const SweepOptions& options,
                  const PointRunner& runner);

/// A suite with options set by their names; unknown names throw Error(wrong_usage) with "did you
/// mean".
Suite with_options(const Suite& suite, const std::vector<std::pair<std::string, double>>& values);

struct BreakingPoint {
  std::string metric;
  double limit = 0.5;
  bool breaks = false;      ///< false: holds over the whole range, `value` is its end
  bool from_start = false;  ///< below the limit at the range's start already
  double value = 0;         ///< of the option where the metric falls below the limit
  Interval interval;        ///< values at which the metric's 95 % interval crosses the limit
  int runs = 0;             ///< evaluated
};

/// Bisection on one option for the value at which a metric falls below `limit`; the metric is taken
/// to fall as the option rises. Stops when the bracket is narrower than `resolution` of the range.
/// The interval is where the upper and the lower bound of the metric cross the limit, by linear
/// interpolation between the values that were evaluated.
BreakingPoint breaking_point(const Suite& suite, const Axis& range, const std::string& metric,
                             double limit, const PointRunner& runner,
                             double resolution = 1.0 / 64.0, int replicates = 2000);

struct EffectCost {
  std::string option;
  double from = 0, to = 0;
  double before = 0, after = 0;  ///< the metric
  Interval change;               ///< 95 %, paired over scenes
};

/// One effect at a time: each axis goes from its first to its last value while all else stays; most
/// costly first.
std::vector<EffectCost> rank_effects(const Suite& suite, const std::vector<Axis>& axes,
                                     const std::string& metric, const PointRunner& runner,
                                     int replicates = 2000);

/// The same for several metrics of the same runs, one bisection each; runs are shared between them.
std::vector<BreakingPoint> breaking_points(const Suite& suite, const Axis& range,
                                           const std::vector<std::string>& metrics, double limit,
                                           const PointRunner& runner,
                                           double resolution = 1.0 / 64.0, int replicates = 2000);

/// F1 of each class of which a run has at least `least` things that count: "objects.f1.desk", ...
std::vector<std::string> class_metrics(const RunResult& run, std::int64_t least);

/// Rows for a plot: values of the axes, then for each metric the value and, where known, low and
/// high.
nlohmann::ordered_json sweep_to_json(const SweepResult& result);
std::string sweep_to_csv(const SweepResult& result);
/// Several methods over the same axes: the first as above, all of them under "methods".
nlohmann::ordered_json sweeps_to_json(const std::vector<SweepResult>& results);

}  // namespace scanchor
