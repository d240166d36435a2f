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

/// Deterministic: the same options and seed give the same bytes of scene.json on any machine and
/// thread count.
Scene generate_room(const RoomOptions& options, std::uint64_t seed);

}  // namespace scanchor
