#include "apps/room_run.hpp"

#include <chrono>

#include "apps/scan_pictures.hpp"
#include "cloud/io.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/random.hpp"
#include "eval/evaluate.hpp"
#include "scenes/generator.hpp"
#include "sim/settle.hpp"
#include "sim/world.hpp"

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

std::vector<std::size_t> inlier_counts(const Surfaces& surfaces) {
  std::vector<std::size_t> counts;
  for (const auto& surface : surfaces.surfaces) counts.push_back(surface.inliers.size());
  return counts;
}

}  // namespace

RoomResult run_room(const SceneTask& task, const Chain& chain, const fs::path& folder) {
  RoomResult result{task.name, task.room.family, task.seed, 0, 0, {}, {}, {}, {}};
  Stopwatch watch(result.seconds);

  Scene scene = generate_room(task.room, task.seed);
  watch.lap("generate");
  settle(scene, task.settle);
  watch.lap("settle");
  const World world(scene);
  const Scan scan = scan_room(world, scene.sensor_poses.at(0), task.lidar, stream_seed(task.seed, "scan", 0));
  watch.lap("scan");
  Surfaces surfaces = find_planes(scan.cloud, chain.perceive);
  watch.lap("planes");
  find_shapes(scan.cloud, chain.perceive, surfaces);
  watch.lap("shapes");
  const Labelling labelling = reason(surfaces, chain.ontology, chain.reason);
  watch.lap("reason");
  Answer answer;
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
