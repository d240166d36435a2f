#include "sensors/range_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"
#include "sensors/echo.hpp"
#include "sensors/vector_rows.hpp"

namespace scanchor {
namespace {

double power(double base, double exponent) {
  if (exponent == 1.0) return base;
  if (exponent == 0.5) return std::sqrt(base);
  return portable_exp(exponent * portable_log(base));
}

}  // namespace

double range_noise_sigma(const LidarOptions& o, double range, double reflected, double cosine) {
  const double base = std::max(o.range_sigma, o.range_slope * range + o.range_offset);
  if (o.snr_sigma == 0.0 && o.spread_noise == 0.0) return base;
  double variance = base * base;
  if (o.snr_sigma > 0.0) {
    const double ratio = range / o.snr_range;
    const double weakness = ratio * ratio * o.snr_reflectance / std::max(reflected, 1e-9);
    const double snr = o.snr_sigma * power(weakness, o.snr_exponent);
    variance += snr * snr;
  }
  if (o.spread_noise > 0.0) {
    const double diameter = o.aperture + o.divergence * range;
    const double c = std::max(cosine, 1e-3);
    const double spread = o.spread_noise * 0.25 * diameter * std::sqrt(1.0 - c * c) / c;
    variance += spread * spread;
  }
  return std::sqrt(variance);
}

double wiggling(const LidarOptions& o, double range) {
  if (o.wiggle == 0.0) return 0.0;
  const double phase = 4.0 * pi * o.modulation_frequency * range / speed_of_light;
  return o.wiggle * portable_sincos(4.0 * phase).sin;
}

double quantise(double range, double quantum) {
  return quantum > 0.0 ? quantum * std::floor(range / quantum + 0.5) : range;
}

RangeError::RangeError(const LidarOptions& options, std::uint64_t seed)
    : options_(options), noise_seed_(stream_seed(seed, "range noise")) {
  if (options.drift_sigma > 0.0) {
    drift_ = options.drift_sigma * CounterRandom(stream_seed(seed, "drift")).normal(0);
  }
}

void RangeError::apply(int line, const LineReturns& returns, std::vector<double>& measured) const {
  const std::size_t count = returns.size();
  measured.resize(count);
  std::vector<double> noise(count, 0.0);
  const LidarOptions& o = options_;
  if (o.range_sigma > 0.0 || o.range_slope > 0.0 || o.range_offset > 0.0 || o.snr_sigma > 0.0 ||
      o.spread_noise > 0.0) {
    normal_row(noise_seed_, static_cast<std::uint64_t>(line), count, noise.data());
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (returns.triangle[k] == no_hit) continue;
    const double range = returns.range[k];
    const double sigma = range_noise_sigma(o, range, returns.reflected[k], returns.cosine[k]);
    const double value = range + drift_ + wiggling(o, range) + sigma * noise[k];
    measured[k] = quantise(value, o.range_quantum);
  }
}

}  // namespace scanchor
