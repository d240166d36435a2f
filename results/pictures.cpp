#include "results/pictures.hpp"

#include <fmt/format.h>

namespace scanchor {
namespace {

Image finish(Drawing drawing, const PictureOptions& options, const std::string& title) {
  drawing.title = options.title.empty() ? title : options.title;
  const View view = framed_view(drawing, options.render, ViewKind::perspective, options.azimuth_deg,
                                options.elevation_deg);
  return render(drawing, view, options.render);
}

/// Direction towards the eye in the frame of a cloud that is about to be moved by T_world_cloud.
Eigen::Vector3d eye_in_cloud(const PictureOptions& options,
                             const Eigen::Isometry3d& T_world_cloud) {
  return T_world_cloud.linear().transpose() *
         towards_eye(options.azimuth_deg, options.elevation_deg);
}

}  // namespace

Image picture_of_scene(const Scene& scene, const PictureOptions& options, SceneColor color) {
  DrawSceneOptions how;
  how.color = color;
  how.towards_eye = towards_eye(options.azimuth_deg, options.elevation_deg);
  return finish(
      draw_scene(scene, how), options,
      fmt::format("{} (seed {})", scene.family.empty() ? "scene" : scene.family, scene.seed));
}

Image picture_of_scan(const Scene& scene, const Scan& scan, const PictureOptions& options,
                      CloudColor color) {
  DrawCloudOptions how;
  how.color = color;
  how.sheet_normals = sheets_of_scan(scan, scene);
  how.towards_eye = eye_in_cloud(options, scan.T_world_sensor);
  PointCloud cloud = cloud_with_truth(scan);
  // The scan's points are relative to the sensor; so is the true range.
  cloud.sensor_poses = {Eigen::Isometry3d::Identity()};
  Drawing drawing = draw_cloud(cloud, how);
  drawing.move(scan.T_world_sensor);
  return finish(std::move(drawing), options, fmt::format("scan, {} points", scan.cloud.size()));
}

Image picture_of_cloud(const PointCloud& cloud, const PictureOptions& options, CloudColor color,
                       const Surfaces* surfaces, const Eigen::Isometry3d& T_world_cloud) {
  DrawCloudOptions how;
  how.color = color;
  if (surfaces != nullptr) {
    how.sheet_normals = sheets_of_surfaces(*surfaces);
    how.towards_eye = eye_in_cloud(options, T_world_cloud);
  }
  Drawing drawing = draw_cloud(
      surfaces != nullptr && color == CloudColor::plane ? with_planes(cloud, *surfaces) : cloud,
      how);
  drawing.move(T_world_cloud);
  return finish(std::move(drawing), options, fmt::format("{} points", cloud.size()));
}

Image picture_of_surfaces(const Surfaces& surfaces, const PictureOptions& options,
                          const Eigen::Isometry3d& T_world_cloud) {
  DrawSurfacesOptions how;
  how.towards_eye = eye_in_cloud(options, T_world_cloud);
  Drawing drawing = draw_surfaces(surfaces, how);
  drawing.move(T_world_cloud);
  return finish(std::move(drawing), options,
                fmt::format("{} planar surfaces", surfaces.surfaces.size()));
}

Image picture_of_labels(const Surfaces& surfaces, const Labelling& labelling,
                        const PictureOptions& options, const PointCloud* cloud,
                        const Eigen::Isometry3d& T_world_cloud, DrawLabelsOptions labels) {
  labels.towards_eye = eye_in_cloud(options, T_world_cloud);
  Drawing drawing = draw_labels(surfaces, labelling, labels);
  if (cloud != nullptr) {
    DrawCloudOptions faint;
    faint.color = CloudColor::plain;
    faint.point_px = 1.0;
    faint.point_m = 0.0;
    faint.sheet_normals = sheets_of_surfaces(surfaces);
    faint.towards_eye = labels.towards_eye;
    Drawing points = draw_cloud(*cloud, faint);
    for (DrawnPoints& group : points.points) {
      group.colors.assign(group.colors.size(), Color{176, 184, 192});
    }
    points.legend.clear();
    drawing.add(points);
  }
  drawing.move(T_world_cloud);
  return finish(std::move(drawing), options, "labels");
}

}  // namespace scanchor
