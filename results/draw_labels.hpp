#pragma once
// What reasoning says, as a drawing: surfaces in the colour of their class, groups as boxes,
// relations as arrows, names as text.

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "results/drawing.hpp"

namespace scanchor {

struct DrawLabelsOptions {
  bool names = true;
  bool groups = true;       ///< boxes around groups
  bool unknown = false;     ///< also name what is unknown or ambiguous
  bool stuff_names = true;  ///< also name floor, walls and ceiling
  /// Arrows for the clauses of the proof of this entity, to the things they were satisfied on; -1:
  /// none; -2: of all named things.
  std::int32_t relations_of = -1;
  Eigen::Vector3d towards_eye = Eigen::Vector3d::Zero();  ///< as DrawSurfacesOptions::towards_eye
  std::uint8_t opacity = 185;
};

/// In the cloud's frame. The legend counts the things of each class.
Drawing draw_labels(const Surfaces& surfaces, const Labelling& labelling,
                    const DrawLabelsOptions& options = {});

/// The class list's colour of a label or a synonym; grey for "unknown", a steady colour of its own
/// for any other word.
Color color_of_label(const std::string& label);

/// "desk 0.97".
std::string label_text(const Entity& entity);

}  // namespace scanchor
