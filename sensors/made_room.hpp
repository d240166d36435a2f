#pragma once
// From the task of a scene to a room at rest and the scans of it: the one place that says what a
// seed becomes, for data sets and for evaluation.

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "sensors/suite.hpp"

namespace scanchor {

/// A room that was furnished, and settled where it holds loose things.
struct MadeRoom {
  Scene scene;
  int tries = 0;                      ///< rooms that were furnished for it; 1: the first one did
  bool complete = false;              ///< has its essentials, and its paths can be walked
  bool settled = false;               ///< all loose things came to rest
  std::vector<std::string> problems;  ///< what is wrong with it all the same, one line each
};

/// Wall time [s].
struct RoomTimes {
  double generate = 0.0, settle = 0.0;
};

/// A room that lacks something or does not come to rest is furnished anew from the next stream of
/// its seed, with a little less clutter; `tries` counts them. Deterministic. Throws Error(bad_data)
/// where there is no place to scan from.
MadeRoom make_room(const SceneTask& task, RoomTimes* times = nullptr);

/// Seed of scan k of a scene.
std::uint64_t scan_seed(const SceneTask& task, int k);
/// Where scan k is taken: the sensor poses in turn.
const Eigen::Isometry3d& scan_pose(const Scene& scene, int k);

}  // namespace scanchor
