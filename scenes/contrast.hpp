#pragma once
// Minimally contrastive pairs (the idea of Goyal et al., "Rel3D", NeurIPS 2020): two scenes that
// differ in one relation between two things and in nothing else. A reasoner that answers both alike
// does not see that relation.

#include <cstdint>

#include "scenes/relations.hpp"
#include "scenes/scene.hpp"

namespace scanchor {

struct ContrastPair {
  SpatialRelation relation;
  Scene with;         ///< a relation b holds clearly
  Scene without;      ///< it clearly does not; the scenes differ in thing `a` alone
  std::size_t a = 0;  ///< index of the subject in both scenes' instances
  std::size_t b = 0;  ///< index of the target
  Eigen::Vector3d viewpoint =
      Eigen::Vector3d::Zero();  ///< for left, right, front, behind: the sensor's place
};

/// A plain room with a target, a subject and a few bystanders drawn from the seed. Margins are at
/// least `clear` on both sides. All other relations between the two keep their truth value, up to
/// those that follow from the relation itself (its inverse; on and supports, above and below with
/// each other where the definition makes one imply the other). Deterministic.
ContrastPair contrastive_pair(SpatialRelation relation, std::uint64_t seed, double clear = 0.15);

}  // namespace scanchor
