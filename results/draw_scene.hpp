#pragma once
// A scene as a drawing: solid, shaded, opened towards the viewer like a doll's house.

#include "results/drawing.hpp"
#include "scenes/scene.hpp"

namespace scanchor {

enum class SceneColor { material, class_id, instance };

struct DrawSceneOptions {
  SceneColor color = SceneColor::class_id;
  /// Unit vector from the room towards the eye. Ceilings, walls seen from behind and flat things
  /// that hang on those are left out. Zero: everything is drawn, for a view from inside.
  Eigen::Vector3d towards_eye = Eigen::Vector3d(-0.394, -0.630, 0.669);
  bool edges = true;   ///< thin lines where faces meet
  bool names = false;  ///< a label for each thing
  bool sensor = true;  ///< a mark at each sensor pose
};

/// Unit vector towards an eye at that azimuth and elevation, as framed_view() takes them.
Eigen::Vector3d towards_eye(double azimuth_deg, double elevation_deg);

/// In the frame "world". The legend lists the classes that are there, most seen first.
/// Deterministic.
Drawing draw_scene(const Scene& scene, const DrawSceneOptions& options = {});

/// Every room of the scene moved apart from the middle by `gap` times its size: a floor of rooms
/// exploded.
Drawing explode(const std::vector<Drawing>& rooms, double gap = 0.25);

}  // namespace scanchor
