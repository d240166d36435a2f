#include "perception/cell_planes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/parallel.hpp"

#include "perception/chi_square.hpp"
#include "perception/join_planes.hpp"

namespace scanchor {
namespace {

// A real wall is not a mathematical plane and a noise estimate is not exact: a fifth more scatter
// than noise still counts as flat.
constexpr double cell_slack = 1.2 * 1.2;
constexpr double z_flat =
    3.09;  // one flat cell in a thousand is turned away and then looked at point by point

struct FlatCell {
  std::uint32_t cell;
  MomentPlane plane;
};

// Flat within the noise, and broad enough in both directions that its normal means something: known
// to 0.1 rad (one sigma) and at least 2.5 sigma in standard deviation, so that noise cannot pass
// for width.
bool is_flat(const Moments& moments, const BeamNoise& noise, MomentPlane& plane) {
  constexpr double fewest = 6.0, breadth = 6.25, tilt = 0.1;
  if (moments.n < fewest) return false;
  const Eigen::Vector3d variances = plane_variances_fast(moments);
  const double freedom = moments.n - 3.0, sigma2 = noise.sigma * noise.sigma;
  if (variances[1] < breadth * sigma2 || variances[1] < breadth * variances[0]) return false;
  // Across no plane is there more noise than along the beam: most cells end here.
  if (variances[0] * moments.n > cell_slack * sigma2 * freedom * chi_square_factor(freedom, z_flat))
    return false;
  plane = fit_plane_fast(moments);
  const double across = noise.across(plane, moments.mean()), across2 = across * across;
  return plane.variances[0] * moments.n <=
             cell_slack * across2 * freedom * chi_square_factor(freedom, z_flat) &&
         across2 <= tilt * tilt * moments.n * plane.variances[1];
}

// The largest flat cells, from the root down.
std::vector<FlatCell> flat_cells(const CellTree& tree, const BeamNoise& noise,
                                 std::vector<std::int32_t>& flat_of_cell) {
  constexpr std::size_t block = 512;
  std::vector<FlatCell> flat;
  std::vector<char> open(tree.cells.size(), 0);
  open[0] = 1;
  flat_of_cell.assign(tree.cells.size(), -1);
  for (std::size_t from = 0, to = 0; from < tree.cells.size(); from = to) {  // level by level
    while (to < tree.cells.size() && tree.cells[to].level == tree.cells[from].level) ++to;
    std::vector<std::vector<FlatCell>> found((to - from + block - 1) / block);
    parallel_blocks(to - from, block, [&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<std::uint32_t>(from + begin); i < from + end; ++i) {
        if (open[i] == 0) continue;
        FlatCell candidate{i, {}};
        if (is_flat(tree.moments[i], noise, candidate.plane)) {
          found[begin / block].push_back(candidate);
          continue;
        }
        const Cell& cell = tree.cells[i];
        for (std::uint32_t c = 0; c < cell.children; ++c) open[cell.child + c] = 1;
      }
    });
    for (const auto& some : found) flat.insert(flat.end(), some.begin(), some.end());
  }
  for (std::size_t f = 0; f < flat.size(); ++f)
    flat_of_cell[flat[f].cell] = static_cast<std::int32_t>(f);
  return flat;
}

// Pairs of flat cells that touch, found from the smaller (or equal) one.
struct Links {
  std::vector<std::uint32_t> start, to;
};

Links link(const CanonicalCloud& cloud, const CellTree& tree, const std::vector<FlatCell>& flat,
           const std::vector<std::int32_t>& flat_of_cell) {
  constexpr std::size_t block = 128;
  std::vector<std::vector<std::uint64_t>> found(flat.size() / block + 1);
  const auto is_flat_cell = [&](std::uint32_t at) { return flat_of_cell[at] >= 0; };
  parallel_blocks(flat.size(), block, [&](std::size_t begin, std::size_t end) {
    auto& here = found[begin / block];
    std::array<std::uint64_t, 26> codes;
    for (auto f = static_cast<std::uint32_t>(begin); f < end; ++f) {
      const int level = tree.cells[flat[f].cell].level;
      const int count = tree.neighbour_codes(cloud, flat[f].cell, codes);
      std::int32_t last = -1;
      for (int k = 0; k < count; ++k) {
        const auto at = tree.find(codes[static_cast<std::size_t>(k)], level, is_flat_cell);
        if (at == CellTree::none || flat_of_cell[at] < 0 || flat_of_cell[at] == last) continue;
        last = flat_of_cell[at];
        const auto g = static_cast<std::uint32_t>(last);
        here.push_back(std::uint64_t{f} << 32 | g);
        here.push_back(std::uint64_t{g} << 32 | f);
      }
    }
  });
  std::vector<std::uint64_t> pairs;
  for (const auto& here : found) pairs.insert(pairs.end(), here.begin(), here.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Links links;
  links.start.assign(flat.size() + 1, 0);
  for (const auto pair : pairs) {
    ++links.start[(pair >> 32) + 1];
    links.to.push_back(static_cast<std::uint32_t>(pair));
  }
  std::partial_sum(links.start.begin(), links.start.end(), links.start.begin());
  return links;
}

// Does a cell continue the plane of a region? Its mean square distance must be noise, where the
// plane itself is uncertain by sigma^2/n (1 + u^2/l1 + v^2/l2) so far out.
bool continues(const GrownPlane& region, const Moments& cell, const BeamNoise& noise) {
  const Eigen::Vector3d at = cell.mean(), out = at - region.moments.mean();
  const double across = noise.across(region.plane, at);
  const double n = region.moments.n, sigma2 = across * across;
  const double u = region.plane.axes.col(1).dot(out), v = region.plane.axes.col(2).dot(out);
  const double leverage = (1.0 + u * u / std::max(region.plane.variances[1], 1e-30) +
                           v * v / std::max(region.plane.variances[2], 1e-30)) /
                          n;
  // The mean of many points tells a step that is lost in their scatter.
  if (std::abs(region.plane.distance(at)) >
      3.0 * across * std::sqrt(1.0 / cell.n + std::min(leverage, 1.0)) + 0.25 * noise.sigma)
    return false;
  return region.plane.mean_square(cell) <=
         cell_slack * sigma2 * (chi_square_factor(cell.n, z_flat) + 4.0 * std::min(leverage, 1.0));
}

}  // namespace

GrownPlane grown_plane(const Moments& moments, const BeamNoise& noise) {
  return grown_plane(moments, fit_plane_fast(moments), noise);
}

GrownPlane grown_plane(const Moments& moments, const MomentPlane& plane, const BeamNoise& noise) {
  GrownPlane grown;
  grown.moments = moments;
  grown.plane = plane;
  const double n = moments.n;
  const double across = noise.across(grown.plane, moments.mean());
  const double scatter =
      n > 3.0 ? std::sqrt(grown.plane.variances[0] * n / (n - 3.0)) / across : 1.0;
  const double excess = std::clamp(scatter, noise.sensor_known ? 1.0 : 0.25, 1.2);
  grown.sigma = excess * across;
  grown.least = excess * noise.sigma * (noise.sensor_known ? BeamNoise::grazing : 1.0);
  if (noise.sensor_known)
    grown.height = excess * noise.sigma * std::abs(grown.plane.distance(noise.sensor));
  return grown;
}

// A counting sort in a few blocks: `next` of a block and a plane is where the block's points of it
// go. `runs` calls its last argument for pieces of a range that lie on one plane.
template <class Runs>
void PlaneMembers::gather(const std::vector<std::int32_t>& of_point, std::size_t planes,
                          const Runs& runs) {
  start_.resize(planes + 1);
  const std::size_t block = std::max<std::size_t>(16384, of_point.size() / 16 + 1);
  std::vector<std::vector<std::uint32_t>> next(of_point.size() / block + 1);
  parallel_blocks(of_point.size(), block, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> count(planes, 0);
    runs(begin, end, [&](std::size_t plane, std::size_t from, std::size_t to) {
      count[plane] += static_cast<std::uint32_t>(to - from);
    });
    next[begin / block] = std::move(count);
  });
  std::uint32_t sum = 0;
  for (std::size_t r = 0; r < planes; ++r) {
    start_[r] = sum;
    for (auto& here : next) {
      if (!here.empty()) sum += std::exchange(here[r], sum);
    }
  }
  start_[planes] = sum;
  points_.resize(sum);
  parallel_blocks(of_point.size(), block, [&](std::size_t begin, std::size_t end) {
    auto& place = next[begin / block];
    runs(begin, end, [&](std::size_t plane, std::size_t from, std::size_t to) {
      auto* const first = points_.data() + place[plane];
      for (std::size_t i = from; i < to; ++i) first[i - from] = static_cast<std::uint32_t>(i);
      place[plane] += static_cast<std::uint32_t>(to - from);
    });
  });
}

