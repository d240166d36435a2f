#pragma once
// The LZF compression of Marc Lehmann's liblzf, as binary_compressed PCD files use it: a stream of
// literal runs (control byte below 32: that many + 1 bytes follow) and back references (length in
// the upper three bits, distance in the lower five and the next byte).

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace scanchor {

/// No stream expands by more than this: three bytes give at most 264. Check a promised size against
/// it before believing it.
inline constexpr std::size_t lzf_greatest_expansion = 88;

/// Compressed bytes; may be longer than the input by one byte in 32.
std::string lzf_compress(std::string_view input);
/// The original, or nothing if the stream is damaged or does not give exactly `size` bytes.
std::optional<std::string> lzf_decompress(std::string_view input, std::size_t size);

}  // namespace scanchor
