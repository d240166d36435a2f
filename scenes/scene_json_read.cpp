// Reading of scene.json: docs/reference/scene-format.md.

#include <set>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/import.hpp"
#include "scenes/materials.hpp"
#include "scenes/pose.hpp"
#include "scenes/scene.hpp"
#include "scenes/scene_format.hpp"
#include "scenes/shell.hpp"
#include "scenes/truth.hpp"

namespace scanchor {
namespace {

constexpr double largest = 1e4;  // [m] a scene is a room or a floor of a building

Eigen::Vector3d place_of(const JsonReader& reader) {
  const Eigen::Vector3d v = reader.vector3();
  if (v.cwiseAbs().maxCoeff() > largest) reader.fail("lies more than 10 km away");
  return v;
}

Eigen::Vector3d size_of(const JsonReader& reader) {
  const Eigen::Vector3d v = place_of(reader);
  for (int i = 0; i < 3; ++i) {
    if (!(v[i] > 0)) reader.fail("must be three sizes above 0, is " + reader.raw().dump());
  }
  return v;
}

Eigen::Isometry3d pose_of(const JsonReader& reader) {
  reader.only({"position", "rotation", "quaternion", "yaw_deg"});
  if (reader.has("quaternion")) return reader.pose();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (reader.has("position")) pose.translation() = place_of(reader.at("position"));
  if (reader.has("yaw_deg"))
    pose.linear() = rotation_about(2, radians(reader.at("yaw_deg").number()));
  if (reader.has("rotation")) {
    const JsonReader rows = reader.at("rotation");
    if (rows.size() != 3) rows.fail("must be three rows of three numbers");
    for (int i = 0; i < 3; ++i)
      pose.linear().row(i) = rows.at(static_cast<std::size_t>(i)).vector3();
    const Eigen::Matrix3d R = pose.linear();
    const double off = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (off > 1e-6 || R.determinant() < 0) rows.fail("is no rotation matrix");
  }
  return pose;
}

Material material_of(const JsonReader& reader) {
  reader.only({"name", "reflectance", "specular", "transmittance", "color"});
  Material material;
  material.name = reader.at("name").text();
  if (reader.has("reflectance")) material.reflectance = reader.at("reflectance").number_in(0, 1);
  if (reader.has("specular")) material.specular = reader.at("specular").number_in(0, 1);
  if (reader.has("transmittance"))
    material.transmittance = reader.at("transmittance").number_in(0, 1);
  if (reader.has("color")) {
    const JsonReader color = reader.at("color");
    if (color.size() != 3) color.fail("must be three numbers from 0 to 255");
    for (std::size_t k = 0; k < 3; ++k) {
      material.color[k] = static_cast<std::uint8_t>(color.at(k).number_in(0, 255));
    }
  }
  return material;
}

int material_index(const JsonReader& reader, Scene& scene) {
  if (!reader.has("material")) return use_material(scene, "melamine white");
  const JsonReader at = reader.at("material");
  try {
    return use_material(scene, at.text());
  } catch (const Error& error) {
    if (error.code() == ExitCode::bad_data) throw;
    at.fail(error.what());
  }
}

void read_mesh(const JsonReader& reader, Part& part) {
  const JsonReader vertices = reader.at("vertices");
  for (std::size_t i = 0; i < vertices.size(); ++i)
    part.vertices.push_back(place_of(vertices.at(i)));
  const JsonReader triangles = reader.at("triangles");
  const auto count = static_cast<std::int64_t>(part.vertices.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const JsonReader row = triangles.at(i);
    if (row.size() != 3) row.fail("must be three indices of vertices");
    Eigen::Vector3i corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t index = row.at(k).integer();
      if (index < 0 || index >= count) {
        row.at(k).fail("is no index of a vertex, there are " + std::to_string(count));
      }
      corners[static_cast<int>(k)] = static_cast<int>(index);
    }
    part.triangles.push_back(corners);
  }
  if (part.triangles.empty()) triangles.fail("is empty");
  if (!reader.has("faces")) {
    find_faces(part);
  } else {
    const JsonReader faces = reader.at("faces");
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const JsonReader row = faces.at(i);
      row.only({"name", "planar", "area", "center", "normal", "axis", "size"});
      Face face;
      face.name = row.at("name").text();
      face.planar = !row.has("planar") || row.at("planar").boolean();
      part.faces.push_back(face);
    }
    const JsonReader owner = reader.at("triangle_face");
    if (owner.size() != part.triangles.size()) owner.fail("must have one entry a triangle");
    for (std::size_t i = 0; i < owner.size(); ++i) {
      const std::int64_t face = owner.at(i).integer();
      if (face < 0 || face >= static_cast<std::int64_t>(part.faces.size())) {
        owner.at(i).fail("is no index of a face, there are " + std::to_string(part.faces.size()));
      }
      part.triangle_face.push_back(static_cast<std::int32_t>(face));
    }
    measure_faces(
        part);  // the numbers in the file are for other programs; these are the ones that count
  }
  part.convex = reader.has("convex") ? reader.at("convex").boolean() : is_convex(part);
}

