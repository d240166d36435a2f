#include "core/random.hpp"

#include <algorithm>

#include "core/math.hpp"

namespace scanchor {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p0 = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t p1 = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {
        static_cast<std::uint32_t>(p1 >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(p1),
        static_cast<std::uint32_t>(p0 >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(p0)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

std::uint64_t stream_seed(std::uint64_t seed, std::string_view name, std::uint64_t index) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a over the name
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  const auto mixed =
      philox({static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32),
              static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32)},
             {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  return std::uint64_t{mixed[0]} | (std::uint64_t{mixed[1]} << 32);
}

std::array<std::uint32_t, 4> CounterRandom::words(std::uint64_t a, std::uint32_t b,
                                                  std::uint32_t draw) const {
  return philox({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(a >> 32), b, draw},
                {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)});
}

double CounterRandom::uniform(std::uint64_t a, std::uint32_t b, std::uint32_t draw) const {
  const auto w = words(a, b, draw);
  const std::uint64_t bits = (std::uint64_t{w[0]} << 21) ^ (w[1] >> 11);  // 53 bits
  return (static_cast<double>(bits) + 0.5) * 0x1p-53;
}

double CounterRandom::normal(std::uint64_t a, std::uint32_t b, std::uint32_t draw) const {
  // The largest 53-bit draw plus one half rounds to 1; the quantile wants the open interval.
  return normal_quantile(std::min(uniform(a, b, draw), 1.0 - 0x1p-53));
}

double SequentialRandom::truncated_normal(double mean, double sigma, double low, double high) {
  for (int attempt = 0; attempt < 64; ++attempt) {
    const double x = mean + sigma * normal();
    if (x >= low && x <= high) return x;
  }
  return uniform(low, high);
}

std::uint32_t SequentialRandom::below(std::uint32_t count) {
  const auto word = source_.words(next_++)[0];
  return static_cast<std::uint32_t>((std::uint64_t{word} * count) >> 32);
}

}  // namespace scanchor
