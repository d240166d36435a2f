#pragma once
// Furniture and whole rooms from mesh files (OBJ, glTF, PLY, STL, ... through assimp), with classes
// given by name.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace scanchor {

struct MeshImport {
  double scale = 1.0;           ///< file units to metres
  bool y_up = true;             ///< OBJ and glTF are usually y-up; turned to z-up
  double flat_deg = 0.5;        ///< triangles of one planar face differ by at most this angle
  double flat_distance = 1e-3;  ///< [m] and lie this near to its plane
};

/// Whether this build can read meshes.
bool can_import_meshes();

/// Every mesh of the file as one part, with the file's own material (diffuse colour), in the file's
/// frame turned z-up and scaled. Faces are found by find_faces. Throws Error(bad_data): file
/// missing, unreadable, without triangles, vertices that are not finite; Error(wrong_usage) in a
/// build without assimp.
std::vector<Part> import_parts(Scene& scene, const std::filesystem::path& path,
                               const MeshImport& options = {});

/// A whole file as one scene: every node (object, group) becomes an instance, whose class is found
/// by its name: the longest key of `classes` that the name contains (lower case, "_" and "-" read
/// as blanks), else the longest class name that it contains, else "clutter".
Scene import_scene(const std::filesystem::path& path,
                   const std::map<std::string, ClassId>& classes = {},
                   const MeshImport& options = {});

}  // namespace scanchor
