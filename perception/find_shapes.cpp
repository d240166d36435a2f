#include <atomic>
#include <memory>

#include "core/parallel.hpp"
#include "perception/perceive.hpp"
#include "perception/shape_default.hpp"
#include "perception/shape_paper.hpp"

namespace scanchor {

void find_shapes(const PointCloud& cloud, const PerceiveOptions& options, Surfaces& surfaces) {
  // In a merged cloud nobody knows which position saw which point, so the rays are not known
  // either.
  std::unique_ptr<ShapeView> view;
  if (options.method != "paper") {
    if (surfaces.sensor_positions.size() == 1) {
      view = std::make_unique<ShapeView>(cloud, surfaces.sensor_positions.front(),
                                         surfaces.plane_of_point);
    }
  }
  // Surfaces come largest first: whoever is free takes the next, so that no thread is left alone
  // with the floor.
  std::atomic<std::size_t> next{0};
  parallel_blocks(surfaces.surfaces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = next.fetch_add(1);
      Surface& surface = surfaces.surfaces[i];
      surface.inlier_count = surface.inliers.size();
      if (options.method == "paper") {
        shape_as_paper(cloud, surface);
      } else {
        shape_surface(cloud, view.get(), surfaces, surface);
      }
    }
  });
}

}  // namespace scanchor
