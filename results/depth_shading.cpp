#include "results/depth_shading.hpp"

#include <Eigen/Core>
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
  // Background lies so far back that no pair with it stands in front of anything.
  constexpr float far_back = -1e9F;
  std::vector<float> inverse(frame.distance.size());
  for (std::size_t i = 0; i < inverse.size(); ++i) {
    const float d = frame.distance[i];
    // A parallel projection's depth is linear over a plane itself: -d keeps "nearer is larger".
    inverse[i] = d == 0.0F ? far_back : parallel ? -d : 1.0F / d;
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
    using Row = Eigen::ArrayXf;
    Row px_per_m(w), to_metres(w), dark(w), in_front(w);
    for (int y = int(begin); y < int(end); ++y) {
      const std::size_t first = std::size_t(y) * std::size_t(w);
      const float* row = &inverse[first];
      const Eigen::Map<const Row> distance(&frame.distance[first], w);
      if (parallel) {
        px_per_m.setConstant(float(pixels_per_metre));
        to_metres.setOnes();
      } else {
        px_per_m = float(pixels_per_metre) / distance.max(1e-6F);
        to_metres = distance.square();
      }
      dark.setZero();
      for (const Pair& pair : pairs) {
        const int n = w - 2 * pair.dx;
        if (n <= 0 || y < std::abs(pair.dy) || y + std::abs(pair.dy) >= h) continue;
        const float* at = row + pair.dx;
        const Eigen::Map<const Row> center(at, n), before(at - pair.step, n),
            after(at + pair.step, n);
        auto front = in_front.head(n);
        // [m] that the neighbours stand in front, against the distance to them across the picture.
        front =
            (((before + after) * 0.5F - center) * to_metres.segment(pair.dx, n) - noise).max(0.0F);
        // Something far in front is another thing, not a crease: let it fade.
        dark.segment(pair.dx, n) +=
            pair.weight * (front * px_per_m.segment(pair.dx, n) * pair.inverse_radius).min(1.0F) /
            (1.0F + 4.0F * front);
      }
      for (int x = 0; x < w; ++x) {
        if (distance[x] == 0.0F) continue;
        const float shade = 1.0F / (1.0F + float(strength) * (fine ? 0.22F : 0.10F) * dark[x]);
        for (std::size_t c = 0; c < 3; ++c) {
          std::uint8_t& value = frame.image.rgb[3 * (first + std::size_t(x)) + c];
          value = std::uint8_t(float(value) * shade + 0.5F);
        }
      }
    }
  });
}

}  // namespace scanchor
