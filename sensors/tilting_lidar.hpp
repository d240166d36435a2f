#pragma once
// The tilting LIDAR: a line scanner on a tilt unit. Every effect has its own switch or scale; all formulas and sources are in
// docs/reference/sensors.md.

#include <cstdint>
#include <string>
#include <vector>

#include "core/options.hpp"
#include "sensors/scan.hpp"
#include "sim/world.hpp"

namespace scanchor {

struct LidarOptions {
  std::string preset = "paper";      ///< the device the numbers came from
  // Geometry
  double horizontal_deg = 180.0;     ///< opening angle of a line
  double vertical_deg = 90.0;        ///< tilt sweep
  double tilt_center_deg = -15.0;    ///< middle of the sweep; negative looks down
  int beams_per_line = 500;
  int lines = 200;
  double minimum_range = 0.1;        ///< [m]
  double maximum_range = 30.0;       ///< [m]
  // Noise
  double range_sigma = 0.01;         ///< [m] standard deviation of the range, at any range
  // (further effects are added here, each with its own member)
  void describe(OptionList& list);
};

/// Names of the presets: "paper", "utm-30lx", ...
const std::vector<std::string>& lidar_presets();
/// Options of a preset. Throws Error(wrong_usage) for an unknown name.
LidarOptions lidar_preset(const std::string& name);

/// One sweep from a pose (x forward, y left, z up). Deterministic: the same world, pose, options and seed give the same bytes for any
/// number of threads, packet width or instruction set.
Scan scan_room(const World& world, const Eigen::Isometry3d& T_world_sensor,
               const LidarOptions& options, std::uint64_t seed);

}  // namespace scanchor
