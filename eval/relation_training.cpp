#include "eval/relation_training.hpp"

#include "eval/plane_relations.hpp"
#include "eval/planes.hpp"
#include "eval/truth.hpp"
#include "reasoning/levelled.hpp"

namespace scanchor {

namespace {

constexpr double near_miss = -0.2;  // margin of a pair that nearly holds
constexpr double plain_no = 0.002;  // likelihood below which a pair teaches nothing

}  // namespace

RelationScene relation_scene(const Scan& scan, const Scene& scene, const Protocol& protocol,
                             const PerceiveOptions& perceive_options,
                             const ReasonOptions& reason_options) {
  RelationScene made;
  const ScanTruth truth = truth_of(scan, &scene, protocol);
  made.surfaces = perceive(scan.cloud, perceive_options);
  PlaneMatch match;
  score_planes(truth.plane, truth.ignored_planes, made.surfaces.plane_of_point, protocol, &match);
  const Levelled levelled = level(made.surfaces, reason_options);
  made.R_level_cloud = levelled.R_level_cloud;
  made.items = make_items(made.surfaces, made.R_level_cloud);
  made.around = levelled.around;

  // The usual constants, so that what is looked at does not depend on the file in use.
  static const RelationModel usual;
  use_model(made, usual);

  const std::size_t count = made.surfaces.surfaces.size();
  for (std::size_t p = 0; p < truth.planes.size() && p < match.region_of_truth.size(); ++p) {
    const std::int32_t surface = match.region_of_truth[p];
    if (surface < 0 || static_cast<std::size_t>(surface) >= count || !truth.planes[p].has_geometry)
      continue;
    made.normals.push_back({surface, truth.planes[p].normal});
  }
  for (const auto& pair : face_pairs(scan, scene, truth, match, count, protocol)) {
    RelationTerm term;
    term.relation = pair.claim;
    const double said = relate(term, made.items[static_cast<std::size_t>(pair.surface_a)],
                               made.items[static_cast<std::size_t>(pair.surface_b)], made.around)
                            .likelihood;
    if (pair.margin >= near_miss || said >= plain_no)
      made.samples.push_back({pair.claim, pair.surface_a, pair.surface_b, pair.margin >= 0.0});
  }
  made.surfaces.plane_of_point = {};
  for (auto& surface : made.surfaces.surfaces) {
    surface.inliers = {};
    surface.polygons = {};
  }
  return made;
}

}  // namespace scanchor
