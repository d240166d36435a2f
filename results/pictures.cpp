#include "results/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scanchor {
namespace {

/// Towards the eye, for what is left out between it and the room; zero from inside: nothing is.
Eigen::Vector3d direction_of(const PictureOptions& options) {
  switch (options.view) {
    case Viewpoint::top:
      return Eigen::Vector3d::UnitZ();
    case Viewpoint::side:
      return towards_eye(options.azimuth_deg, 0.0);
    case Viewpoint::sensor:
      return Eigen::Vector3d::Zero();
    case Viewpoint::perspective:
      break;
  }
  return towards_eye(options.azimuth_deg, options.elevation_deg);
}

View view_of(const Drawing& drawing, const PictureOptions& options,
             const Eigen::Isometry3d& T_world_sensor) {
  const ViewKind kind = options.view == Viewpoint::top    ? ViewKind::top
                        : options.view == Viewpoint::side ? ViewKind::side
                                                          : ViewKind::perspective;
  if (options.view == Viewpoint::sensor) return sensor_view(T_world_sensor);
  return framed_view(drawing, options.render, kind, options.azimuth_deg, options.elevation_deg);
}

/// A drawing with its title and where one looks at it from.
struct Framed {
  Drawing drawing;
  View view;
};

Framed frame(Drawing drawing, const PictureOptions& options, const std::string& title,
             const Eigen::Isometry3d& T_world_sensor) {
  drawing.title = options.title.empty() ? title : options.title;
  const View view = view_of(drawing, options, T_world_sensor);
  return {std::move(drawing), view};
}

Image finish(Drawing drawing, const PictureOptions& options, const std::string& title,
             const Eigen::Isometry3d& T_world_sensor) {
  const Framed framed = frame(std::move(drawing), options, title, T_world_sensor);
  return render(framed.drawing, framed.view, options.render);
}

/// Direction towards the eye in the frame of a cloud that is about to be moved by T_world_cloud.
Eigen::Vector3d eye_in_cloud(const PictureOptions& options,
                             const Eigen::Isometry3d& T_world_cloud) {
  return T_world_cloud.linear().transpose() * direction_of(options);
}

/// Where the sensor of a cloud stood, in the world.
Eigen::Isometry3d sensor_of(const PointCloud& cloud, const Eigen::Isometry3d& T_world_cloud) {
  return cloud.sensor_poses.empty() ? T_world_cloud : T_world_cloud * cloud.sensor_poses.front();
}

Eigen::Isometry3d sensor_of(const Surfaces& surfaces, const Eigen::Isometry3d& T_world_cloud) {
  Eigen::Isometry3d T = T_world_cloud;
  if (!surfaces.sensor_positions.empty()) T.translate(surfaces.sensor_positions.front());
  return T;
}

Drawing drawing_of_scene(const Scene& scene, const PictureOptions& options, SceneColor color) {
  DrawSceneOptions how;
  how.color = color;
  how.towards_eye = direction_of(options);
  return draw_scene(scene, how);
}

}  // namespace

Image picture_of_scene(const Scene& scene, const PictureOptions& options, SceneColor color) {
  const Eigen::Isometry3d sensor =
      scene.sensor_poses.empty() ? Eigen::Isometry3d::Identity() : scene.sensor_poses.front();
  return finish(
      drawing_of_scene(scene, options, color), options,
      fmt::format("{} (seed {})", scene.family.empty() ? "scene" : scene.family, scene.seed),
      sensor);
}

Image picture_of_rooms(const std::vector<Scene>& scenes, const PictureOptions& options,
                       SceneColor color) {
  // Rows of about the square root of their number; each row as deep as its deepest room.
  const auto columns = std::size_t(std::ceil(std::sqrt(double(scenes.size()))));
  std::vector<Drawing> rooms;
  double x = 0.0, y = 0.0, deepest = 0.0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    Drawing room = drawing_of_scene(scenes[i], options, color);
    if (room.bounds.isEmpty()) continue;
    if (i % columns == 0) {
      x = 0.0;
      y -= 1.2 * deepest;
      deepest = 0.0;
    }
    const Eigen::Vector3d size = room.bounds.sizes();
    const Eigen::Vector3d corner = room.bounds.min();
    room.move(Eigen::Isometry3d(
        Eigen::Translation3d(x - corner.x(), y - corner.y() - size.y(), -corner.z())));
    x += 1.2 * size.x();
    deepest = std::max(deepest, size.y());
    rooms.push_back(std::move(room));
  }
  return finish(explode(rooms, 0.0), options, fmt::format("{} rooms", scenes.size()),
                Eigen::Isometry3d::Identity());
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
  return finish(std::move(drawing), options, fmt::format("scan, {} points", scan.cloud.size()),
                scan.T_world_sensor);
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
  return finish(std::move(drawing), options, fmt::format("{} points", cloud.size()),
                sensor_of(cloud, T_world_cloud));
}

namespace {

Framed framed_surfaces(const Surfaces& surfaces, const PictureOptions& options,
                       const Eigen::Isometry3d& T_world_cloud) {
  DrawSurfacesOptions how;
  how.towards_eye = eye_in_cloud(options, T_world_cloud);
  Drawing drawing = draw_surfaces(surfaces, how);
  drawing.move(T_world_cloud);
  return frame(std::move(drawing), options,
               fmt::format("{} planar surfaces", surfaces.surfaces.size()),
               sensor_of(surfaces, T_world_cloud));
}

Framed framed_labels(const Surfaces& surfaces, const Labelling& labelling,
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
  return frame(std::move(drawing), options, "labels", sensor_of(surfaces, T_world_cloud));
}

}  // namespace

Image picture_of_surfaces(const Surfaces& surfaces, const PictureOptions& options,
                          const Eigen::Isometry3d& T_world_cloud) {
  const Framed framed = framed_surfaces(surfaces, options, T_world_cloud);
  return render(framed.drawing, framed.view, options.render);
}

VectorPicture outlines_of_surfaces(const Surfaces& surfaces, const PictureOptions& options,
                                   const Eigen::Isometry3d& T_world_cloud) {
  const Framed framed = framed_surfaces(surfaces, options, T_world_cloud);
  return draw_outlines(framed.drawing, framed.view, options.render);
}

Image picture_of_labels(const Surfaces& surfaces, const Labelling& labelling,
                        const PictureOptions& options, const PointCloud* cloud,
                        const Eigen::Isometry3d& T_world_cloud, DrawLabelsOptions labels) {
  const Framed framed =
      framed_labels(surfaces, labelling, options, cloud, T_world_cloud, std::move(labels));
  return render(framed.drawing, framed.view, options.render);
}

VectorPicture outlines_of_labels(const Surfaces& surfaces, const Labelling& labelling,
                                 const PictureOptions& options,
                                 const Eigen::Isometry3d& T_world_cloud, DrawLabelsOptions labels) {
  const Framed framed =
      framed_labels(surfaces, labelling, options, nullptr, T_world_cloud, std::move(labels));
  return draw_outlines(framed.drawing, framed.view, options.render);
}

}  // namespace scanchor
