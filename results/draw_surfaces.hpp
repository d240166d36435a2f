#pragma once
// What perception found, as a drawing: polygons with holes, fitted rectangles, shadows along the
// outline.

#include "perception/surface.hpp"
#include "results/drawing.hpp"

namespace scanchor {

struct DrawSurfacesOptions {
  bool polygons = true;
  bool rectangles = true;      ///< dashed: the fitted rectangle; thin around it: its 95 % interval
  bool features = false;       ///< a label with A, E and R on each surface
  bool occlusion = true;       ///< outline edges that border a shadow in another colour
  double least_area = 0.0;     ///< [m2] smaller ones are left out
  std::uint8_t opacity = 150;  ///< of the filling
  /// Surfaces of at least 2 m2 whose normal points away from this direction are left out. Zero:
  /// none.
  Eigen::Vector3d towards_eye = Eigen::Vector3d::Zero();
  /// One a surface; empty: by number.
  std::vector<Color> colors;
};

/// In the cloud's frame.
Drawing draw_surfaces(const Surfaces& surfaces, const DrawSurfacesOptions& options = {});

/// Whether the surface would be left out for a viewer in that direction.
bool turned_away(const Surface& surface, const Eigen::Vector3d& towards_eye);

/// "A 1.28 m², E 1.60 m, R 0.98".
std::string feature_text(const Surface& surface);

}  // namespace scanchor
