#include <algorithm>

#include "core/parallel.hpp"
#include "perception/perceive.hpp"
#include "perception/shape_paper.hpp"

namespace scanchor {

void find_shapes(const PointCloud& cloud, const PerceiveOptions&, Surfaces& surfaces) {
  // Surfaces come largest first: whoever is free takes the next, so the floor does not come last and alone.
  parallel_blocks(surfaces.surfaces.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      surfaces.surfaces[i].inlier_count = surfaces.surfaces[i].inliers.size();
      shape_as_paper(cloud, surfaces.surfaces[i]);
    }
  });
}

}  // namespace scanchor