Part part_of(const JsonReader& reader, Scene& scene) {
  reader.only({"name", "material", "pose", "box", "cylinder", "vertices", "triangles",
               "triangle_face", "faces", "convex"});
  const std::string name = reader.has("name") ? reader.at("name").text() : "part";
  const int material = material_index(reader, scene);
  Part part;
  if (reader.has("box")) {
    const JsonReader box = reader.at("box");
    box.only({"center", "size"});
    const Eigen::Vector3d size = size_of(box.at("size"));
    part = box_part(
        name, material,
        box.has("center") ? place_of(box.at("center")) : Eigen::Vector3d(0, 0, 0.5 * size.z()),
        size);
  } else if (reader.has("cylinder")) {
    const JsonReader cylinder = reader.at("cylinder");
    cylinder.only({"from", "to", "radius"});
    const Eigen::Vector3d from = place_of(cylinder.at("from"));
    const Eigen::Vector3d to = place_of(cylinder.at("to"));
    const double radius = cylinder.at("radius").number();
    if (!(radius > 0)) cylinder.at("radius").fail("must be a number above 0");
    if ((to - from).norm() < 1e-6) cylinder.fail("has no length");
    if (reader.has("pose"))
      reader.at("pose").fail("a cylinder takes its pose from 'from' and 'to'");
    return cylinder_part(name, material, from, to, radius);
  } else if (reader.has("vertices")) {
    part.name = name;
    part.material = material;
    read_mesh(reader, part);
  } else {
    reader.fail("has no shape", "give 'box', 'cylinder', or 'vertices' and 'triangles'");
  }
  if (reader.has("pose")) part.T_instance_part = pose_of(reader.at("pose"));
  return part;
}

Instance from_catalogue(const JsonReader& reader, Scene& scene) {
  FurnitureRequest request;
  request.kind = reader.at("kind").text();
  if (reader.has("variant")) request.variant = reader.at("variant").text();
  if (reader.has("seed")) {
    const std::int64_t seed = reader.at("seed").integer();
    if (seed < 0) reader.at("seed").fail("must not be negative");
    request.seed = static_cast<std::uint64_t>(seed);
  }
  if (reader.has("parameters")) {
    const JsonReader parameters = reader.at("parameters");
    for (const auto& key : parameters.keys()) request.parameters[key] = parameters.at(key).number();
  }
  try {
    return make_furniture(scene, request);
  } catch (const Error& error) {
    if (error.code() == ExitCode::bad_data) throw;
    reader.fail(error.what());
  }
}

ClassId class_of(const JsonReader& reader) {
  const std::string name = reader.text();
  if (const auto id = find_class(name)) return *id;
  std::vector<std::string> names;
  for (const auto& info : class_list()) names.emplace_back(info.name);
  reader.fail("unknown class '" + name + "'", suggestion(name, names));
}

Instance instance_of(const JsonReader& reader, Scene& scene, const std::filesystem::path& folder) {
  reader.only({"id", "class", "kind", "variant", "parameters", "seed", "pose", "loose", "mass",
               "parts", "mesh", "scale", "up"});
  Instance instance;
  if (reader.has("parts")) {
    const JsonReader parts = reader.at("parts");
    for (std::size_t i = 0; i < parts.size(); ++i)
      instance.parts.push_back(part_of(parts.at(i), scene));
    if (instance.parts.empty()) parts.fail("is empty");
    if (reader.has("kind")) instance.kind = reader.at("kind").text();
    if (reader.has("variant")) instance.variant = reader.at("variant").text();
    if (reader.has("parameters")) {
      const JsonReader parameters = reader.at("parameters");
      for (const auto& key : parameters.keys())
        instance.parameters[key] = parameters.at(key).number();
    }
  } else if (reader.has("mesh")) {
    MeshImport import;
    if (reader.has("scale")) import.scale = reader.at("scale").number();
    if (!(import.scale > 0)) reader.at("scale").fail("must be a number above 0");
    if (reader.has("up")) {
      const std::string up = reader.at("up").text();
      if (up != "y" && up != "z") reader.at("up").fail("must be \"y\" or \"z\"");
      import.y_up = up == "y";
    }
    const JsonReader mesh = reader.at("mesh");
    const std::filesystem::path path = folder / mesh.text();
    if (!std::filesystem::exists(path)) {
      mesh.fail("there is no mesh file '" + path.string() + "'",
                "paths count from the scene file's folder");
    }
    instance.parts = import_parts(scene, path, import);
    instance.kind = "mesh";
    instance.variant = path.filename().string();
  } else if (reader.has("kind")) {
    instance = from_catalogue(reader, scene);
  } else {
    reader.fail("has no shape", "give 'kind', 'parts' or 'mesh'");
  }
  if (reader.has("class")) instance.class_id = class_of(reader.at("class"));
  if (instance.class_id == unlabelled && !reader.has("class")) reader.fail("'class' is missing");
  if (reader.has("pose")) instance.T_world_instance = pose_of(reader.at("pose"));
  if (reader.has("loose")) instance.loose = reader.at("loose").boolean();
  if (reader.has("mass")) {
    instance.mass = reader.at("mass").number();
    if (!(instance.mass > 0))
      reader.at("mass").fail("must be a number above 0, is " + reader.at("mass").raw().dump());
  }
  return instance;
}

