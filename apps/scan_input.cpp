#include "apps/scan_input.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cloud/io.hpp"

namespace scanchor::apps {

void add_scan_arguments(CLI::App& verb, ScanArguments& arguments, bool reasoning) {
  verb.add_option("scan", arguments.scan, "Scan file: PCD, PLY, XYZ text or SemanticKITTI bin")
      ->required()
      ->type_name("SCAN");
  verb.add_option("--sensor", arguments.sensor,
                  "Where the sensor stood, x,y,z in the scan's frame; auto: what the file says; "
                  "none: unknown")
      ->capture_default_str();
  verb.add_option("--noise", arguments.perceive.noise_sigma,
                  "Range noise of the sensor in metres; 0: estimated from the scan")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb.add_option("--method", arguments.perceive.method, "Perception: default or paper")
      ->check(CLI::IsMember({"default", "paper"}))
      ->capture_default_str();
  if (reasoning) {
    verb.add_option("--up", arguments.reason.up,
                    "Direction against gravity, x,y,z; auto: found from the scan")
        ->capture_default_str();
    verb.add_option("--ontology", arguments.ontology,
                    "Descriptions: a name that comes with the program or a .sdl file")
        ->capture_default_str();
    verb.add_option("--mode", arguments.reason.mode, "Reasoning: default or paper")
        ->check(CLI::IsMember({"default", "paper"}))
        ->capture_default_str();
  }
  add_common(verb, arguments.common);
}

PointCloud load_scan(ScanArguments& arguments) {
  OptionList list;
  list.add_group("perceive", arguments.perceive);
  list.add_group("reason", arguments.reason);
  apply_settings(list, arguments.common);
  if (arguments.reason.up != "auto") parse_vector(arguments.reason.up, "--up");

  PointCloud cloud = read_cloud(arguments.scan);
  if (arguments.sensor == "none") {
    cloud.sensor_poses.clear();
  } else if (arguments.sensor != "auto") {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = parse_vector(arguments.sensor, "--sensor");
    cloud.sensor_poses = {pose};
  }
  require_finite(cloud, arguments.scan);
  return cloud;
}

void require_finite(const PointCloud& cloud, const std::string& file) {
  if (std::none_of(cloud.points.begin(), cloud.points.end(),
                   [](const Eigen::Vector3d& p) { return p.allFinite(); })) {
    throw Error(
        ExitCode::nothing_measured,
        fmt::format("{}: none of its {} points is finite; nothing to look at", file, cloud.size()));
  }
}

void require_surfaces(const ScanArguments& arguments, const PointCloud& cloud,
                      const Surfaces& surfaces) {
  if (!surfaces.surfaces.empty()) return;
  throw Error(
      ExitCode::nothing_measured,
      fmt::format("{}: no planar surface beyond chance in its {} points; nothing was written",
                  arguments.scan, cloud.size()));
}

std::vector<std::size_t> inlier_counts(const Surfaces& surfaces) {
  std::vector<std::size_t> counts;
  for (const auto& surface : surfaces.surfaces) counts.push_back(surface.inliers.size());
  return counts;
}

std::vector<std::string> label_names(const Labelling& labelling) {
  std::vector<std::string> names;
  for (const auto& entity : labelling.entities) names.push_back(entity.label);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  std::erase(names, "unknown");
  std::erase(names, "ambiguous");
  return names;
}

void write_labelled_points(const std::filesystem::path& path, const PointCloud& cloud,
                           const Surfaces& surfaces, const Labelling* labelling) {
  PointCloud labelled = cloud;
  if (labelling != nullptr) {
    const auto names = label_names(*labelling);
    std::vector<std::int32_t> label(cloud.size(), -1);
    std::vector<std::int32_t> instance(cloud.size(), -1);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const std::int32_t plane = surfaces.plane_of_point[i];
      if (plane < 0) continue;
      const std::int32_t owner = labelling->entity_of_surface[static_cast<std::size_t>(plane)];
      const auto& entity = labelling->entities[static_cast<std::size_t>(owner)];
      const auto name = std::lower_bound(names.begin(), names.end(), entity.label);
      if (name != names.end() && *name == entity.label)
        label[i] = static_cast<std::int32_t>(name - names.begin());
      instance[i] = owner;
    }
    labelled.set({"label", std::move(label)});
    labelled.set({"instance", std::move(instance)});
  }
  labelled.set({"plane", surfaces.plane_of_point});
  write_cloud(path, labelled);
}

}  // namespace scanchor::apps
