#pragma once
// Rooms that were perceived once and are kept beside a counted class file: against them it is
// counted how often the words of a class that nobody has counted hold of other things.

#include <filesystem>
#include <string>
#include <vector>

#include "reasoning/fit.hpp"
#include "reasoning/item.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {

/// What reasoning sees of a scan, levelled, and what each item truly is.
struct ReferenceRoom {
  std::vector<Item> items;  ///< of the surfaces, in their order
  Surrounding around;
  std::vector<std::string> classes;  ///< true name of each item; "": of no single thing
};

ReferenceRoom make_reference_room(const TrainingScene& scene, const ReasonOptions& options);

/// `<ontology>.rooms.json`: documented in docs/reference/sdl.md. Lengths are kept to 1 mm,
/// directions to 1e-4. Throws Error(bad_data).
void write_reference_rooms(const std::filesystem::path& path,
                           const std::vector<ReferenceRoom>& rooms, const std::string& made_of);
std::vector<ReferenceRoom> read_reference_rooms(const std::filesystem::path& path);

}  // namespace scanchor
