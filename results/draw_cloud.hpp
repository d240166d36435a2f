#pragma once
// A cloud as a drawing, coloured by what its points carry or what was made of them.

#include <string>
#include <vector>

#include "cloud/point_cloud.hpp"
#include "perception/surface.hpp"
#include "results/drawing.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

enum class CloudColor {
  plain,        ///< one dark colour
  height,       ///< z above the lowest point [m]
  intensity,    ///< field "intensity"
  range_error,  ///< measured minus true range [m]: field "true_range"
  flags,        ///< mixed, ghost, behind glass, out of range: field "flags"
  class_id,     ///< field "label" (or "class")
  instance,     ///< field "instance"
  plane,        ///< field "plane"; -1 is grey
};

struct DrawCloudOptions {
  CloudColor color = CloudColor::height;
  double point_px = 2.2;  ///< least diameter on the picture
  double point_m =
      -1.0;  ///< [m] diameter in space; 0: fixed on the picture; -1: closes the usual gap
  /// One a point: the normal of the wall, floor or ceiling it lies on; zero: of something else.
  /// Empty: unknown.
  std::vector<Eigen::Vector3d> sheet_normals;
  /// Points whose sheet turns its back to this direction (from the room towards the eye) are left
  /// out. Zero: none.
  Eigen::Vector3d towards_eye = Eigen::Vector3d::Zero();
};

/// In the cloud's frame. Non-finite points are left out and counted in the subtitle. Throws
/// Error(wrong_usage) for a colour whose field the cloud does not have, naming those that it has.
Drawing draw_cloud(const PointCloud& cloud, const DrawCloudOptions& options = {});

/// Typical distance between neighbouring points [m]: root of (occupied area / points), the area
/// counted in cells of 5 cm (or more for clouds that are kilometres wide).
double typical_spacing(const PointCloud& cloud);

/// The cloud with "plane" set from the surfaces.
PointCloud with_planes(const PointCloud& cloud, const Surfaces& surfaces);

/// Normals for DrawCloudOptions::sheet_normals: of surfaces of at least `least_area` [m2]. In the
/// cloud's frame.
std::vector<Eigen::Vector3d> sheets_of_surfaces(const Surfaces& surfaces, double least_area = 2.0);
/// The same from the truth: points on walls, floors and ceilings.
std::vector<Eigen::Vector3d> sheets_of_scan(const Scan& scan, const Scene& scene);

}  // namespace scanchor
