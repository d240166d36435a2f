#pragma once
// Bullet lets the loose things of a scene come to rest.

#include <string>
#include <vector>

#include "core/options.hpp"
#include "scenes/scene.hpp"

namespace scanchor {

struct SettleOptions {
  double time_step = 1.0 / 240.0;   ///< [s]
  double maximum_time = 8.0;        ///< [s] simulated
  double rest_speed = 0.01;         ///< [m/s] below which a thing counts as at rest
  void describe(OptionList& list);
};

struct SettleReport {
  bool settled = false;             ///< everything loose is at rest, supported, and penetrates by at most 1 mm
  double simulated_time = 0.0;      ///< [s]
  double deepest_penetration = 0.0; ///< [m]
  std::vector<std::string> problems;  ///< one line each: what still moves, fell, or hangs
};

/// Moves the loose instances to where they come to rest. Deterministic for the same scene and options (one thread, fixed steps).
SettleReport settle(Scene& scene, const SettleOptions& options);

}  // namespace scanchor
