#pragma once
// From the true range to the number that the instrument reports: noise, drift, wiggling,
// quantisation.

#include <cstdint>
#include <vector>

#include "sensors/line_returns.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {

/// Standard deviation [m] of the range noise: sensors.md 1.2 formula 4, max(s_min, k r + c)
/// (Pomerleau, Breitenmoser, Liu, Colas, Siegwart 2012), plus formula 3 in quadrature, sigma_0
/// ((R/R_0)^2 rho_0 / (rho cos a))^e (Soudarissanane et al. 2009; e = 1 electronics limited, 1/2
/// shot limited), plus `spread_noise` of the footprint's range spread (formula 1). `reflected` is
/// rho cos a of the echo, `cosine` that of the incidence.
double range_noise_sigma(const LidarOptions& options, double range, double reflected,
                         double cosine);

/// Error of a phase camera that repeats four times a period (formula 12; Lange & Seitz 2001):
/// wiggle sin(4 . 4 pi f R / c).
double wiggling(const LidarOptions& options, double range);

/// Nearest multiple of the quantum (formula 8).
double quantise(double range, double quantum);

/// Draws are keyed by line and beam, so they depend on neither threads nor order.
class RangeError {
 public:
  RangeError(const LidarOptions& options, std::uint64_t seed);
  /// measured[k] [m] for each return of a line; rows without return are left alone.
  void apply(int line, const LineReturns& returns, std::vector<double>& measured) const;
  [[nodiscard]] double drift() const { return drift_; }  ///< [m] of this scan (formula 13)

 private:
  LidarOptions options_;
  std::uint64_t noise_seed_;
  double drift_ = 0.0;
};

}  // namespace scanchor
