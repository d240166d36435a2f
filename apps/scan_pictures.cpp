#include "apps/scan_pictures.hpp"

#include "reasoning/item.hpp"
#include "results/image.hpp"
#include "results/pictures.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

PictureOptions titled(const std::string& title) {
  PictureOptions options;
  options.title = title;
  return options;
}

}  // namespace

Eigen::Isometry3d upright(const Labelling& labelling) {
  return Eigen::Isometry3d(levelling(labelling.up));
}

std::vector<fs::path> draw_scan(const fs::path& folder, const PointCloud& cloud,
                                const Surfaces& surfaces, const Labelling& labelling) {
  const Eigen::Isometry3d T = upright(labelling);
  const std::vector<fs::path> files = {folder / "cloud.png", folder / "planes.png",
                                       folder / "labels.png"};
  write_png(files[0], picture_of_cloud(cloud, titled("The scan, by height"), CloudColor::height,
                                       &surfaces, T));
  write_png(files[1], picture_of_cloud(with_planes(cloud, surfaces), titled("Planar surfaces"),
                                       CloudColor::plane, &surfaces, T));
  write_png(files[2], picture_of_labels(surfaces, labelling, titled("What was found"), &cloud, T));
  return files;
}

std::vector<fs::path> draw_room(const fs::path& folder, const Scene& scene, const Scan& scan,
                                const Surfaces& surfaces, const Labelling& labelling) {
  const Eigen::Isometry3d& T = scan.T_world_sensor;
  const std::vector<fs::path> files = {folder / "scene.png", folder / "cloud.png",
                                       folder / "planes.png", folder / "labels.png"};
  write_png(files[0], picture_of_scene(scene, titled("The room")));
  write_png(files[1], picture_of_scan(scene, scan, titled("The scan, by true class")));
  write_png(files[2], picture_of_cloud(with_planes(scan.cloud, surfaces), titled("Planar surfaces"),
                                       CloudColor::plane, &surfaces, T));
  write_png(files[3],
            picture_of_labels(surfaces, labelling, titled("What was found"), &scan.cloud, T));
  return files;
}

}  // namespace scanchor::apps
