#pragma once
// Where a footprint lies on several surfaces, the instrument still reports one range: which, and
// whose label it bears.

#include <cstdint>
#include <span>

#include "sensors/tilting_lidar.hpp"
#include "sim/world.hpp"

namespace scanchor {

/// Light that came back along one path.
struct Sample {
  double range;      ///< [m] length of the path there
  double reflected;  ///< weight rho cos a: its energy is reflected / range^2
  double cosine;     ///< of the incidence
  std::uint32_t triangle;
  std::int32_t face;   ///< index into World::faces()
  std::uint8_t flags;  ///< point_ghost, point_behind_glass
};

/// What the instrument makes of all samples of a beam.
struct Echo {
  double range = 0.0;               ///< [m] reported, without noise
  double true_range = 0.0;          ///< [m] of the surface that gave most of the energy
  double cosine = 0.0;              ///< there
  double reflected = 0.0;           ///< energy of the echo times range^2
  std::uint32_t triangle = no_hit;  ///< of that surface; no_hit: nothing came back
  std::uint32_t runner_up =
      no_hit;              ///< of the surface with the second most energy in the same echo
  std::uint8_t flags = 0;  ///< of the samples, and point_mixed where two surfaces ran together
};

/// Sensors.md 1.2 formula 5. A pulse: samples nearer to each other than c tau / 2 form one echo,
/// whose range is the mean by energy; the first, strongest or last echo above `echo_share` of the
/// strongest is reported. A modulated beam: the phase of the sum of all phasors, modulo c / 2f
/// (Hebert & Krotkov 1992; Tuley, Vandapel, Hebert, ICRA 2005). Sorts the samples.
Echo resolve_echo(const LidarOptions& options, std::span<Sample> samples);

inline constexpr double speed_of_light = 299792458.0;  // [m/s], exact by definition

/// [m] below which two echoes of a pulse run together: c tau / 2.
double echo_gap(const LidarOptions& options);
/// [m] after which a phase scanner starts again at 0: c / 2f.
double ambiguity_range(const LidarOptions& options);

}  // namespace scanchor
