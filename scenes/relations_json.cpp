// truth.json: docs/reference/scene-format.md, "Truth".

#include "core/json.hpp"
#include "scenes/relations.hpp"

namespace scanchor {
namespace {

Json facts_json(const std::vector<RelationFact>& facts) {
  Json list = Json::array();
  for (const auto& fact : facts) {
    list.push_back({{"a", fact.a},
                    {"relation", relation_name(fact.relation)},
                    {"b", fact.b},
                    {"margin", fact.value.margin},
                    {"value", fact.value.value}});
  }
  return list;
}

}  // namespace

nlohmann::ordered_json truth_to_json(const Scene& scene, const RelationQuery& query) {
  Json json = {{"format", "scanchor truth 1"}, {"name", scene.name}};
  Json faces = Json::array();
  const auto groups = coplanar_groups(scene);
  const auto addresses = all_faces(scene);
  for (std::size_t f = 0; f < addresses.size(); ++f) {
    const FaceAddress& a = addresses[f];
    const Instance& instance = scene.instances[static_cast<std::size_t>(a.instance)];
    const Part& part = instance.parts[static_cast<std::size_t>(a.part)];
    const Face& face = part.faces[static_cast<std::size_t>(a.face)];
    Json row = {{"face", f},
                {"instance", instance.id},
                {"class", class_info(instance.class_id).name},
                {"part", part.name},
                {"name", face.name},
                {"planar", face.planar},
                {"area", face.area}};
    if (face.planar) {
      const WorldFace world = world_face(scene, a);
      row["center"] = to_json(world.center);
      row["normal"] = to_json(world.normal);
      row["offset"] = world.normal.dot(world.center);
      row["axis"] = to_json(world.axis);
      row["size"] = to_json(world.size);
      const double rectangle = world.size.x() * world.size.y();
      row["rectangularness"] = rectangle > 0 ? world.area / rectangle : 0.0;
      row["plane"] = groups[f];
    }
    faces.push_back(row);
  }
  json["faces"] = faces;
  json["face_relations"] = facts_json(face_relations(scene, query));
  Json things = facts_json(instance_relations(scene, query));
  for (auto& row : things) {
    // Things go by their ids, faces by their numbers.
    row["a"] = scene.instances[row["a"].get<std::size_t>()].id;
    row["b"] = scene.instances[row["b"].get<std::size_t>()].id;
  }
  json["instance_relations"] = things;
  return json;
}

}  // namespace scanchor
