#include "apps/room_run.hpp"

#include <chrono>

#include "apps/scan_input.hpp"
#include "apps/scan_pictures.hpp"
#include "cloud/io.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "eval/evaluate.hpp"
#include "eval/run.hpp"
#include "reasoning/alternatives.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

/// Measures stages one after another.
class Stopwatch {
 public:
  explicit Stopwatch(std::vector<std::pair<std::string, double>>& laps) : laps_(laps) {}
  void lap(const std::string& stage) {
    const auto now = std::chrono::steady_clock::now();
    laps_.emplace_back(stage, std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }

 private:
  std::vector<std::pair<std::string, double>>& laps_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

RoomResult run_room(const SceneTask& task, const Chain& chain, const fs::path& folder) {
  RoomResult result{task.name, task.room.family, task.seed, 0, 0, {}, {}, {}, {}};
  StageTimes made_in;
  const MadeScene made = make_scene(task, 1, &made_in);
  const Scene& scene = made.scene;
  const Scan& scan = made.scans.front();
  result.seconds = {
      {"generate", made_in.generate}, {"settle", made_in.settle}, {"scan", made_in.scan}};
  Stopwatch watch(result.seconds);
  Surfaces surfaces = find_planes(scan.cloud, chain.perceive);
  watch.lap("planes");
  find_shapes(scan.cloud, chain.perceive, surfaces);
  watch.lap("shapes");
  const Labelling labelling = interpret(surfaces, scan.cloud, chain.ontology, chain.reason);
  watch.lap("reason");
  ScanAnswer answer;
  answer.points = predict_points(surfaces, labelling);
  answer.surfaces = &surfaces;
  answer.labelling = &labelling;
  answer.described = classes_of_labels(chain.ontology.class_names());
  result.score = score_scan(scan, &scene, answer, chain.protocol, {}, &result.objects);
  watch.lap("score");

  result.points = scan.cloud.size();
  result.surfaces = surfaces.surfaces.size();
  make_folder(folder);
  write_scene(folder / "scene.json", scene);
  write_cloud(folder / "scan.pcd", cloud_with_truth(scan));
  write_surfaces(folder / "surfaces.json", surfaces);
  write_json(folder / "labels.json", labelling_to_json(labelling, inlier_counts(surfaces)));
  write_json(folder / "scores.json", score_to_json(result.score, chain.protocol));
  watch.lap("write");
  if (chain.pictures) {
    result.pictures = draw_room(folder, scene, scan, surfaces, labelling);
    watch.lap("draw");
  }
  return result;
}

}  // namespace scanchor::apps
