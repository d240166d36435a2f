#pragma once
// What comes back from the beams of one line before the instrument adds its errors.

#include <cstdint>
#include <vector>

#include "sim/world.hpp"

namespace scanchor {

/// Columns, a row a beam. A beam without return has triangle == no_hit.
struct LineReturns {
  std::vector<double> range;       ///< [m] of the echo: mixed where surfaces ran together
  std::vector<double> true_range;  ///< [m] of the surface whose label the point bears
  std::vector<double> cosine;      ///< of the incidence at that surface, [0, 1]
  std::vector<double> reflected;   ///< rho cos a of the whole echo: received energy times range^2
  std::vector<std::uint32_t> triangle;   ///< whose label the point bears
  std::vector<std::uint32_t> runner_up;  ///< second surface in the footprint, or no_hit
  std::vector<std::uint8_t> flags;       ///< PointFlag bits

  void resize(std::size_t count) {
    range.resize(count);
    true_range.resize(count);
    cosine.resize(count);
    reflected.resize(count);
    triangle.resize(count);
    runner_up.resize(count);
    flags.resize(count);
  }
  [[nodiscard]] std::size_t size() const { return range.size(); }
};

}  // namespace scanchor
