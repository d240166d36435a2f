#pragma once
// Rooms that went the whole way: generated, settled, scanned, perceived. The truth of a surface is what most of its points hit.

#include <cstdint>
#include <string>
#include <vector>

#include "perception/surface.hpp"

namespace scanchor::test {

struct SimulatedRoom {
  Surfaces surfaces;
  std::vector<std::string> classes;     ///< true class of each surface; "" where no class has 60 % of its points
  std::vector<int> instances;           ///< true Instance::id of each surface
  std::vector<std::size_t> points;      ///< inliers of each surface
};

/// The paper's scan (100 000 points, 1 cm of noise unless given) of a procedural room from its first free place.
SimulatedRoom simulated_room(const std::string& family, std::uint64_t seed, double range_sigma = 0.01);

}  // namespace scanchor::test
