#include "eval/plane_relations.hpp"

#include <array>
#include <utility>

#include "reasoning/item.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {
namespace {

// Margins are (tolerance - deviation) / tolerance: nearer to the limit than that is borderline.
constexpr double borderline_margin = 0.2;
// Claims below are plain "no" and need no row.
constexpr double least_probability = 0.05;
// A plane of several faces is compared by its largest, where that holds most of it.
constexpr double main_face_share = 0.8;

struct Definition {
  SpatialRelation truth;
  Relation claim;
  bool whole;  // compares sizes or middles: both faces must have been seen whole
};

constexpr std::array<Definition, 10> definitions = {{
    {SpatialRelation::parallel, Relation::parallel, false},
    {SpatialRelation::orthogonal, Relation::orthogonal, false},
    {SpatialRelation::coplanar, Relation::coplanar, false},
    {SpatialRelation::above, Relation::above, false},
    {SpatialRelation::on, Relation::on, false},
    {SpatialRelation::near, Relation::near, false},
    {SpatialRelation::same_size, Relation::same_size, true},
    {SpatialRelation::vertically_aligned, Relation::aligned, true},
    {SpatialRelation::left_of, Relation::left_of, true},
    {SpatialRelation::in_front_of, Relation::in_front_of, true},
}};

struct FoundPlane {
  std::int32_t plane = -1;    // of the truth
  std::int32_t surface = -1;  // that found it
  bool whole = false;
  RelationBody body;
};

// The face that stands for the plane, or -1.
std::int32_t main_face(const PlaneTruth& plane, const Scene& scene,
                       const std::vector<FaceAddress>& addresses) {
  std::int32_t largest = -1;
  double best = 0.0;
  for (const auto id : plane.faces) {
    const double area = world_face(scene, addresses[static_cast<std::size_t>(id)]).area;
    if (area > best) {
      best = area;
      largest = id;
    }
  }
  return best >= main_face_share * plane.area ? largest : -1;
}

std::vector<FoundPlane> found_planes(const Scene& scene, const ScanTruth& truth,
                                     const PlaneMatch& match, std::size_t surfaces,
                                     const Protocol& protocol) {
  const auto addresses = all_faces(scene);
  std::vector<FoundPlane> found;
  for (std::size_t p = 0; p < truth.planes.size() && p < match.region_of_truth.size(); ++p) {
    const PlaneTruth& plane = truth.planes[p];
    const std::int32_t surface = match.region_of_truth[p];
    if (surface < 0 || static_cast<std::size_t>(surface) >= surfaces || !plane.has_geometry)
      continue;
    const std::int32_t face = main_face(plane, scene, addresses);
    if (face < 0) continue;
    found.push_back({static_cast<std::int32_t>(p), surface,
                     plane.visible_fraction >= protocol.full_view,
                     face_body(scene, addresses[static_cast<std::size_t>(face)])});
  }
  return found;
}

}  // namespace

const std::vector<SpatialRelation>& scored_relations() {
  static const std::vector<SpatialRelation> list = [] {
    std::vector<SpatialRelation> all;
    for (const auto& definition : definitions) all.push_back(definition.truth);
    return all;
  }();
  return list;
}

std::vector<FacePair> face_pairs(const Scan& scan, const Scene& scene, const ScanTruth& truth,
                                 const PlaneMatch& match, std::size_t surfaces,
                                 const Protocol& protocol) {
  const auto found = found_planes(scene, truth, match, surfaces, protocol);
  const Eigen::Vector3d viewpoint = scan.T_world_sensor.translation();
  std::vector<FacePair> pairs;
  for (const auto& definition : definitions) {
    const bool symmetric = is_symmetric(definition.truth);
    for (const auto& a : found) {
      if (definition.whole && !a.whole) continue;
      for (const auto& b : found) {
        if (a.plane == b.plane || (symmetric && b.plane < a.plane)) continue;
        if (definition.whole && !b.whole) continue;
        pairs.push_back({definition.truth, definition.claim, a.plane, b.plane, a.surface, b.surface,
                         relate(a.body, b.body, definition.truth, viewpoint).margin});
      }
    }
  }
  return pairs;
}

PlaneRelations plane_relations(const Scan& scan, const Scene& scene, const ScanTruth& truth,
                               const PlaneMatch& match, const Surfaces& surfaces,
                               const Eigen::Vector3d& up, double up_sigma,
                               const Protocol& protocol) {
  const std::vector<Item> items = make_items(surfaces, levelling(up));
  Surrounding around;
  around.up_sigma = up_sigma;
  around.viewpoint = Eigen::Vector3d::Zero();  // a scan's cloud has its sensor at the origin

  PlaneRelations lists;
  for (const auto& pair :
       face_pairs(scan, scene, truth, match, surfaces.surfaces.size(), protocol)) {
    RelationTerm term;
    term.relation = pair.claim;
    NamedRelation fact{std::string(relation_name(pair.truth)), pair.plane_a, pair.plane_b};
    if (pair.margin >= -borderline_margin) {
      fact.holds = pair.margin >= 0.0;
      fact.borderline = pair.margin < borderline_margin;
      lists.truth.push_back(fact);
    }
    fact.probability = relate(term, items[static_cast<std::size_t>(pair.surface_a)],
                              items[static_cast<std::size_t>(pair.surface_b)], around)
                           .likelihood;
    fact.holds = true;
    fact.borderline = false;
    if (fact.probability >= least_probability) lists.claims.push_back(std::move(fact));
  }
  return lists;
}

}  // namespace scanchor
