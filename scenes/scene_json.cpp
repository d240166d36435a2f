// Writing of scene.json: docs/reference/scene-format.md.

#include "core/file.hpp"
#include "core/json.hpp"
#include "scenes/scene.hpp"
#include "scenes/scene_format.hpp"

namespace scanchor {
namespace {

Json pose_json(const Eigen::Isometry3d& pose) {
  // Rows of the matrix, not a quaternion: they read back to the same bits.
  Json json = {{"position", to_json(Eigen::Vector3d(pose.translation()))}};
  if (pose.linear() != Eigen::Matrix3d::Identity()) {
    json["rotation"] = Json::array();
    for (int i = 0; i < 3; ++i)
      json["rotation"].push_back(to_json(Eigen::Vector3d(pose.linear().row(i))));
  }
  return json;
}

bool is_identity(const Eigen::Isometry3d& pose) {
  return pose.matrix() == Eigen::Isometry3d::Identity().matrix();
}

bool same_part(const Part& a, const Part& b) {
  if (a.vertices != b.vertices || a.triangles != b.triangles ||
      a.triangle_face != b.triangle_face || a.faces.size() != b.faces.size() ||
      a.convex != b.convex) {
    return false;
  }
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    const Face& f = a.faces[i];
    const Face& g = b.faces[i];
    if (f.name != g.name || f.planar != g.planar || f.center != g.center || f.normal != g.normal ||
        f.axis != g.axis || f.size != g.size || f.area != g.area) {
      return false;
    }
  }
  return true;
}

/// Centre and size, if the part is exactly what box_part makes of them.
bool as_box(const Part& part, Eigen::Vector3d& center, Eigen::Vector3d& size) {
  if (part.vertices.size() != 8 || part.faces.size() != 6 || part.faces[0].name != "top")
    return false;
  center = {part.faces[0].center.x(), part.faces[0].center.y(), part.faces[2].center.z()};
  const Face& top = part.faces[0];
  const Face& front = part.faces[2];
  const bool x_longer = top.axis.x() != 0.0;
  size.x() = x_longer ? top.size.x() : top.size.y();
  size.y() = x_longer ? top.size.y() : top.size.x();
  size.z() = front.axis.x() != 0.0 ? front.size.y() : front.size.x();
  return same_part(part, box_part(part.name, part.material, center, size));
}

Json part_json(const Scene& scene, const Part& part) {
  Json json = {{"name", part.name},
               {"material", scene.materials.at(static_cast<std::size_t>(part.material)).name}};
  if (!is_identity(part.T_instance_part)) json["pose"] = pose_json(part.T_instance_part);
  Eigen::Vector3d center;
  Eigen::Vector3d size;
  if (as_box(part, center, size)) {
    json["box"] = {{"center", to_json(center)}, {"size", to_json(size)}};
    return json;
  }
  json["convex"] = part.convex;
  Json faces = Json::array();
  for (const auto& face : part.faces) {
    Json row = {{"name", face.name}, {"planar", face.planar}, {"area", face.area}};
    if (face.planar) {
      row["center"] = to_json(face.center);
      row["normal"] = to_json(face.normal);
      row["axis"] = to_json(face.axis);
      row["size"] = to_json(face.size);
    }
    faces.push_back(row);
  }
  json["faces"] = faces;
  json["vertices"] = Json::array();
  for (const auto& v : part.vertices) json["vertices"].push_back(to_json(v));
  json["triangles"] = Json::array();
  for (const auto& t : part.triangles) json["triangles"].push_back({t[0], t[1], t[2]});
  json["triangle_face"] = part.triangle_face;
  return json;
}

/// Characters of what dump() would give; counting stops once they are more than `most`.
std::size_t flat_size(const Json& json, std::size_t most) {
  if (!json.is_structured()) return json.dump().size();
  std::size_t size = 1 + (json.empty() ? 1 : json.size());  // brackets and commas
  if (json.is_array()) {
    for (auto it = json.begin(); it != json.end() && size <= most; ++it)
      size += flat_size(*it, most);
  } else {
    for (auto it = json.begin(); it != json.end() && size <= most; ++it)
      size += it.key().size() + 3 + flat_size(*it, most);
  }
  return size;
}

/// Indented like dump(2), but what fits on one line stays there and long lists of numbers run on.
void print(const Json& json, std::size_t indent, std::string& out) {
  constexpr std::size_t width = 118;
  if (!json.is_structured() || flat_size(json, width) + indent <= width) {
    out += json.dump();
    return;
  }
  const std::string inner(indent + 2, ' ');
  const bool small = json.is_array() && !json[0].is_object();
  out += json.is_array() ? "[" : "{";
  std::size_t column = width;
  bool first = true;
  for (auto item = json.begin(); item != json.end(); ++item) {
    if (!first) out += ",";
    first = false;
    if (small) {
      const std::string text = item->dump();
      if (column + text.size() + 2 > width) {
        out += "\n" + inner;
        column = inner.size();
      } else {
        out += " ";
        ++column;
      }
      out += text;
      column += text.size() + 1;
      continue;
    }
    out += "\n" + inner;
    if (json.is_object()) out += Json(item.key()).dump() + ": ";
    print(*item, indent + 2, out);
  }
  out += "\n" + std::string(indent, ' ') + (json.is_array() ? "]" : "}");
}

}  // namespace

nlohmann::ordered_json scene_to_json(const Scene& scene) {
  Json json = {{"format", scene_format_name},
               {"name", scene.name},
               {"family", scene.family},
               {"seed", scene.seed}};
  json["materials"] = Json::array();
  for (const auto& m : scene.materials) {
    json["materials"].push_back({{"name", m.name},
                                 {"reflectance", m.reflectance},
                                 {"specular", m.specular},
                                 {"transmittance", m.transmittance},
                                 {"color", {m.color[0], m.color[1], m.color[2]}}});
  }
  json["instances"] = Json::array();
  for (const auto& instance : scene.instances) {
    Json row = {{"id", instance.id}, {"class", class_info(instance.class_id).name}};
    if (!instance.kind.empty()) row["kind"] = instance.kind;
    if (!instance.variant.empty()) row["variant"] = instance.variant;
    if (!instance.parameters.empty()) row["parameters"] = instance.parameters;
    row["pose"] = pose_json(instance.T_world_instance);
    row["loose"] = instance.loose;
    row["mass"] = instance.mass;
    row["parts"] = Json::array();
    for (const auto& part : instance.parts) row["parts"].push_back(part_json(scene, part));
    json["instances"].push_back(row);
  }
  json["sensor_poses"] = Json::array();
  for (const auto& pose : scene.sensor_poses) json["sensor_poses"].push_back(pose_json(pose));
  if (!scene.bounds.isEmpty()) {
    json["bounds"] = {{"min", to_json(Eigen::Vector3d(scene.bounds.min()))},
                      {"max", to_json(Eigen::Vector3d(scene.bounds.max()))}};
  }
  return json;
}

void write_scene(const std::filesystem::path& path, const Scene& scene) {
  std::string text;
  print(scene_to_json(scene), 0, text);
  write_file(path, text + "\n");
}

}  // namespace scanchor
