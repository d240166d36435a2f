#pragma once
// The relations between measured planes, held against the exact ones between the faces of the
// scene.

#include <vector>

#include "eval/planes.hpp"
#include "eval/relations.hpp"
#include "eval/truth.hpp"
#include "perception/surface.hpp"
#include "reasoning/ontology.hpp"
#include "scenes/relations.hpp"

namespace scanchor {

/// Two lists for score_relations. Ids are planes of the truth.
struct PlaneRelations {
  std::vector<NamedRelation> truth, claims;
};

/// What is held against the truth: the relations that the reasoner and the scene both define on
/// faces. The inverse of a listed one (below, supports, right of, behind) says nothing new.
const std::vector<SpatialRelation>& scored_relations();

/// Two planes that were found, and how clearly a relation holds between their exact faces.
struct FacePair {
  SpatialRelation truth;
  Relation claim;                     ///< the reasoner's word for it
  std::int32_t plane_a, plane_b;      ///< of the truth
  std::int32_t surface_a, surface_b;  ///< that found them
  double margin;                      ///< RelationMargin
};

/// All pairs that plane_relations looks at, relation by relation, likely or not.
std::vector<FacePair> face_pairs(const Scan& scan, const Scene& scene, const ScanTruth& truth,
                                 const PlaneMatch& match, std::size_t surfaces,
                                 const Protocol& protocol);

/// Relations between planes that were found correctly (`match`, at Protocol::geometry_tolerance):
/// what was not found has been counted as missed among the planes already. A truth of several
/// faces counts where one of them holds most of its area; relations that compare sizes or middles
/// count where both faces were seen at least `full_view`. The truth is the scene's exact relation
/// of the two faces; within a fifth of its tolerance it is borderline. The claim is the reasoner's
/// likelihood of the same relation between the two measured surfaces. `up`: unit, in the frame of
/// the cloud, as the reasoner used it; `up_sigma` [rad].
PlaneRelations plane_relations(const Scan& scan, const Scene& scene, const ScanTruth& truth,
                               const PlaneMatch& match, const Surfaces& surfaces,
                               const Eigen::Vector3d& up, double up_sigma,
                               const Protocol& protocol);

}  // namespace scanchor
