#pragma once
// Counter-based random numbers: a draw is a pure function of what it is for, so the result depends
// on neither the order of work nor the number of threads nor the packet width.

#include <array>
#include <cstdint>
#include <string_view>

namespace scanchor {

/// Philox4x32-10 (Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC
/// 2011).
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// 64-bit key of a named stream below a seed: `stream_seed(42, "scene", 17)`. Changing one stream
/// leaves all others as they are.
std::uint64_t stream_seed(std::uint64_t seed, std::string_view name, std::uint64_t index = 0);

/// A function from (a, b, draw) to numbers; stateless, free to call from any thread.
/// Example: `CounterRandom noise(stream_seed(seed, "range")); noise.normal(line, beam)`.
class CounterRandom {
 public:
  explicit CounterRandom(std::uint64_t seed) : seed_(seed) {}
  /// Four 32-bit words for counter (a, b, draw).
  [[nodiscard]] std::array<std::uint32_t, 4> words(std::uint64_t a, std::uint32_t b = 0,
                                                   std::uint32_t draw = 0) const;
  /// Uniform in the open interval (0, 1), 53 bits.
  [[nodiscard]] double uniform(std::uint64_t a, std::uint32_t b = 0, std::uint32_t draw = 0) const;
  /// Standard normal by inversion of the distribution function.
  [[nodiscard]] double normal(std::uint64_t a, std::uint32_t b = 0, std::uint32_t draw = 0) const;

 private:
  std::uint64_t seed_;
};

/// The same numbers one after another, for code that is sequential by nature (placing furniture).
class SequentialRandom {
 public:
  explicit SequentialRandom(std::uint64_t seed) : source_(seed) {}
  double uniform() { return source_.uniform(next_++); }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double normal() { return source_.normal(next_++); }
  /// Normal cut to [low, high] by drawing again.
  double truncated_normal(double mean, double sigma, double low, double high);
  /// Uniform integer in [0, count), count >= 1.
  std::uint32_t below(std::uint32_t count);
  bool chance(double probability) { return uniform() < probability; }

 private:
  CounterRandom source_;
  std::uint64_t next_ = 0;
};

}  // namespace scanchor
