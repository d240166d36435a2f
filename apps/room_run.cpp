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

/// From the second place on, the name tells which.
std::string scan_name(const std::string& room, std::size_t place) {
  return place == 0 ? room : room + "." + std::to_string(place + 1);
}

void understand(const Scene& scene, const Scan& scan, const Chain& chain, const fs::path& folder,
                RoomResult& result) {
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
}

}  // namespace

std::vector<RoomResult> run_room(const SceneTask& task, int scans, const Chain& chain,
                                 const fs::path& out) {
  StageTimes made_in;
  const MadeScene made = make_scene(task, scans, &made_in);
  std::vector<RoomResult> results;
  const double share = 1.0 / static_cast<double>(made.scans.size());
  for (std::size_t place = 0; place < made.scans.size(); ++place) {
    const std::string name = scan_name(task.name, place);
    RoomResult result{name, task.room.family, task.seed, 0, 0, {}, {}, {}, {}};
    result.seconds = {{"generate", share * made_in.generate},
                      {"settle", share * made_in.settle},
                      {"scan", share * made_in.scan}};
    understand(made.scene, made.scans[place], chain, out / name, result);
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace scanchor::apps
