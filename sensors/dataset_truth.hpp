#pragma once
// The truth beside a data set's points: faces with what was seen of them, and relations. Internal
// to dataset*.cpp.

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

/// faces.json: for every face its exact geometry in the world, and in each scan its points and the
/// share that was visible.
std::string faces_json(const Scene& scene,
                       const std::vector<std::vector<FaceVisibility>>& visibility);
/// relations.json: the exact relations between the things of a room, with their margins.
std::string relations_json(const Scene& scene);
/// The visibility of one scan back.
std::vector<FaceVisibility> read_face_visibility(const std::filesystem::path& path,
                                                 std::size_t scan);

}  // namespace scanchor
