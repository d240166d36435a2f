#pragma once
// Bullet lets the loose things of a scene come to rest.

#include <string>
#include <vector>

#include "core/options.hpp"
#include "scenes/scene.hpp"

namespace scanchor {

struct SettleOptions {
  double time_step = 1.0 / 240.0;  ///< [s]
  double maximum_time = 8.0;       ///< [s] simulated
  double rest_speed = 0.01;        ///< [m/s] below which a thing counts as at rest
  double rest_time = 0.1;          ///< [s] that everything must stay below rest_speed
  double friction = 0.6;  ///< Coulomb coefficient of every pair (wood on wood 0.25-0.5, cardboard
                          ///< on wood about 0.6)
  void describe(OptionList& list);
};

/// What came of it. Lengths in metres, times in seconds of the simulation.
struct SettleReport {
  bool settled = false;  ///< everything loose is at rest, supported, and penetrates by at most 1 mm
  double simulated_time = 0.0;        ///< [s]
  double deepest_penetration = 0.0;   ///< [m]
  std::size_t loose = 0;              ///< things that were simulated
  std::vector<std::string> problems;  ///< one line each: what still moves, fell, or hangs
};

/// Moves the loose instances to where they come to rest. Deterministic for the same scene and
/// options (one thread, fixed steps, Bullet's scalar solver). Convex parts collide as boxes or
/// convex hulls, fixed parts that are not convex as triangles, loose ones that are not as their
/// hulls. A scene with nothing loose is settled as it is. May run in several threads on several
/// scenes.
SettleReport settle(Scene& scene, const SettleOptions& options);

}  // namespace scanchor
