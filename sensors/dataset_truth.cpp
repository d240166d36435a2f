#include "sensors/dataset_truth.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string_view>

#include "core/json.hpp"
#include "scenes/relations.hpp"

namespace scanchor {
namespace {

// Written as text: a floor of rooms has 36,000 relations, and a tree of JSON values for them costs
// more than finding them. Numbers are the shortest that read back to the same bits.

template <class V>
void vector_text(std::string& text, const char* name, const V& v) {
  fmt::format_to(std::back_inserter(text), ",\"{}\":[", name);
  for (Eigen::Index i = 0; i < v.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{}{}", i == 0 ? "" : ",", v[i]);
  text += ']';
}

/// A string with its quotes.
std::string json_string(std::string_view word) {
  return Json(word).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string faces_json(const Scene& scene,
                       const std::vector<std::vector<FaceVisibility>>& visibility) {
  const std::vector<FaceAddress> faces = all_faces(scene);
  std::vector<std::string> seen(faces.size());
  for (std::size_t scan = 0; scan < visibility.size(); ++scan) {
    for (const auto& v : visibility[scan]) {
      if (v.face < 0 || static_cast<std::size_t>(v.face) >= faces.size()) continue;
      std::string& list = seen[static_cast<std::size_t>(v.face)];
      fmt::format_to(std::back_inserter(list),
                     "{}{{\"scan\":{},\"points\":{},\"visible_fraction\":{}}}",
                     list.empty() ? "" : ",", scan, v.points, v.visible_fraction);
    }
  }
  // One face a line: thousands of them stay readable.
  std::string text = "{\"faces\": [\n";
  text.reserve(400 * faces.size() + 64);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Instance& instance = scene.instances[static_cast<std::size_t>(faces[i].instance)];
    const Part& part = instance.parts[static_cast<std::size_t>(faces[i].part)];
    const Face& face = part.faces[static_cast<std::size_t>(faces[i].face)];
    fmt::format_to(std::back_inserter(text),
                   "{{\"face\":{},\"instance\":{},\"class\":{},\"part\":{},\"part_name\":{},"
                   "\"name\":{},\"planar\":{}",
                   i, instance.id, json_string(class_info(instance.class_id).name), faces[i].part,
                   json_string(part.name), json_string(face.name), face.planar);
    if (face.planar) {
      const WorldFace world = world_face(scene, faces[i]);
      vector_text(text, "center", world.center);
      vector_text(text, "normal", world.normal);
      vector_text(text, "axis", world.axis);
      vector_text(text, "size", world.size);
    }
    fmt::format_to(std::back_inserter(text), ",\"area\":{},\"scans\":[{}]}}{}\n", face.area,
                   seen[i], i + 1 < faces.size() ? "," : "");
  }
  return text + "]}\n";
}

std::string relations_json(const Scene& scene) {
  const std::vector<RelationFact> facts = instance_relations(scene);
  std::string text = "{\"relations\": [";
  text.reserve(110 * facts.size() + 64);
  bool first = true;
  for (const RelationFact& fact : facts) {
    fmt::format_to(std::back_inserter(text),
                   "{}\n{{\"relation\":\"{}\",\"a\":{},\"b\":{},\"margin\":{},\"value\":{}}}",
                   first ? "" : ",", relation_name(fact.relation),
                   scene.instances[static_cast<std::size_t>(fact.a)].id,
                   scene.instances[static_cast<std::size_t>(fact.b)].id, fact.value.margin,
                   fact.value.value);
    first = false;
  }
  return text + "\n]}\n";
}

std::vector<FaceVisibility> read_face_visibility(const std::filesystem::path& path,
                                                 std::size_t scan) {
  const Json json = read_json(path);
  const JsonReader faces = JsonReader(json, path.string()).at("faces");
  std::vector<FaceVisibility> result;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const JsonReader face = faces.at(i);
    const JsonReader scans = face.at("scans");
    for (std::size_t k = 0; k < scans.size(); ++k) {
      const JsonReader entry = scans.at(k);
      if (entry.at("scan").natural() != scan) continue;
      result.push_back({static_cast<std::int32_t>(face.at("face").integer()),
                        static_cast<std::int32_t>(entry.at("points").integer()),
                        entry.at("visible_fraction").number_in(0.0, 1.0)});
    }
  }
  return result;
}

}  // namespace scanchor