// In the canonical order the points of a plane lie next to each other.
PlaneMembers::PlaneMembers(const PlaneLabels& labels) {
  const auto& of_point = labels.of_point;
  gather(of_point, labels.planes.size(), [&](std::size_t begin, std::size_t end, const auto& run) {
    for (std::size_t from = begin, to = begin; from < end; from = to) {
      const auto plane = of_point[from];
      while (to < end && of_point[to] == plane) ++to;
      if (plane >= 0) run(static_cast<std::size_t>(plane), from, to);
    }
  });
}

PlaneMembers::PlaneMembers(const std::vector<std::int32_t>& of_point, std::size_t planes) {
  gather(of_point, planes, [&](std::size_t begin, std::size_t end, const auto& run) {
    for (std::size_t i = begin; i < end; ++i) {
      if (of_point[i] >= 0) run(static_cast<std::size_t>(of_point[i]), i, i + 1);
    }
  });
}

PlaneLabels cell_planes(const CanonicalCloud& cloud, const CellTree& tree, const BeamNoise& noise,
                        std::vector<std::int32_t>& region_of_cell) {
  PlaneLabels labels;
  labels.of_point.assign(cloud.size(), -1);
  region_of_cell.assign(tree.cells.size(), -1);
  if (tree.cells.empty()) return labels;
  std::vector<std::int32_t> flat_of_cell;
  const auto flat = flat_cells(tree, noise, flat_of_cell);
  const Links links = link(cloud, tree, flat, flat_of_cell);

  std::vector<std::uint32_t> order(flat.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return tree.moments[flat[a].cell].n > tree.moments[flat[b].cell].n;
  });
  std::vector<std::int32_t> region(flat.size(), -1);
  std::vector<std::uint32_t> queue;
  std::vector<GrownPlane> planes;
  for (const auto seed : order) {
    if (region[seed] >= 0) continue;
    const auto id = static_cast<std::int32_t>(planes.size());
    GrownPlane grown = grown_plane(tree.moments[flat[seed].cell], noise);
    double fitted = grown.moments.n;
    region[seed] = id;
    queue.assign(1, seed);
    for (std::size_t head = 0; head < queue.size(); ++head) {
      for (auto k = links.start[queue[head]]; k < links.start[queue[head] + 1]; ++k) {
        const auto next = links.to[k];
        if (region[next] >= 0) continue;
        const Moments& cell = tree.moments[flat[next].cell];
        if (!continues(grown, cell, noise)) continue;
        region[next] = id;
        queue.push_back(next);
        grown.moments.add(cell);
        if (grown.moments.n >= 1.25 * fitted) {
          grown = grown_plane(grown.moments, noise);
          fitted = grown.moments.n;
        }
      }
    }
    planes.push_back(grown_plane(grown.moments, noise));
  }

  // Join what grew from two seeds; a region's number is smaller the larger its seed was.
  std::vector<std::pair<std::int32_t, std::int32_t>> touching;
  for (std::uint32_t f = 0; f < flat.size(); ++f) {
    for (auto k = links.start[f]; k < links.start[f + 1]; ++k) {
      const auto a = region[f], b = region[links.to[k]];
      if (a < b) touching.emplace_back(a, b);
    }
  }
  std::sort(touching.begin(), touching.end());
  touching.erase(std::unique(touching.begin(), touching.end()), touching.end());
  const auto into = join_planes(touching, noise, same_plane, planes);
  std::vector<std::int32_t> number(planes.size(), -1);
  for (std::size_t r = 0; r < planes.size(); ++r) {
    if (into[r] != static_cast<std::int32_t>(r)) continue;
    number[r] = static_cast<std::int32_t>(labels.planes.size());
    labels.planes.push_back(planes[r]);
  }
  parallel_blocks(flat.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto id = number[static_cast<std::size_t>(into[static_cast<std::size_t>(region[f])])];
      region_of_cell[flat[f].cell] = id;
      const PlaneReach reach(labels.planes[static_cast<std::size_t>(id)]);
      const Cell& cell = tree.cells[flat[f].cell];
      for (auto p = cell.begin; p < cell.end; ++p) {
        if (reach.holds(cloud.x[p], cloud.y[p], cloud.z[p], cloud.inverse_range[p]))
          labels.of_point[p] = id;
      }
    }
  });
  return labels;
}

}  // namespace scanchor
