#pragma once
// A picture in memory and as a PNG file.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace scanchor {

/// 8-bit RGB, row-major, top row first, 3 bytes a pixel without padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The picture as a PNG file's bytes; the same for the same picture. Throws Error(bad_data) for a
/// picture without pixels.
std::string png_bytes(const Image& image);
/// A `factor`-th of the size, by the mean of factor x factor pixels.
Image smaller(const Image& image, int factor);

/// Whole or not at all; the same bytes for the same picture. Throws Error(bad_data).
void write_png(const std::filesystem::path& path, const Image& image);
/// Throws Error(bad_data) for anything that is no PNG.
Image read_png(const std::filesystem::path& path);

}  // namespace scanchor
