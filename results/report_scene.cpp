#include "results/report_scene.hpp"

#include <cmath>

#include "core/json.hpp"
#include "eval/evaluate.hpp"
#include "results/draw_surfaces.hpp"
#include "results/triangulate.hpp"

namespace scanchor {
namespace {

std::int64_t millimetres(double metres) { return std::llround(1e3 * metres); }

void push_mm(Json& list, const Eigen::Vector3d& p) {
  for (int c = 0; c < 3; ++c) list.push_back(millimetres(p[c]));
}

Json mm(const Eigen::Vector3d& p) {
  Json list = Json::array();
  push_mm(list, p);
  return list;
}

/// Four digits are enough to read, and keep the page small.
double short_number(double value) {
  return std::isfinite(value) ? std::round(value * 1e4) / 1e4 : 0.0;
}

Json surface_json(const Surface& surface, std::int32_t entity, const Eigen::Isometry3d& T) {
  Json json = Json::object();
  json["id"] = surface.id;
  json["entity"] = entity;
  json["text"] = feature_text(surface);
  json["points"] = surface.inliers.size();
  json["area"] = short_number(surface.area.value);
  const Eigen::Vector3d normal = T.linear() * surface.plane.normal;
  json["normal"] =
      Json::array({short_number(normal.x()), short_number(normal.y()), short_number(normal.z())});
  Json vertices = Json::array();
  Json triangles = Json::array();
  Json rings = Json::array();
  int base = 0;
  for (const Polygon& polygon : surface.polygons) {
    std::vector<Ring> all = {polygon.outer};
    all.insert(all.end(), polygon.holes.begin(), polygon.holes.end());
    for (const Eigen::Vector3i& t : triangulate(all)) {
      for (int k = 0; k < 3; ++k) triangles.push_back(base + t[k]);
    }
    for (const Ring& ring : all) {
      for (const Eigen::Vector2d& p : ring) {
        push_mm(vertices, T * (surface.T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0)));
      }
      rings.push_back(ring.size());
      base += int(ring.size());
    }
  }
  json["vertices"] = std::move(vertices);
  json["triangles"] = std::move(triangles);
  json["rings"] = std::move(rings);
  return json;
}

Json clause_json(const ProofClause& clause) {
  Json json = Json::object();
  json["text"] = clause.text;
  json["likelihood"] = short_number(clause.likelihood);
  json["background"] = short_number(clause.background);
  if (!clause.unit.empty()) {
    json["measured"] = short_number(clause.measured);
    json["sigma"] = short_number(clause.sigma);
    json["unit"] = clause.unit;
  }
  if (!clause.targets.empty()) json["targets"] = clause.targets;
  return json;
}

Json entity_json(const Entity& entity, const Eigen::Isometry3d& T) {
  Json json = Json::object();
  json["id"] = entity.id;
  json["label"] = entity.label;
  json["probability"] = short_number(entity.probability);
  const auto class_id = class_of_label(entity.label);
  json["class"] = class_id ? *class_id : unlabelled;
  Json classes = Json::array();
  for (const ClassProbability& one : entity.classes) {
    if (classes.size() >= 6) break;
    classes.push_back(Json::array({one.name, short_number(one.probability)}));
  }
  json["classes"] = std::move(classes);
  Json proof = Json::array();
  for (const ProofClause& clause : entity.proof) proof.push_back(clause_json(clause));
  json["proof"] = std::move(proof);
  json["surfaces"] = entity.surfaces;
  if (!entity.members.empty()) json["members"] = entity.members;
  json["center"] = mm(T * entity.center);
  json["size"] = mm(entity.size);
  const Eigen::Isometry3d pose = T * entity.pose;
  Json axes = Json::array();
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) axes.push_back(short_number(pose.linear()(r, c)));
  }
  json["axes"] = std::move(axes);
  json["box"] = mm(pose.translation());
  json["area"] = short_number(entity.area);
  return json;
}

/// The turn that takes the labelling's up to z.
Eigen::Isometry3d upright(const Eigen::Vector3d& up) {
  const Eigen::Vector3d axis = up.cross(Eigen::Vector3d::UnitZ());
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  if (axis.norm() > 1e-12) {
    T.rotate(Eigen::AngleAxisd(std::atan2(axis.norm(), up.z()), axis.normalized()));
  } else if (up.z() < 0.0) {
    T.rotate(Eigen::AngleAxisd(std::acos(-1.0), Eigen::Vector3d::UnitX()));
  }
  return T;
}

}  // namespace

std::string report_scene(const std::string& name, const Scan& scan, const Surfaces& surfaces,
                         const Labelling& labelling, std::size_t most_points) {
  const Eigen::Isometry3d T = upright(labelling.up);
  const std::size_t count = scan.cloud.size();
  const std::size_t step =
      most_points == 0 ? count + 1 : 1 + (count > 0 ? (count - 1) / most_points : 0);
  const PointPrediction prediction = predict_points(surfaces, labelling);
  const bool with_truth = scan.truth.size() == count;
  Json json = Json::object();
  json["name"] = name;
  json["all_points"] = count;
  Json points = Json::array();
  Json truth = Json::array();
  Json said = Json::array();
  Json plane = Json::array();
  for (std::size_t i = 0; i < count; i += step) {
    if (!scan.cloud.points[i].allFinite()) continue;
    push_mm(points, T * scan.cloud.points[i]);
    if (with_truth) truth.push_back(scan.truth.class_id[i]);
    said.push_back(i < prediction.class_id.size() ? prediction.class_id[i] : unlabelled);
    plane.push_back(i < surfaces.plane_of_point.size() ? surfaces.plane_of_point[i] : -1);
  }
  json["points"] = std::move(points);
  if (with_truth) json["truth"] = std::move(truth);
  json["said"] = std::move(said);
  json["plane"] = std::move(plane);
  Json faces = Json::array();
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s) {
    const std::int32_t entity =
        s < labelling.entity_of_surface.size() ? labelling.entity_of_surface[s] : -1;
    faces.push_back(surface_json(surfaces.surfaces[s], entity, T));
  }
  json["surfaces"] = std::move(faces);
  Json entities = Json::array();
  for (const Entity& entity : labelling.entities) entities.push_back(entity_json(entity, T));
  json["entities"] = std::move(entities);
  Json sensors = Json::array();
  for (const Eigen::Vector3d& p : surfaces.sensor_positions) push_mm(sensors, T * p);
  json["sensors"] = std::move(sensors);
  json["ontology"] = labelling.ontology;
  return json.dump();
}

}  // namespace scanchor
