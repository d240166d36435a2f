#include "eval/run.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "reasoning/alternatives.hpp"
#include "sensors/made_room.hpp"

namespace scanchor {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last call or the construction.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

SceneRow run_scene(const SceneTask& task, int scans, const Method& method,
                   const Protocol& protocol) {
  SceneRow row;
  row.index = task.index;
  row.name = task.name;
  row.split = task.split;
  row.family = task.room.family;
  row.seed = task.seed;
  const MadeScene made = make_scene(task, scans, &row.times);
  row.problem = made.problem;
  for (std::size_t k = 0; k < made.scans.size(); ++k) {
    const Scan& scan = made.scans[k];
    const std::string name = task.name + "/" + std::to_string(k);
    row.scan_hash = sha256(row.scan_hash + hash_of_scan(scan)).substr(0, 16);
    Stopwatch watch;
    MethodAnswer said;
    std::string cause;
    try {
      said = method.answer(scan, name);
    } catch (const std::exception& error) {
      cause = error.what();
    }
    const double spent = watch.lap();
    row.times.reason += said.reason_seconds;
    row.times.perceive += said.perceive_seconds > 0 ? said.perceive_seconds : spent;
    if (cause.empty()) {
      ScanAnswer answer;
      answer.points = std::move(said.points);
      answer.surfaces = said.surfaces ? &*said.surfaces : nullptr;
      answer.labelling = said.labelling ? &*said.labelling : nullptr;
      answer.described = method.described;
      try {
        row.score.add(score_scan(scan, &made.scene, answer, protocol));
      } catch (const Error& error) {
        cause = error.what();  // an answer that cannot be scored is no answer
      }
    }
    if (!cause.empty()) row.score.add(score_failed(scan, &made.scene, name, cause, protocol));
    row.times.score += watch.lap();
  }
  return row;
}

void pool(RunResult& result) {
  result.pooled = Score{};
  result.times = StageTimes{};
  for (auto& row : result.rows) {
    row.score.data = result.data;
    result.pooled.add(row.score);
    result.times.add(row.times);
  }
}

}  // namespace

void StageTimes::add(const StageTimes& other) {
  generate += other.generate;
  settle += other.settle;
  scan += other.scan;
  perceive += other.perceive;
  reason += other.reason;
  score += other.score;
}

MadeScene make_scene(const SceneTask& task, int scans, StageTimes* times) {
  Stopwatch watch;
  StageTimes spent;
  MadeScene made;
  RoomTimes room_times;
  MadeRoom room = make_room(task, &room_times);
  made.scene = std::move(room.scene);
  if (!room.problems.empty()) made.problem = room.problems.front();
  spent.generate = room_times.generate;
  spent.settle = room_times.settle;
  watch.lap();
  const World world(made.scene);
  for (int k = 0; k < scans; ++k) {
    made.scans.push_back(
        scan_room(world, scan_pose(made.scene, k), task.lidar, scan_seed(task, k)));
  }
  spent.scan = watch.lap();
  if (times) times->add(spent);
  return made;
}

std::string hash_of_scan(const Scan& scan) {
  std::string bytes;
  const auto add = [&](const auto& list) {
    const auto* first = reinterpret_cast<const char*>(list.data());
    bytes.append(first, list.size() * sizeof(list[0]));
  };
  add(scan.cloud.points);
  add(scan.truth.class_id);
  add(scan.truth.instance);
  add(scan.truth.face);
  add(scan.truth.flags);
  return sha256(bytes).substr(0, 16);
}

Method own_method(const PerceiveOptions& perceive_options, const Ontology& ontology,
                  const ReasonOptions& reason_options) {
  Method method;
  method.name = perceive_options.method + "/" + reason_options.mode + "/" + ontology.name;
  std::vector<std::string> words;
  for (const auto& description : ontology.classes)
    words.insert(words.end(), description.names.begin(), description.names.end());
  method.described = classes_of_labels(words);
  method.answer = [=](const Scan& scan, const std::string&) {
    Stopwatch watch;
    MethodAnswer answer;
    answer.surfaces = perceive(scan.cloud, perceive_options);
    answer.perceive_seconds = watch.lap();
    answer.labelling = interpret(*answer.surfaces, scan.cloud, ontology, reason_options);
    answer.reason_seconds = watch.lap();
    answer.points = predict_points(*answer.surfaces, *answer.labelling);
    return answer;
  };
  return method;
}

std::vector<SceneTask> tasks_of(const Suite& suite, const RunOptions& options) {
  std::vector<SceneTask> tasks;
  int passed = 0;
  for (auto& task : scene_tasks(suite)) {
    if (!options.split.empty() && task.split != options.split) continue;
    const int place = passed++;
    if (place < options.first_scene || !options.shard.has(task.index)) continue;
    if (options.scenes > 0 && place >= options.first_scene + options.scenes) break;
    tasks.push_back(std::move(task));
  }
  return tasks;
}

RunResult run_suite(const Suite& suite, const Method& method, const RunOptions& options) {
  const auto tasks = tasks_of(suite, options);
  if (tasks.empty()) {
    throw Error(ExitCode::nothing_measured, "suite " + suite.name + " has no scene in part '" +
                                                options.split +
                                                "'; choose another part or more scenes");
  }
  RunResult result;
  result.suite = suite.name;
  result.data = data_stamp(suite, options.split);
  result.method = method.name;
  result.protocol = options.protocol;
  const ThreadLimit limit(options.threads);
  std::vector<std::optional<SceneRow>> rows(tasks.size());
  std::mutex mutex;
  std::size_t done = 0;
  Stopwatch watch;
  parallel_blocks(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (options.stop && options.stop->load()) return;
      rows[i] = run_scene(tasks[i], suite.scans, method, options.protocol);
      const std::lock_guard lock(mutex);
      ++done;
      if (options.progress) options.progress(done, tasks.size());
    }
  });
  for (auto& row : rows) {
    if (row)
      result.rows.push_back(std::move(*row));
    else
      result.interrupted = true;
  }
  pool(result);
  result.wall_seconds = watch.lap();
  result.peak_memory_mb = peak_memory();
  return result;
}

RunResult merge_runs(std::vector<RunResult> parts) {
  if (parts.empty()) throw Error(ExitCode::nothing_measured, "no runs to lay side by side");
  RunResult all = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const RunResult& part = parts[i];
    if (part.data != all.data || protocol_hash(part.protocol) != protocol_hash(all.protocol) ||
        part.method != all.method) {
      fail_data("", "",
                "runs of different data, protocols or methods do not go together: " + all.data +
                    " and " + part.data);
    }
    all.rows.insert(all.rows.end(), part.rows.begin(), part.rows.end());
    all.wall_seconds += part.wall_seconds;
    all.peak_memory_mb = std::max(all.peak_memory_mb, part.peak_memory_mb);
    all.interrupted = all.interrupted || part.interrupted;
  }
  std::stable_sort(all.rows.begin(), all.rows.end(),
                   [](const SceneRow& a, const SceneRow& b) { return a.index < b.index; });
  for (std::size_t i = 1; i < all.rows.size(); ++i) {
    if (all.rows[i].index == all.rows[i - 1].index)
      fail_data("", "scene " + all.rows[i].name, "is in two of the runs");
  }
  pool(all);
  return all;
}

}  // namespace scanchor
