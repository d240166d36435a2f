#pragma once
// A picture in memory and as a PNG file.

#include <cstdint>
#include <filesystem>
#include <vector>

namespace scanchor {

/// 8-bit RGB, row-major, top row first, 3 bytes a pixel without padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Whole or not at all; the same bytes for the same picture. Throws Error(bad_data).
void write_png(const std::filesystem::path& path, const Image& image);
/// Throws Error(bad_data) for anything that is no PNG.
Image read_png(const std::filesystem::path& path);

}  // namespace scanchor
