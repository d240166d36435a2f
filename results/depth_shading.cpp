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
  const std::array<std::array<int, 2>, 4> ways = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  parallel_blocks(std::size_t(h), 16, [&](std::size_t begin, std::size_t end) {
    for (int y = int(begin); y < int(end); ++y) {
      for (int x = 0; x < w; ++x) {
        const std::size_t here = std::size_t(y) * std::size_t(w) + std::size_t(x);
        const float distance = frame.distance[here];
        if (distance == 0.0F) continue;
        const float center = inverse[here];
        const float px_per_m = float(parallel ? pixels_per_metre : pixels_per_metre / distance);
        float dark = 0.0F;
        for (const int radius : radii) {
          const float weight = 2.0F / (1.0F + float(radius));
          for (const auto& way : ways) {
            const int dx = way[0] * radius;
            const int dy = way[1] * radius;
            const int xa = x - dx, xb = x + dx, ya = y - dy, yb = y + dy;
            if (xa < 0 || xb >= w || std::min(ya, yb) < 0 || std::max(ya, yb) >= h) continue;
            const std::size_t a = std::size_t(ya) * std::size_t(w) + std::size_t(xa);
            const std::size_t b = std::size_t(yb) * std::size_t(w) + std::size_t(xb);
            if (frame.distance[a] == 0.0F || frame.distance[b] == 0.0F) continue;
            const float ahead = (inverse[a] + inverse[b]) * 0.5F - center;
            if (ahead <= 0.0F) continue;
            // [m] that the neighbours stand in front, against the distance to them across the
            // picture.
            const float in_front = (parallel ? ahead : ahead * distance * distance) - noise;
            if (in_front <= 0.0F) continue;
            const float across = float(radius) / px_per_m;
            const float angle = std::min(1.0F, in_front / across);
            // Something far in front is another thing, not a crease: let it fade.
            dark += weight * angle / (1.0F + 4.0F * in_front);
          }
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
