#include "results/depth_shading.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"

namespace scanchor {

void shade_by_depth(Frame& frame, double strength, double pixels_per_metre, bool parallel,
                    bool fine) {
  if (strength <= 0.0) return;
  const int w = frame.image.width;
  const int h = frame.image.height;
  std::vector<float> inverse(frame.distance.size());
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    const float d = frame.distance[i];
    // A parallel projection's depth is linear over a plane itself: -d keeps "nearer is larger".
    inverse[i] = d == 0.0F ? 0.0F : parallel ? -d : 1.0F / d;
  }
  const std::array<int, 3> radii = fine ? std::array<int, 3>{1, 2, 3} : std::array<int, 3>{1, 4, 9};
  // Neighbouring points of one surface differ by the sensor's noise, which is no shape.
  const float noise = fine ? 0.03F : 0.0F;
  struct Pair {
    int dx, dy;
    std::ptrdiff_t step;           // to the one neighbour; to the other it is -step
    float weight, inverse_radius;  // of the pair
  };
  std::vector<Pair> pairs;
  for (const int radius : radii) {
    for (const auto& way : {std::array{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
      const int dx = way[0] * radius, dy = way[1] * radius;
      pairs.push_back({dx, dy, std::ptrdiff_t(dy) * w + dx, 2.0F / (1.0F + float(radius)),
                       1.0F / float(radius)});
    }
  }
  parallel_blocks(std::size_t(h), 16, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y) {
      for (int x = 0; x < w; ++x) {
        const std::size_t here = std::size_t(y) * std::size_t(w) + std::size_t(x);
        const float distance = frame.distance[here];
        if (distance == 0.0F) continue;
        const float* at = &inverse[here];
        const float center = *at;
        const float px_per_m = float(parallel ? pixels_per_metre : pixels_per_metre / distance);
        const float to_metres = parallel ? 1.0F : distance * distance;
        const bool inside =
            x >= radii.back() && x + radii.back() < w && y >= radii.back() && y + radii.back() < h;
        float dark = 0.0F;
        for (const Pair& pair : pairs) {
          if (!inside && (x < pair.dx || x + pair.dx >= w || y < std::abs(pair.dy) ||
                          y + std::abs(pair.dy) >= h))
            continue;
          const float before = at[-pair.step], after = at[pair.step];
          if (before == 0.0F || after == 0.0F) continue;
          // [m] that the neighbours stand in front, against the distance to them across the
          // picture.
          const float in_front = ((before + after) * 0.5F - center) * to_metres - noise;
          if (in_front <= 0.0F) continue;
          const float angle = std::min(1.0F, in_front * px_per_m * pair.inverse_radius);
          // Something far in front is another thing, not a crease: let it fade.
          dark += pair.weight * angle / (1.0F + 4.0F * in_front);
        }
        const float shade = 1.0F / (1.0F + float(strength) * (fine ? 0.22F : 0.10F) * dark);
        for (std::size_t c = 0; c < 3; ++c) {
          std::uint8_t& value = frame.image.rgb[3 * here + c];
          value = std::uint8_t(float(value) * shade + 0.5F);
        }
      }
    }
  });
}

}  // namespace scanchor
