#pragma once
// Other people's plane finders behind one interface, so that anyone can print the comparison on
// their own clouds.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace scanchor::peers {

/// What a peer is told. The libraries derive nothing from the data, so the numbers they need come
/// from here; each peer's source says how it uses them. The defaults are the best of a sweep on the
/// reference room at 100,000 points and 1 cm noise.
struct PeerOptions {
  double sigma = 0.01;       ///< [m] range noise
  int neighbours = 24;       ///< of the normal estimation
  std::size_t minimum = 20;  ///< points of a region
};

using Points = std::vector<std::array<double, 3>>;

/// Region of each point, -1: none.
using Labels = std::vector<std::int32_t>;

Labels cgal_region_growing(const Points& points, const PeerOptions& options);
Labels cgal_efficient_ransac(const Points& points, const PeerOptions& options);
/// In the build only where libpcl-dev is (SCANCHOR_HAVE_PCL).
Labels pcl_region_growing(const Points& points, const PeerOptions& options);

}  // namespace scanchor::peers
