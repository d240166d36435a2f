#pragma once
// Procedural rooms: a seed and a family give a scene. Loose things are placed a little above where
// they will lie; sim::settle lets them come to rest.

#include <cstdint>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "scenes/scene.hpp"

namespace scanchor {

struct RoomOptions {
  std::string family = "office";   ///< one of room_families()
  double clutter = 0.5;            ///< [0, 1] share of the possible clutter that is there
  double size_scale = 1.0;         ///< scales the room's sides
  double out_of_square_deg = 2.0;  ///< standard deviation of the yaw of furniture against its wall
  double unusual_sizes = 0.0;      ///< [0, 1] share of furniture with sizes outside the usual range
  void describe(OptionList& list);
};

/// The names of all families, in a fixed order.
const std::vector<std::string>& room_families();

/// A room, and how it came about.
struct GeneratedRoom {
  Scene scene;
  int tries = 0;          ///< number of the try that gave it, counted from 1
  bool complete = false;  ///< has its essentials, its paths can be walked, and it can be scanned
};

/// Tries from number `first` + 1 on until a room is complete, each with a little less clutter;
/// after `most_tries` the last one is given all the same, and says that it is not complete.
/// Deterministic: the same options and seed give the same bytes of scene.json on any machine and
/// thread count. Throws Error(wrong_usage) for an unknown family.
GeneratedRoom furnish_room(const RoomOptions& options, std::uint64_t seed, int first = 0);
inline constexpr int most_tries = 60;

/// The scene of furnish_room.
Scene generate_room(const RoomOptions& options, std::uint64_t seed);

}  // namespace scanchor
