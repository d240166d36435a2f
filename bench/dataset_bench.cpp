// Where the time of a data set goes, from seeds to bytes on disk: CPU time of each step on one
// core, then the whole by generate_dataset on all cores, with the memory it took.
//   dataset_bench [SUITE [SCENES [FOLDER]]]     default: mixed, 100 scenes, below /tmp

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "cloud/kitti.hpp"
#include "core/data_folder.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "sensors/dataset.hpp"
#include "sensors/dataset_files.hpp"
#include "sensors/dataset_truth.hpp"
#include "sensors/made_room.hpp"

namespace scanchor {
namespace fs = std::filesystem;
namespace {

double cpu_of_process() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

class Steps {
 public:
  /// Books the CPU time since the last call.
  void lap(const std::string& step) {
    const double now = cpu_of_process();
    for (auto& [name, sum] : sums_) {
      if (name != step) continue;
      sum += now - last_;
      last_ = now;
      return;
    }
    sums_.emplace_back(step, now - last_);
    last_ = now;
  }
  void print(double scenes) const {
    double all = 0.0;
    for (const auto& step : sums_) all += step.second;
    for (const auto& [name, sum] : sums_)
      fmt::print("{:22} {:8.1f} ms a scene {:6.1f} %\n", name, 1e3 * sum / scenes, 100 * sum / all);
    fmt::print("{:22} {:8.1f} ms a scene\n", "all", 1e3 * all / scenes);
  }

 private:
  double last_ = cpu_of_process();
  std::vector<std::pair<std::string, double>> sums_;
};

void steps_on_one_core(const Suite& suite, const fs::path& folder) {
  const ThreadLimit limit(1);
  make_folder(folder);
  Steps steps;
  Scan scan;
  const auto tasks = scene_tasks(suite);
  for (const SceneTask& task : tasks) {
    const MadeRoom room = make_room(task);
    steps.lap("generate and settle");
    const World world(room.scene);
    steps.lap("world");
    std::vector<std::vector<FaceVisibility>> seen;
    for (int k = 0; k < suite.scans; ++k) {
      scan_room_into(world, scan_pose(room.scene, k), task.lidar, scan_seed(task, k), scan);
      seen.push_back(scan.visibility);
      steps.lap("scan");
      const std::string bin = format_kitti(scan.cloud);
      const std::string label = label_bytes(scan.truth, "");
      const std::string truth = truth_npy(scan);
      steps.lap("format points");
      std::string hashes = sha256(bin) + sha256(label) + sha256(truth);
      steps.lap("SHA-256");
      write_file(folder / "bin", bin);
      write_file(folder / "label", label);
      write_file(folder / "truth", truth);
      steps.lap("write points");
    }
    write_scene(folder / "scene.json", room.scene);
    steps.lap("scene.json");
    write_file(folder / "faces.json", faces_json(room.scene, seen));
    steps.lap("faces.json");
    write_file(folder / "relations.json", relations_json(room.scene));
    steps.lap("relations.json");
  }
  steps.print(static_cast<double>(tasks.size()));
}

int run(const std::string& name, int scenes, const fs::path& folder) {
  Suite suite = read_suite(find_data_file("suites", name, ".yaml"));
  suite.scenes = scenes;
  fmt::print("{}: {} scenes, {} scans each\n\n", suite.name, suite.scenes, suite.scans);
  steps_on_one_core(suite, folder / "steps");
  const double cpu = cpu_of_process();
  const auto start = std::chrono::steady_clock::now();
  const DatasetResult result = generate_dataset(suite, folder / "set");
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double spent = cpu_of_process() - cpu;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print(
      "\ngenerate_dataset: {} scans, {} points, {} rooms made anew\n"
      "  {:.1f} s wall, {:.1f} s CPU ({:.0f} % of two cores), {:.1f} scans/s: 1000 scans in {:.0f} "
      "s\n"
      "  {:.0f} MiB at most\n",
      result.scans_written, result.points_written, result.rooms_made_anew, wall, spent,
      100 * spent / (2 * wall), static_cast<double>(result.scans_written) / wall,
      1000 * wall / static_cast<double>(result.scans_written),
      static_cast<double>(usage.ru_maxrss) / 1024.0);
  return 0;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  const fs::path folder =
      (argc > 3 ? fs::path(argv[3]) : fs::temp_directory_path()) / "scanchor_dataset_bench";
  fs::remove_all(folder);
  const int code =
      scanchor::run(argc > 1 ? argv[1] : "mixed", argc > 2 ? std::atoi(argv[2]) : 100, folder);
  fs::remove_all(folder);
  return code;
}
