#include "results/image.hpp"

#include <png.h>

#include <algorithm>
#include <cstring>

#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {

std::string png_bytes(const Image& image) {
  const std::size_t wanted = std::size_t(3) * std::size_t(std::max(image.width, 0)) *
                             std::size_t(std::max(image.height, 0));
  if (wanted == 0 || image.rgb.size() != wanted) {
    fail_data("", "",
              "a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                  " pixels with " + std::to_string(image.rgb.size()) + " bytes cannot be written");
  }
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  header.width = png_uint_32(image.width);
  header.height = png_uint_32(image.height);
  header.format = PNG_FORMAT_RGB;
  // zlib never makes more than this of it, so one pass is enough.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) ==
      0) {
    fail_data("", "", std::string("the PNG library refused: ") + header.message);
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  write_file(path, png_bytes(image));
}

Image smaller(const Image& image, int factor) {
  Image result{image.width / factor, image.height / factor, {}};
  result.rgb.reserve(3 * std::size_t(result.width) * std::size_t(result.height));
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        int sum = 0;
        for (int dy = 0; dy < factor; ++dy) {
          for (int dx = 0; dx < factor; ++dx) {
            sum += image.rgb[3 * (std::size_t(y * factor + dy) * std::size_t(image.width) +
                                  std::size_t(x * factor + dx)) +
                             std::size_t(c)];
          }
        }
        result.rgb.push_back(std::uint8_t((sum + factor * factor / 2) / (factor * factor)));
      }
    }
  }
  return result;
}

Image read_png(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
    fail_data(path.string(), "", std::string("no PNG: ") + header.message);
  }
  header.format = PNG_FORMAT_RGB;
  Image image;
  image.width = int(header.width);
  image.height = int(header.height);
  image.rgb.resize(PNG_IMAGE_SIZE(header));
  if (png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr) == 0) {
    fail_data(path.string(), "", std::string("damaged PNG: ") + header.message);
  }
  return image;
}

}  // namespace scanchor
