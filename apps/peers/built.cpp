#include "apps/peers/peers.hpp"
#include "bench/peers/peer.hpp"

namespace scanchor::apps {
namespace {

using Labels = peers::Labels (*)(const peers::Points&, const peers::PeerOptions&);

/// Points without a position are no points for a library that does not look: they get no region.
PlaneFinder finder(Labels labels) {
  return [labels](const PointCloud& cloud, double sigma) {
    peers::Points points;
    std::vector<std::size_t> place;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto& p = cloud.points[i];
      if (!p.allFinite()) continue;
      points.push_back({p.x(), p.y(), p.z()});
      place.push_back(i);
    }
    peers::PeerOptions options;
    options.sigma = sigma;
    const peers::Labels found = labels(points, options);
    std::vector<std::int32_t> region(cloud.size(), -1);
    for (std::size_t k = 0; k < place.size(); ++k) region[place[k]] = found[k];
    return region;
  };
}

}  // namespace

const std::vector<Peer>& built_peers() {
  static const std::vector<Peer> list = {
      {"cgal-region-growing", finder(peers::cgal_region_growing)},
      {"cgal-ransac", finder(peers::cgal_efficient_ransac)},
#ifdef SCANCHOR_HAVE_PCL
      {"pcl-region-growing", finder(peers::pcl_region_growing)},
#endif
  };
  return list;
}

}  // namespace scanchor::apps