void read_ids(const JsonReader& instances, Scene& scene) {
  std::set<std::int32_t> taken;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const JsonReader row = instances.at(i);
    if (!row.has("id")) continue;
    const std::int64_t id = row.at("id").integer();
    if (id < 1 || id > 65535) row.at("id").fail("must lie in 1 .. 65535, is " + std::to_string(id));
    const std::size_t first = scene.instances.size() - instances.size();  // after what "room" made
    scene.instances[first + i].id = static_cast<std::int32_t>(id);
    if (!taken.insert(static_cast<std::int32_t>(id)).second) {
      row.at("id").fail("instance id " + std::to_string(id) + " is used twice");
    }
  }
  std::int32_t next = 1;
  for (auto& instance : scene.instances) {
    if (instance.id != 0) continue;
    while (taken.count(next) != 0) ++next;
    instance.id = next++;
  }
}

Scene scene_from(const Json& json, const std::string& file, const std::filesystem::path& folder) {
  const JsonReader reader(json, file);
  if (!json.is_object()) reader.fail("is no scene: an object was expected");
  reader.only({"format", "name", "family", "seed", "materials", "room", "instances", "sensor_poses",
               "bounds"});
  if (reader.has("format") && reader.at("format").text() != scene_format_name) {
    reader.at("format").fail("must be \"" + std::string(scene_format_name) + "\"");
  }
  Scene scene;
  if (reader.has("name")) scene.name = reader.at("name").text();
  if (reader.has("family")) scene.family = reader.at("family").text();
  if (reader.has("seed")) {
    const Json& seed = reader.at("seed").raw();
    if (!seed.is_number_unsigned()) reader.at("seed").fail("must be a whole number from 0");
    scene.seed = seed.get<std::uint64_t>();
  }
  if (reader.has("materials")) {
    const JsonReader materials = reader.at("materials");
    for (std::size_t i = 0; i < materials.size(); ++i)
      scene.materials.push_back(material_of(materials.at(i)));
  }
  if (reader.has("room")) {
    const JsonReader room = reader.at("room");
    room.only({"size"});
    add_plain_room(scene, size_of(room.at("size")));
    for (auto& instance : scene.instances) instance.id = 0;  // the file's own ids come first
  }
  const JsonReader instances = reader.at("instances");
  for (std::size_t i = 0; i < instances.size(); ++i) {
    scene.instances.push_back(instance_of(instances.at(i), scene, folder));
  }
  read_ids(instances, scene);
  if (reader.has("sensor_poses")) {
    const JsonReader poses = reader.at("sensor_poses");
    for (std::size_t i = 0; i < poses.size(); ++i)
      scene.sensor_poses.push_back(pose_of(poses.at(i)));
  }
  if (reader.has("bounds")) {
    const JsonReader bounds = reader.at("bounds");
    bounds.only({"min", "max"});
    scene.bounds = {place_of(bounds.at("min")), place_of(bounds.at("max"))};
  } else {
    for (const auto& instance : scene.instances) scene.bounds.extend(world_bounds(instance));
  }
  return scene;
}

}  // namespace

Scene scene_from_json(const nlohmann::ordered_json& json, const std::string& file) {
  return scene_from(json, file, std::filesystem::path(file).parent_path());
}

Scene read_scene(const std::filesystem::path& path) {
  return scene_from(read_json(path), path.string(), path.parent_path());
}

}  // namespace scanchor
