#pragma once
// What a scan whose scene is known teaches about relations: for `scanchor fit-relations`.

#include "eval/protocol.hpp"
#include "perception/perceive.hpp"
#include "reasoning/reason.hpp"
#include "reasoning/relation_fit.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

/// The planes of a scan that were found correctly with their true normals, and for all pairs of
/// them whether each relation (scored_relations) truly holds. Pairs that neither hold, nor nearly
/// do, nor are likely by the constants in use are left out: they say nothing. The surfaces come
/// without their points and outlines.
RelationScene relation_scene(const Scan& scan, const Scene& scene, const Protocol& protocol,
                             const PerceiveOptions& perceive, const ReasonOptions& reason);

}  // namespace scanchor
