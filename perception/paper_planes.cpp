#include "perception/paper_planes.hpp"

#include <algorithm>
#include <nanoflann.hpp>
#include <numeric>
#include <queue>

#include "core/random.hpp"
#include "perception/moments.hpp"

namespace scanchor {
namespace {

// What nanoflann wants to know about a cloud.
struct CloudAdaptor {
  const CanonicalCloud& cloud;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return cloud.size(); }
  [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return axis == 0 ? cloud.x[i] : axis == 1 ? cloud.y[i] : cloud.z[i];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using KdTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, CloudAdaptor>,
                                        CloudAdaptor, 3, std::uint32_t>;

// The neighbours of every point, nearest first: "stored using a priority queue, ordered according
// to the distance".
struct NeighbourQueues {
  std::size_t k = 0;
  std::vector<std::uint32_t> point;
  std::vector<float> distance2;

  NeighbourQueues(const CanonicalCloud& cloud, std::size_t neighbours)
      : k(std::min(neighbours + 1, cloud.size())),
        point(cloud.size() * k),
        distance2(cloud.size() * k) {
    const CloudAdaptor adaptor{cloud};
    const KdTree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(16));
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const float query[3] = {cloud.x[i], cloud.y[i], cloud.z[i]};
      tree.knnSearch(query, k, &point[i * k], &distance2[i * k]);
    }
  }
};

// A candidate of the growing front: nearest first, ties by index so that the order is total.
struct Candidate {
  float distance2;
  std::uint32_t point;
  bool operator>(const Candidate& other) const {
    return distance2 != other.distance2 ? distance2 > other.distance2 : point > other.point;
  }
};
using Front = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

// "Select random seed point": the points in an order drawn from the seed, by their place in the
// canonical cloud.
std::vector<std::uint32_t> random_order(std::size_t count, std::uint64_t seed) {
  const CounterRandom random(stream_seed(seed, "paper seeds"));
  std::vector<std::uint64_t> draw(count);
  for (std::size_t i = 0; i < count; ++i) draw[i] = (std::uint64_t{random.words(i)[0]} << 32) | i;
  std::sort(draw.begin(), draw.end());
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(draw[i]);
  return order;
}

}  // namespace

std::vector<std::int32_t> paper_planes(const CanonicalCloud& cloud, double sigma,
                                       const PaperOptions& options) {
  std::vector<std::int32_t> region_of(cloud.size(), -1);
  if (cloud.size() < 3) return region_of;
  const NeighbourQueues queues(cloud, static_cast<std::size_t>(options.neighbours));
  const double delta = options.delta * sigma * sigma;
  const double gamma = options.gamma * sigma;
  std::vector<std::uint32_t> asked(cloud.size(), 0);  // the region that last looked at a point
  std::vector<std::uint32_t> members;
  std::uint32_t asking = 0;
  std::int32_t regions = 0;

  for (const auto seed : random_order(cloud.size(), options.seed)) {
    if (region_of[seed] >= 0) continue;
    ++asking;
    members.clear();
    Front front;
    front.push({0.0F, seed});
    asked[seed] = asking;
    Moments moments;  // about the seed, so that the sums stay small
    while (!front.empty()) {
      const auto candidate = front.top().point;
      front.pop();
      Moments with = moments;
      with.add(cloud.x[candidate] - cloud.x[seed], cloud.y[candidate] - cloud.y[seed],
               cloud.z[candidate] - cloud.z[seed]);
      if (with.n > 3.0) {
        const MomentPlane plane = fit_plane_fast(with);
        const Eigen::Vector3d at = (cloud.point(candidate) - cloud.point(seed)).cast<double>();
        const bool fits = plane.variances[0] < delta && std::abs(plane.distance(at)) < gamma;
        if (!fits) continue;
      }
      moments = with;
      members.push_back(candidate);
      for (std::size_t j = 0; j < queues.k; ++j) {  // merge its queue into the front
        const auto neighbour = queues.point[candidate * queues.k + j];
        if (region_of[neighbour] >= 0 || asked[neighbour] == asking) continue;
        asked[neighbour] = asking;
        front.push({queues.distance2[candidate * queues.k + j], neighbour});
      }
    }
    // A seed is spent, but the points of a region that stayed too small remain free for others.
    if (members.size() < options.minimum) continue;
    for (const auto member : members) region_of[member] = regions;
    ++regions;
  }
  return region_of;
}

}  // namespace scanchor
