#include "scenes/import.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "scenes/materials.hpp"
#include "scenes/pose.hpp"
#include "scenes/shell.hpp"
#include "scenes/truth.hpp"

#if __has_include(<assimp/Importer.hpp>)
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#define SCANCHOR_HAS_ASSIMP 1
#else
#define SCANCHOR_HAS_ASSIMP 0
#endif

namespace scanchor {

#if SCANCHOR_HAS_ASSIMP
namespace {

struct NamedPart {
  std::string node;
  Part part;
};

int add_material(Scene& scene, const aiScene& file, unsigned index, const std::string& stem) {
  const aiMaterial& from = *file.mMaterials[index];
  aiString name;
  from.Get(AI_MATKEY_NAME, name);
  Material material;
  material.name = stem + ":" + name.C_Str();
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].name == material.name) return static_cast<int>(i);
  }
  aiColor3D color(0.7F, 0.7F, 0.7F);
  from.Get(AI_MATKEY_COLOR_DIFFUSE, color);
  const float channel[] = {color.r, color.g, color.b};
  for (std::size_t k = 0; k < 3; ++k) {
    material.color[k] =
        static_cast<std::uint8_t>(std::clamp(channel[k], 0.0F, 1.0F) * 255.0F + 0.5F);
  }
  // Files know nothing of 905 nm: the grey of the colour, within what indoor surfaces reflect.
  material.reflectance =
      std::clamp(0.3 * channel[0] + 0.59 * channel[1] + 0.11 * channel[2], 0.05, 0.9);
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

void collect(Scene& scene, const aiScene& file, const aiNode& node, const aiMatrix4x4& above,
             const std::string& path, const MeshImport& options, std::vector<NamedPart>& parts) {
  const aiMatrix4x4 T = above * node.mTransformation;
  const std::string stem = std::filesystem::path(path).stem().string();
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *file.mMeshes[node.mMeshes[m]];
    NamedPart named;
    named.node = std::string(node.mName.C_Str()) + " " + mesh.mName.C_Str();
    Part& part = named.part;
    part.name = mesh.mName.length > 0 ? mesh.mName.C_Str() : node.mName.C_Str();
    part.material = add_material(scene, file, mesh.mMaterialIndex, stem);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = T * mesh.mVertices[v];
      Eigen::Vector3d q(p.x, p.y, p.z);
      q *= options.scale;
      if (options.y_up) q = Eigen::Vector3d(q.x(), -q.z(), q.y());
      if (!q.allFinite()) fail_data(path, "vertex " + std::to_string(v), "is not finite");
      part.vertices.push_back(q);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      part.triangles.emplace_back(static_cast<int>(face.mIndices[0]),
                                  static_cast<int>(face.mIndices[1]),
                                  static_cast<int>(face.mIndices[2]));
    }
    if (part.triangles.empty()) continue;
    find_faces(part, options.flat_deg, options.flat_distance);
    part.convex = is_convex(part, 1e-6);
    parts.push_back(std::move(named));
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    collect(scene, file, *node.mChildren[c], T, path, options, parts);
}

std::vector<NamedPart> read_parts(Scene& scene, const std::filesystem::path& path,
                                  const MeshImport& options) {
  if (!std::filesystem::exists(path)) fail_data(path.string(), "", "there is no such mesh file");
  Assimp::Importer importer;
  // Points and lines are dropped, polygons cut, equal vertices joined.
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* file =
      importer.ReadFile(path.string(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                           aiProcess_SortByPType | aiProcess_FindDegenerates);
  if (file == nullptr || file->mRootNode == nullptr) {
    std::string cause = importer.GetErrorString();
    std::replace(cause.begin(), cause.end(), '\n', ' ');
    fail_data(path.string(), "", "cannot be read as a mesh: " + cause);
  }
  std::vector<NamedPart> parts;
  collect(scene, *file, *file->mRootNode, aiMatrix4x4(), path.string(), options, parts);
  if (parts.empty()) fail_data(path.string(), "", "holds no triangles");
  return parts;
}

ClassId class_by_name(std::string name, const std::map<std::string, ClassId>& classes) {
  for (char& c : name)
    c = c == '_' || c == '-' || c == '.'
            ? ' '
            : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::size_t best = 0;
  ClassId found = *find_class("clutter");
  for (const auto& [key, id] : classes) {
    if (key.size() > best && name.find(key) != std::string::npos) {
      best = key.size();
      found = id;
    }
  }
  if (best > 0) return found;
  for (const auto& info : class_list()) {
    // "Kitchen Table" and "KitchenTable" both hold "table".
    if (info.id != unlabelled && info.name.size() > best &&
        name.find(info.name) != std::string::npos) {
      best = info.name.size();
      found = info.id;
    }
  }
  return found;
}

}  // namespace

bool can_import_meshes() { return true; }

std::vector<Part> import_parts(Scene& scene, const std::filesystem::path& path,
                               const MeshImport& options) {
  std::vector<Part> parts;
  for (auto& named : read_parts(scene, path, options)) parts.push_back(std::move(named.part));
  return parts;
}

Scene import_scene(const std::filesystem::path& path, const std::map<std::string, ClassId>& classes,
                   const MeshImport& options) {
  Scene scene;
  scene.name = path.stem().string();
  scene.family = "imported";
  const auto parts = read_parts(scene, path, options);
  for (const auto& named : parts) {
    Instance instance;
    instance.id = next_id(scene);
    instance.class_id = class_by_name(named.node, classes);
    // One object in a file that is named after it ("KitchenTable_01.obj").
    if (instance.class_id == *find_class("clutter"))
      instance.class_id = class_by_name(path.stem().string(), classes);
    instance.kind = "mesh";
    instance.variant = named.part.name;
    instance.parts.push_back(named.part);
    scene.instances.push_back(std::move(instance));
    scene.bounds.extend(world_bounds(scene.instances.back()));
  }
  return scene;
}

#else

bool can_import_meshes() { return false; }

std::vector<Part> import_parts(Scene&, const std::filesystem::path& path, const MeshImport&) {
  fail_usage("this build cannot read the mesh '" + path.string() + "': it was made without assimp",
             "install libassimp-dev and configure again");
}

Scene import_scene(const std::filesystem::path& path, const std::map<std::string, ClassId>&,
                   const MeshImport&) {
  fail_usage("this build cannot read the mesh '" + path.string() + "': it was made without assimp",
             "install libassimp-dev and configure again");
}

#endif

}  // namespace scanchor
