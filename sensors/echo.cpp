#include "sensors/echo.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math.hpp"
#include "sensors/portable_angle.hpp"

namespace scanchor {
namespace {

double energy(const Sample& s) { return s.reflected / (s.range * s.range); }

/// Energy of one surface in an echo.
struct Share {
  std::int32_t face;
  std::uint32_t triangle;
  std::uint8_t flags;
  double energy, range_sum, cosine_sum;
};

/// Fills everything that is about whose echo it is. `echo.range` stays as it is.
void label(const LidarOptions& options, std::span<const Sample> samples, Echo& echo) {
  std::vector<Share> shares;  // few: a footprint seldom touches more than three faces
  for (const Sample& s : samples) {
    auto share = std::find_if(shares.begin(), shares.end(), [&](const Share& other) {
      return other.face == s.face && other.flags == s.flags;
    });
    if (share == shares.end()) {
      shares.push_back({s.face, s.triangle, s.flags, 0.0, 0.0, 0.0});
      share = shares.end() - 1;
    }
    const double e = energy(s);
    share->energy += e;
    share->range_sum += e * s.range;
    share->cosine_sum += e * s.cosine;
  }
  // The most energy first; among equals the lower face, so that no order of work decides.
  std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
    return a.energy != b.energy ? a.energy > b.energy : a.face < b.face;
  });
  const Share& best = shares.front();
  echo.triangle = best.triangle;
  echo.flags = best.flags;
  echo.true_range = best.energy > 0.0 ? best.range_sum / best.energy : samples.front().range;
  echo.cosine = best.energy > 0.0 ? best.cosine_sum / best.energy : samples.front().cosine;
  if (shares.size() > 1 && shares[1].energy >= options.echo_share * best.energy) {
    echo.runner_up = shares[1].triangle;
    echo.flags |= point_mixed;
  }
}

Echo one_surface(const LidarOptions& options, std::span<const Sample> samples) {
  double sum = 0.0, range_sum = 0.0;
  for (const Sample& s : samples) {
    sum += energy(s);
    range_sum += energy(s) * s.range;
  }
  Echo echo;
  echo.range = sum > 0.0 ? range_sum / sum : samples.front().range;
  echo.reflected = sum * echo.range * echo.range;
  label(options, samples, echo);
  return echo;
}

Echo pulse(const LidarOptions& options, std::span<Sample> samples) {
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) {
    return a.range != b.range ? a.range < b.range : a.face < b.face;
  });
  struct Cluster {
    std::size_t begin, end;
    double energy;
  };
  const double gap = echo_gap(options);
  std::vector<Cluster> clusters;
  double strongest = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i == 0 || samples[i].range - samples[i - 1].range > gap) clusters.push_back({i, i, 0.0});
    clusters.back().end = i + 1;
    clusters.back().energy += energy(samples[i]);
    strongest = std::max(strongest, clusters.back().energy);
  }
  const Cluster* chosen = nullptr;
  for (const Cluster& c : clusters) {
    if (c.energy < options.echo_share * strongest) continue;
    const bool better = chosen == nullptr || options.echo == "last" ||
                        (options.echo == "strongest" && c.energy > chosen->energy);
    if (better) chosen = &c;
  }
  return one_surface(options, samples.subspan(chosen->begin, chosen->end - chosen->begin));
}

Echo phase(const LidarOptions& options, std::span<const Sample> samples) {
  const double per_metre = 4.0 * pi * options.modulation_frequency / speed_of_light;
  double real = 0.0, imaginary = 0.0;
  for (const Sample& s : samples) {
    const auto [sine, cosine] = portable_sincos(per_metre * s.range);
    real += energy(s) * cosine;
    imaginary += energy(s) * sine;
  }
  Echo echo;
  double angle = portable_atan2(imaginary, real);
  if (angle < 0.0) angle += 2.0 * pi;
  echo.range = angle / per_metre;
  label(options, samples, echo);
  // The amplitude of the sum, over the range where the light was: surfaces out of step weaken each
  // other.
  echo.reflected =
      std::sqrt(real * real + imaginary * imaginary) * echo.true_range * echo.true_range;
  return echo;
}

}  // namespace

double echo_gap(const LidarOptions& options) { return 0.5 * speed_of_light * options.pulse_width; }

double ambiguity_range(const LidarOptions& options) {
  return 0.5 * speed_of_light / options.modulation_frequency;
}

Echo resolve_echo(const LidarOptions& options, std::span<Sample> samples) {
  if (samples.empty()) return {};
  if (options.echo == "phase") return phase(options, samples);
  // The common case by far: one surface within one gap. No need to sort.
  bool one = true;
  double nearest = samples[0].range, farthest = samples[0].range;
  for (const Sample& s : samples) {
    one = one && s.face == samples[0].face && s.flags == samples[0].flags;
    nearest = std::min(nearest, s.range);
    farthest = std::max(farthest, s.range);
  }
  if (one && farthest - nearest <= echo_gap(options)) return one_surface(options, samples);
  return pulse(options, samples);
}

}  // namespace scanchor
