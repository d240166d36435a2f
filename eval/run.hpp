#pragma once
// A whole suite: generate, settle, scan, perceive, reason, score; scene by scene, in parallel,
// nothing on disk.

#include <atomic>
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "eval/score.hpp"
#include "perception/perceive.hpp"
#include "reasoning/reason.hpp"
#include "sensors/suite.hpp"

namespace scanchor {

/// Wall time of the stages of one scene [s], its scans together. Other scenes run beside it.
struct StageTimes {
  double generate = 0, settle = 0, scan = 0, perceive = 0, reason = 0, score = 0;
  [[nodiscard]] double total() const {
    return generate + settle + scan + perceive + reason + score;
  }
  void add(const StageTimes& other);
};

/// What a method says of a scan. Surfaces and labelling are there where the method is one of ours.
struct MethodAnswer {
  PointPrediction points;
  std::optional<Surfaces> surfaces;
  std::optional<Labelling> labelling;
  double perceive_seconds = 0, reason_seconds = 0;
};

/// From a scan to an answer. Must not look at Scan::truth; may be called from several threads at
/// once. An exception is a scan without an answer: all missed, and listed.
struct Method {
  std::string name;                ///< "default", "paper", "pcl-region-growing", ...
  std::vector<ClassId> described;  ///< classes it has a word for; empty: all
  std::function<MethodAnswer(const Scan& scan, const std::string& scan_name)> answer;
};

/// Our own pipeline.
Method own_method(const PerceiveOptions& perceive, const Ontology& ontology,
                  const ReasonOptions& reason);

struct RunOptions {
  Protocol protocol;
  std::string split = "test";  ///< "train", "valid", "test"; empty: all
  int scenes = 0;              ///< at most so many of the split; 0: all
  int first_scene =
      0;  ///< of the split: skips that many (a gate that asks for more scenes goes on here)
  Shard shard;
  int threads = 0;  ///< 0: as many as there are cores. Counts do not depend on it
  /// Called after each scene, from any thread but never from two at once.
  std::function<void(std::size_t done, std::size_t total)> progress;
  const std::atomic<bool>* stop = nullptr;  ///< set it and the run ends after the scenes under way
};

/// One scene of the suite with all its scans.
struct SceneRow {
  int index = 0;  ///< in the suite
  std::string name;
  std::string split;
  std::string family;
  std::uint64_t seed = 0;
  Score score;
  StageTimes times;
  std::string problem;  ///< what did not come to rest; empty: all well
  /// First 16 digits of the SHA-256 of the scans' points and truth: the lock of the scene. Runs of
  /// scenes that were made otherwise are not compared. Empty: not known.
  std::string scan_hash;
};

struct RunResult {
  std::string suite;  ///< name
  std::string data;   ///< stamp: name, part, hash of everything that makes the scenes and scans
  std::string method;
  Protocol protocol;
  std::vector<SceneRow> rows;  ///< in order of the suite
  Score pooled;
  StageTimes times;  ///< sum
  double wall_seconds = 0;
  double peak_memory_mb = 0;  ///< of the process
  bool interrupted = false;
};

/// Runs a method over a suite. Deterministic but for times and memory: the same suite, method and
/// protocol give the same counts for any number of threads. Throws Error(nothing_measured) where
/// the part has no scene.
RunResult run_suite(const Suite& suite, const Method& method, const RunOptions& options);

/// The scenes a run would take.
std::vector<SceneTask> tasks_of(const Suite& suite, const RunOptions& options);

/// One scene, from its task: for replay, blame and shrinking.
struct MadeScene {
  Scene scene;
  std::vector<Scan> scans;
  std::string problem;
};
MadeScene make_scene(const SceneTask& task, int scans, StageTimes* times = nullptr);

/// SceneRow::scan_hash of one scan.
std::string hash_of_scan(const Scan& scan);

/// Pools rows that belong together, in the order of the suite; duplicates and rows of other data or
/// protocols throw Error(bad_data). This is how shards are laid side by side.
RunResult merge_runs(std::vector<RunResult> parts);

/// Name, part and hash of what makes the data; the number of scenes is left out, since a longer
/// suite begins with a shorter one.
std::string data_stamp(const Suite& suite, const std::string& split);

/// run.json. `with_times`: false leaves out what differs from run to run.
nlohmann::ordered_json run_to_json(const RunResult& result, bool with_times = true);
RunResult run_from_json(const nlohmann::ordered_json& json, const std::string& file);

}  // namespace scanchor
