#pragma once
// The pictures that most people want, in one call each: 1280 x 720 unless told otherwise.

#include <string>
#include <vector>

#include "results/draw_cloud.hpp"
#include "results/draw_labels.hpp"
#include "results/draw_scene.hpp"
#include "results/draw_surfaces.hpp"
#include "results/draw_svg.hpp"
#include "results/render.hpp"

namespace scanchor {

/// Where one stands: outside, straight above, level beside, or where the sensor stood.
enum class Viewpoint { perspective, top, side, sensor };

struct PictureOptions {
  RenderOptions render;
  Viewpoint view = Viewpoint::perspective;
  double azimuth_deg = -122.0;  ///< of the eye, counter-clockwise from +x
  double elevation_deg = 42.0;  ///< of the eye above the horizon; perspective only
  std::string title;            ///< empty: a plain one
};

/// The room, opened towards the viewer. The sensor stands at the scene's first pose.
Image picture_of_scene(const Scene& scene, const PictureOptions& options = {},
                       SceneColor color = SceneColor::class_id);
/// Several rooms on one floor, set apart.
Image picture_of_rooms(const std::vector<Scene>& scenes, const PictureOptions& options = {},
                       SceneColor color = SceneColor::class_id);
/// The scan in the world's frame; near walls and the ceiling are left out by the truth. Same view
/// as picture_of_scene().
Image picture_of_scan(const Scene& scene, const Scan& scan, const PictureOptions& options = {},
                      CloudColor color = CloudColor::class_id);
/// Any cloud; near walls and the ceiling are left out if surfaces are given. `T_world_cloud` turns
/// it into the frame of other pictures.
Image picture_of_cloud(const PointCloud& cloud, const PictureOptions& options = {},
                       CloudColor color = CloudColor::height, const Surfaces* surfaces = nullptr,
                       const Eigen::Isometry3d& T_world_cloud = Eigen::Isometry3d::Identity());
/// The polygons, rectangles and features that perception found.
Image picture_of_surfaces(const Surfaces& surfaces, const PictureOptions& options = {},
                          const Eigen::Isometry3d& T_world_cloud = Eigen::Isometry3d::Identity());
/// The same as outlines, for write_svg() (vector.hpp).
VectorPicture outlines_of_surfaces(
    const Surfaces& surfaces, const PictureOptions& options = {},
    const Eigen::Isometry3d& T_world_cloud = Eigen::Isometry3d::Identity());
/// The named things, over the faint points of the cloud if it is given.
Image picture_of_labels(const Surfaces& surfaces, const Labelling& labelling,
                        const PictureOptions& options = {}, const PointCloud* cloud = nullptr,
                        const Eigen::Isometry3d& T_world_cloud = Eigen::Isometry3d::Identity(),
                        DrawLabelsOptions labels = {});
/// The same as outlines, for write_svg(); without points.
VectorPicture outlines_of_labels(
    const Surfaces& surfaces, const Labelling& labelling, const PictureOptions& options = {},
    const Eigen::Isometry3d& T_world_cloud = Eigen::Isometry3d::Identity(),
    DrawLabelsOptions labels = {});

}  // namespace scanchor
