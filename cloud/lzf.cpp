#include "cloud/lzf.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace scanchor {
namespace {

constexpr std::size_t greatest_literal = 32;
constexpr std::size_t greatest_distance = 8192;
constexpr std::size_t greatest_match = 264;
constexpr std::size_t smallest_match = 3;
constexpr int hash_bits = 15;

std::uint32_t hash3(const unsigned char* p) {
  const std::uint32_t word = (std::uint32_t{p[0]} << 16) | (std::uint32_t{p[1]} << 8) | p[2];
  return (word * 2654435761U) >> (32 - hash_bits);  // Knuth's multiplicative hash
}

void put_literals(std::string& out, std::string_view run) {
  while (!run.empty()) {
    const std::size_t n = std::min(run.size(), greatest_literal);
    out += static_cast<char>(n - 1);
    out.append(run.substr(0, n));
    run.remove_prefix(n);
  }
}

}  // namespace

std::string lzf_compress(std::string_view input) {
  std::string out;
  out.reserve(input.size() + input.size() / greatest_literal + 1);
  const auto* bytes = reinterpret_cast<const unsigned char*>(input.data());
  std::vector<std::size_t> last(std::size_t{1} << hash_bits, SIZE_MAX);
  std::size_t literal = 0;  // where the run of bytes without a match begins
  std::size_t i = 0;
  while (i + smallest_match <= input.size()) {
    std::size_t& slot = last[hash3(bytes + i)];
    const std::size_t candidate = slot;
    slot = i;
    std::size_t length = 0;
    if (candidate != SIZE_MAX && i - candidate <= greatest_distance) {
      const std::size_t limit = std::min(greatest_match, input.size() - i);
      while (length < limit && bytes[candidate + length] == bytes[i + length]) ++length;
    }
    if (length < smallest_match) {
      ++i;
      continue;
    }
    put_literals(out, input.substr(literal, i - literal));
    const std::size_t distance = i - candidate - 1;
    const std::size_t coded = length - 2;
    if (coded < 7) {
      out += static_cast<char>((coded << 5) | (distance >> 8));
    } else {
      out += static_cast<char>((7U << 5) | (distance >> 8));
      out += static_cast<char>(coded - 7);
    }
    out += static_cast<char>(distance & 255);
    i += length;
    literal = i;
  }
  put_literals(out, input.substr(literal));
  return out;
}

std::optional<std::string> lzf_decompress(std::string_view input, std::size_t size) {
  std::string out;
  out.reserve(size);
  std::size_t i = 0;
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(input[at]); };
  while (i < input.size()) {
    const std::size_t control = byte(i++);
    if (control < greatest_literal) {
      const std::size_t n = control + 1;
      if (i + n > input.size() || out.size() + n > size) return std::nullopt;
      out.append(input.substr(i, n));
      i += n;
      continue;
    }
    std::size_t length = control >> 5;
    if (length == 7) {
      if (i >= input.size()) return std::nullopt;
      length += byte(i++);
    }
    length += 2;
    if (i >= input.size()) return std::nullopt;
    const std::size_t distance = ((control & 31) << 8 | byte(i++)) + 1;
    if (distance > out.size() || out.size() + length > size) return std::nullopt;
    // Byte by byte: the reference may overlap what it writes (a run is a distance of 1).
    for (std::size_t k = 0; k < length; ++k) out += out[out.size() - distance];
  }
  if (out.size() != size) return std::nullopt;
  return out;
}

}  // namespace scanchor
