#pragma once
// Whether enough light comes back.

#include <cstdint>

#include "sensors/tilting_lidar.hpp"

namespace scanchor {

/// [dB] of the received power over the threshold, from the lidar equation for extended Lambertian
/// targets (Hoefle & Pfeifer 2007; sensors.md 1.2 formula 2): 10 log10((reflected /
/// detection_reflectance) (detection_range / range)^2).
double detection_margin(const LidarOptions& options, double range, double reflected);

/// Share of pulses that are seen: Phi(margin / detection_db) times (1 - loss) (formula 6). For
/// tests and docs; the draws themselves need no distribution function.
double detection_probability(const LidarOptions& options, double range, double reflected);

class Detection {
 public:
  Detection(const LidarOptions& options, std::uint64_t seed);
  /// Whether this pulse is seen; a pure function of line and beam.
  [[nodiscard]] bool seen(int line, int beam, double range, double reflected) const;
  [[nodiscard]] bool always() const {
    return options_.detection_range == 0.0 && options_.loss == 0.0;
  }

 private:
  LidarOptions options_;
  std::uint64_t power_seed_, loss_seed_;
};

}  // namespace scanchor
