#include "apps/check_pictures.hpp"

#include <fmt/format.h>

#include "core/file.hpp"
#include "results/image.hpp"
#include "results/pictures.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

constexpr int picture_width = 960, picture_height = 540;

Image picture_of_task(const SceneTask& task, const Method& method) {
  const MadeScene made = make_scene(task, 1);
  const Scan& scan = made.scans.front();
  const MethodAnswer said = method.answer(scan, task.name);
  PictureOptions options;
  options.render.width = picture_width;
  options.render.height = picture_height;
  options.title = fmt::format("{} {}", task.room.family, task.name);
  if (!said.surfaces || !said.labelling)
    return picture_of_scan(made.scene, scan, options, CloudColor::class_id);
  return picture_of_labels(*said.surfaces, *said.labelling, options, &scan.cloud,
                           scan.T_world_sensor);
}

template <class Wanted>
void for_tasks(const Suite& suite, const Wanted& wanted) {
  for (const auto& task : scene_tasks(suite)) wanted(task);
}

}  // namespace

void draw_baseline_pictures(const fs::path& folder, const Suite& suite, const Method& method,
                            const RunResult& run) {
  make_folder(folder);
  for_tasks(suite, [&](const SceneTask& task) {
    for (const auto& row : run.rows) {
      if (row.index == task.index)
        write_png(folder / (task.name + ".png"), picture_of_task(task, method));
    }
  });
}

std::vector<fs::path> draw_worst_scenes(const fs::path& folder, const fs::path& before,
                                        const Suite& suite, const Method& method,
                                        const GateReport& report) {
  std::vector<fs::path> files;
  if (report.worst.empty()) return files;
  make_folder(folder);
  for_tasks(suite, [&](const SceneTask& task) {
    for (const auto& scene : report.worst) {
      if (scene.index != task.index) continue;
      const Image now = picture_of_task(task, method);
      const fs::path old = before / (task.name + ".png");
      const std::string change = fmt::format("now: {:+.1f} points", 100.0 * scene.difference);
      files.push_back(folder / fmt::format("worst-{}.png", task.name));
      write_png(files.back(), fs::exists(old)
                                  ? side_by_side({read_png(old), now}, {"baseline", change})
                                  : side_by_side({now}, {change}));
    }
  });
  return files;
}

}  // namespace scanchor::apps
