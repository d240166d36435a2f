// All relations of a scene: between faces, between things, and which faces are one plane.

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/math.hpp"
#include "scenes/box_distance.hpp"
#include "scenes/relations.hpp"

namespace scanchor {
namespace {

Eigen::Vector3d viewpoint_of(const Scene& scene, const RelationQuery& query) {
  if (query.viewpoint) return *query.viewpoint;
  if (!scene.sensor_poses.empty()) return scene.sensor_poses.front().translation();
  return scene.bounds.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(scene.bounds.center());
}

std::vector<RelationFact> relations_between(const std::vector<RelationBody>& bodies,
                                            const std::vector<std::int32_t>& ids,
                                            const RelationQuery& query,
                                            const Eigen::Vector3d& viewpoint) {
  std::vector<SpatialRelation> wanted = query.relations;
  if (wanted.empty()) {
    for (std::size_t r = 0; r < relation_count; ++r)
      wanted.push_back(static_cast<SpatialRelation>(r));
  }
  std::vector<RelationFact> facts;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      if (i == j) continue;
      for (const SpatialRelation relation : wanted) {
        if (is_symmetric(relation) && j < i) continue;
        const RelationMargin value =
            relate(bodies[i], bodies[j], relation, viewpoint, query.tolerances, query.least_margin);
        if (value.margin >= query.least_margin) facts.push_back({relation, ids[i], ids[j], value});
      }
    }
  }
  // Of all that could carry a thing, the highest does: a book on a shelf board is not on the board
  // below.
  std::vector<double> height_of(facts.size(), 0.0);
  const auto body_of = [&](std::int32_t id) -> const RelationBody& {
    return bodies[static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) -
                                           ids.begin())];
  };
  const auto carrier_height = [&](const RelationBody& a, const RelationBody& b) {
    double best = -std::numeric_limits<double>::infinity();
    for (const auto& face : b.level_faces) {
      const double gap = a.z_low - face.center.z();
      if (gap >= query.tolerances.on_low && gap <= query.tolerances.on_high)
        best = std::max(best, face.center.z());
    }
    return best;
  };
  std::vector<std::pair<std::int32_t, double>> top;  // thing -> highest carrier
  for (std::size_t k = 0; k < facts.size(); ++k) {
    const RelationFact& f = facts[k];
    if (f.relation != SpatialRelation::on && f.relation != SpatialRelation::supports) continue;
    const std::int32_t thing = f.relation == SpatialRelation::on ? f.a : f.b;
    const std::int32_t carrier = f.relation == SpatialRelation::on ? f.b : f.a;
    height_of[k] = carrier_height(body_of(thing), body_of(carrier));
    if (!f.value.holds()) continue;
    const auto found =
        std::find_if(top.begin(), top.end(), [&](const auto& item) { return item.first == thing; });
    if (found == top.end()) {
      top.emplace_back(thing, height_of[k]);
    } else {
      found->second = std::max(found->second, height_of[k]);
    }
  }
  std::vector<RelationFact> kept;
  for (std::size_t k = 0; k < facts.size(); ++k) {
    const RelationFact& f = facts[k];
    if ((f.relation == SpatialRelation::on || f.relation == SpatialRelation::supports) &&
        f.value.holds()) {
      const std::int32_t thing = f.relation == SpatialRelation::on ? f.a : f.b;
      const auto found = std::find_if(top.begin(), top.end(),
                                      [&](const auto& item) { return item.first == thing; });
      if (found != top.end() && height_of[k] < found->second) continue;
    }
    kept.push_back(f);
  }
  return kept;
}

}  // namespace

std::vector<RelationFact> face_relations(const Scene& scene, const RelationQuery& query) {
  std::vector<RelationBody> bodies;
  std::vector<std::int32_t> ids;
  const auto faces = all_faces(scene);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face& face = scene.instances[static_cast<std::size_t>(faces[f].instance)]
                           .parts[static_cast<std::size_t>(faces[f].part)]
                           .faces[static_cast<std::size_t>(faces[f].face)];
    if (!face.planar || face.area < query.least_area) continue;
    bodies.push_back(face_body(scene, faces[f], query.tolerances));
    ids.push_back(static_cast<std::int32_t>(f));
  }
  return relations_between(bodies, ids, query, viewpoint_of(scene, query));
}

std::vector<RelationFact> instance_relations(const Scene& scene, const RelationQuery& query) {
  std::vector<RelationBody> bodies;
  std::vector<std::int32_t> ids;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    bodies.push_back(instance_body(scene, i, query.tolerances));
    ids.push_back(static_cast<std::int32_t>(i));
  }
  return relations_between(bodies, ids, query, viewpoint_of(scene, query));
}

std::vector<std::int32_t> coplanar_groups(const Scene& scene, double gap, double distance,
                                          double angle) {
  const auto faces = all_faces(scene);
  std::vector<RelationBody> bodies(faces.size());
  std::vector<bool> planar(faces.size());
  std::vector<std::int32_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Part& part = scene.instances[static_cast<std::size_t>(faces[f].instance)]
                           .parts[static_cast<std::size_t>(faces[f].part)];
    planar[f] = part.faces[static_cast<std::size_t>(faces[f].face)].planar &&
                part.faces[static_cast<std::size_t>(faces[f].face)].area > 0;
    if (planar[f]) bodies[f] = face_body(scene, faces[f]);
  }
  const auto root = [&](std::int32_t i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  const double cos_angle = portable_sincos(radians(angle)).cos;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!planar[i]) continue;
    const Eigen::AlignedBox3d outer = bounds_of(bodies[i].boxes[0]);
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (!planar[j] || bodies[i].face.normal.dot(bodies[j].face.normal) < cos_angle) continue;
      const Eigen::Vector3d d = bodies[i].face.center - bodies[j].face.center;
      if (std::abs(bodies[i].face.normal.dot(d)) > distance ||
          std::abs(bodies[j].face.normal.dot(d)) > distance)
        continue;
      if (outer.exteriorDistance(bounds_of(bodies[j].boxes[0])) > gap) continue;
      if (box_distance(bodies[i].boxes[0], bodies[j].boxes[0]) > gap) continue;
      const auto a = root(static_cast<std::int32_t>(i));
      const auto b = root(static_cast<std::int32_t>(j));
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<std::int32_t> group(faces.size(), -1);
  std::vector<std::int32_t> number(faces.size(), -1);
  std::int32_t next = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!planar[f]) continue;
    auto& n = number[static_cast<std::size_t>(root(static_cast<std::int32_t>(f)))];
    if (n < 0) n = next++;
    group[f] = n;
  }
  return group;
}

}  // namespace scanchor
