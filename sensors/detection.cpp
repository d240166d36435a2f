#include "sensors/detection.hpp"

#include <algorithm>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor {

double detection_margin(const LidarOptions& options, double range, double reflected) {
  const double ratio = options.detection_range / range;
  const double power = std::max(reflected, 1e-12) / options.detection_reflectance * ratio * ratio;
  constexpr double ln10 = 2.302585092994045684;
  return 10.0 * portable_log(power) / ln10;
}

double detection_probability(const LidarOptions& options, double range, double reflected) {
  double probability = 1.0;
  if (options.detection_range > 0.0) {
    const double margin = detection_margin(options, range, reflected);
    probability = options.detection_db > 0.0 ? normal_cdf(margin / options.detection_db)
                                             : (margin > 0.0 ? 1.0 : 0.0);
  }
  return probability * (1.0 - options.loss);
}

Detection::Detection(const LidarOptions& options, std::uint64_t seed)
    : options_(options),
      power_seed_(stream_seed(seed, "detection")),
      loss_seed_(stream_seed(seed, "loss")) {}

bool Detection::seen(int line, int beam, double range, double reflected) const {
  const auto a = static_cast<std::uint64_t>(line);
  const auto b = static_cast<std::uint32_t>(beam);
  if (options_.detection_range > 0.0) {
    // margin + s_dB N(0, 1) > 0 has the probability Phi(margin / s_dB).
    const double jitter = options_.detection_db * CounterRandom(power_seed_).normal(a, b);
    if (detection_margin(options_, range, reflected) + jitter <= 0.0) return false;
  }
  return options_.loss == 0.0 || CounterRandom(loss_seed_).uniform(a, b) >= options_.loss;
}

}  // namespace scanchor
