#pragma once
// What speaks for a direction being up: how many things stand upright on it, on what, and seen from
// where.

#include <vector>

#include "perception/surface.hpp"

namespace scanchor {

/// What a direction has for it [counts of things, each with one voice however large it is].
struct UpEvidence {
  double aligned = 0.0;   ///< parallel or orthogonal to it: turned furniture is still upright
  double standing = 0.0;  ///< what begins at the lowest plane and ends below the highest
  double hanging = 0.0;   ///< what begins above the lowest plane and ends at the highest
  double tops = 0.0;  ///< [m2] levels between floor and ceiling seen from above, 1 m2 each at most
  double undersides = 0.0;      ///< [m2] the same, seen from below
  bool height_of_room = false;  ///< lowest and highest plane lie 2 to 4 m apart
  bool sensor_height = false;   ///< the sensor is 0.2 to 2 m above the lowest plane

  /// ln of the weight of this reading; differences are log odds. The weights are those of a
  /// conditional logistic regression (docs/why/semantics.md says on which rooms).
  [[nodiscard]] double score() const;
};

UpEvidence up_evidence(const Surfaces& surfaces, const Eigen::Vector3d& up);

struct UpCandidate {
  Eigen::Vector3d up;
  double probability;  ///< among the candidates
};

/// Directions that may be up and their opposites, the likeliest first: normals of large surfaces,
/// directions across two of them, and the one that frames usually have (ROS REP 103).
std::vector<UpCandidate> up_candidates(const Surfaces& surfaces);

}  // namespace scanchor
