#include "perception/thin_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.hpp"
#include "perception/choose_planes.hpp"
#include "perception/join_planes.hpp"
#include "perception/surfels.hpp"

namespace scanchor {
namespace {

// Everything the steps share. Labels here are of pool points; planes are numbered as in
// PlaneLabels.
struct ThinWork {
  const PointPool& pool;
  const BeamNoise& noise;
  const std::vector<Surfel>& surfels;
  std::vector<GrownPlane>& planes;
  std::vector<std::int32_t> label;
  std::vector<std::uint32_t> asked;  // the growth that last visited a leaf
  std::uint32_t asking = 0;
};

enum class Grow { claim, find };

// Takes free points within three sigma of the plane from leaf to leaf. A leaf that knows its own
// plane joins only if it continues this one. While a plane is being found it follows its points,
// and only leaves that know their plane lead on.
void grow(ThinWork& work, GrownPlane& grown, std::vector<std::uint32_t>& queue, Grow mode,
          std::vector<std::uint32_t>& members) {
  const auto& c = work.pool.cloud;
  ++work.asking;
  members.clear();
  for (const auto l : queue) work.asked[l] = work.asking;
  Moments taken;
  double fitted = grown.moments.n;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const auto l = queue[head];
    const Surfel& surfel = work.surfels[l];
    const bool knows = surfel.tilt < unknown_tilt;
    if (knows ? !continues(grown, surfel, work.noise) : mode == Grow::find) continue;
    bool any = false;
    const PlaneReach reach(grown);
    const Cell& cell = work.pool.cell(l);
    for (auto p = cell.begin; p < cell.end; ++p) {
      if (work.label[p] >= 0 || !reach.holds(c.x[p], c.y[p], c.z[p], c.inverse_range[p])) continue;
      any = true;
      members.push_back(p);
      taken.add(c.x[p], c.y[p], c.z[p]);
    }
    if (!any) continue;
    if (mode == Grow::find && taken.n >= 1.3 * fitted) {
      grown = grown_plane(taken, work.noise);
      fitted = taken.n;
    }
    for (auto k = work.pool.start[l]; k < work.pool.start[l + 1]; ++k) {
      const auto next = work.pool.to[k];
      if (work.asked[next] == work.asking) continue;
      work.asked[next] = work.asking;
      queue.push_back(next);
    }
  }
  if (mode == Grow::find && taken.n >= 6.0) grown = grown_plane(taken, work.noise);
}

// Regions of flat cells take the pool points on their planes, the largest region first.
void claim(ThinWork& work) {
  const auto& pool = work.pool;
  std::vector<std::vector<std::uint32_t>> seeds(work.planes.size());
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    for (auto k = pool.region_start[l]; k < pool.region_start[l + 1]; ++k) {
      seeds[static_cast<std::size_t>(pool.regions[k])].push_back(l);
    }
  }
  std::vector<std::uint32_t> order(work.planes.size()), members;
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return work.planes[a].moments.n > work.planes[b].moments.n;
  });
  for (const auto r : order) {
    grow(work, work.planes[r], seeds[r], Grow::claim, members);
    for (const auto p : members) work.label[p] = static_cast<std::int32_t>(r);
  }
}

// Grows from the flattest surfels first.
void find_more(ThinWork& work) {
  const auto& pool = work.pool;
  std::vector<std::uint32_t> order;
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    if (work.surfels[l].tilt < unknown_tilt) order.push_back(l);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return work.surfels[a].score > work.surfels[b].score; });
  std::vector<std::uint32_t> queue, members;
  for (const auto seed : order) {
    const Cell& cell = pool.cell(seed);
    bool free = false;
    for (auto p = cell.begin; p < cell.end; ++p) free |= work.label[p] < 0;
    if (!free) continue;
    GrownPlane grown = work.surfels[seed].grown;
    for (int round = 0; round < 2; ++round) {  // once to find the plane, once to take its points
      queue.assign(1, seed);
      grow(work, grown, queue, Grow::find, members);
    }
    if (members.size() < fewest_points / 2 ||
        work.noise.is_edge_on(grown.plane, grown.moments.mean()))
      continue;
    for (const auto p : members) work.label[p] = static_cast<std::int32_t>(work.planes.size());
    work.planes.push_back(grown);
  }
}

// A plane that was found early may hold points of one that was known better only later. The largest
// planes first, each takes what lies on it and hangs together with it from planes of fewer points;
// what is left of those follows its own points.
void overgrow(ThinWork& work, const std::vector<Moments>& fixed) {
  constexpr double most_turn = 0.83;  // cosine: a leaf that knows to look elsewhere is not asked
  // Of a leaf, in squared scatters; without the sensor the scatter across a plane is not known.
  const float most_loss = work.noise.sensor_known ? 4.0F : 3e38F;
  const auto& pool = work.pool;
  const auto& c = pool.cloud;
  std::vector<std::vector<std::uint32_t>> seeds(work.planes.size());
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    const Cell& cell = pool.cell(l);
    for (auto p = cell.begin; p < cell.end; ++p) {
      if (work.label[p] < 0) continue;
      auto& own = seeds[static_cast<std::size_t>(work.label[p])];
      if (own.empty() || own.back() != l) own.push_back(l);
    }
  }
  std::vector<std::uint32_t> order(work.planes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return work.planes[a].moments.n > work.planes[b].moments.n;
  });
  std::vector<std::uint32_t> rank(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  const std::vector<PlaneReach> reaches(work.planes.begin(), work.planes.end());
  for (const auto r : order) {
    const GrownPlane& grown = work.planes[r];
    if (grown.moments.n < static_cast<double>(fewest_points)) break;
    const PlaneReach& reach = reaches[r];
    auto& queue = seeds[r];
    ++work.asking;
    for (const auto l : queue) work.asked[l] = work.asking;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const auto l = queue[head];
      const Surfel& surfel = work.surfels[l];
      const Cell& cell = pool.cell(l);
      bool any = false;
      const bool elsewhere =
          surfel.tilt < unknown_tilt &&
          std::abs(surfel.grown.plane.normal.dot(grown.plane.normal)) < most_turn;
      // What explains its points here much better keeps them.
      float loss = 0.0F;
      const auto takes = [&](std::uint32_t p) {
        const auto label = work.label[p];
        return label != static_cast<std::int32_t>(r) &&
               (label < 0 || rank[static_cast<std::size_t>(label)] > rank[r]) &&
               reach.holds(c.x[p], c.y[p], c.z[p], c.inverse_range[p]);
      };
      for (auto p = cell.begin; p < cell.end && !elsewhere; ++p) {
        if (work.label[p] < 0 || !takes(p)) continue;
        const auto squared = [&](const PlaneReach& plane) {
          const float d =
              plane.distance(c.x[p], c.y[p], c.z[p]) / plane.scatter(c.inverse_range[p]);
          return std::min(d * d, 9.0F);
        };
        loss += squared(reach) - squared(reaches[static_cast<std::size_t>(work.label[p])]);
      }
      for (auto p = cell.begin; p < cell.end; ++p) {
        auto& label = work.label[p];
        const bool own = label == static_cast<std::int32_t>(r);
        if (!own && (elsewhere || !takes(p) || (label >= 0 && loss > most_loss))) continue;
        label = static_cast<std::int32_t>(r);
        any = true;
      }
      if (!any) continue;
      for (auto k = pool.start[l]; k < pool.start[l + 1]; ++k) {
        const auto next = pool.to[k];
        if (work.asked[next] == work.asking) continue;
        work.asked[next] = work.asking;
        queue.push_back(next);
      }
    }
  }
  std::vector<Moments> sums = fixed;
  sums.resize(work.planes.size());
  add_by_label(c, work.label, sums);
  parallel_blocks(sums.size(), 32, [&](std::size_t begin, std::size_t end) {
    for (std::size_t r = begin; r < end; ++r) {
      if (sums[r].n >= 6.0) {
        work.planes[r] = grown_plane(sums[r], work.noise);
      } else {
        work.planes[r].moments = sums[r];
      }
    }
  });
}

// Planes that meet in a leaf or in two neighbouring leaves.
std::vector<std::pair<std::int32_t, std::int32_t>> meeting_planes(
    const PointPool& pool, const std::vector<std::int32_t>& label) {
  constexpr std::size_t block = 1024;
  // Labels of each leaf, each once, from the place of its first point on.
  std::vector<std::int32_t> labels(label.size());
  std::vector<std::uint32_t> count(pool.leaf.size());
  parallel_blocks(pool.leaf.size(), block, [&](std::size_t begin, std::size_t end) {
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const Cell& cell = pool.cell(l);
      auto* const first = labels.data() + cell.begin;
      auto* last = first;
      for (auto p = cell.begin; p < cell.end; ++p) {
        if (label[p] >= 0 && std::find(first, last, label[p]) == last) *last++ = label[p];
      }
      count[l] = static_cast<std::uint32_t>(last - first);
    }
  });
  using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;
  const auto each_once = [](Pairs& some) {
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
  };
  std::vector<Pairs> found(pool.leaf.size() / block + 1);
  parallel_blocks(pool.leaf.size(), block, [&](std::size_t begin, std::size_t end) {
    auto& pairs = found[begin / block];
    std::vector<std::int32_t> here, before;
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      here.clear();
      const auto look = [&](std::int32_t one) {
        if (std::find(here.begin(), here.end(), one) == here.end()) here.push_back(one);
      };
      const auto look_at = [&](std::uint32_t leaf) {
        const auto* const first = labels.data() + pool.cell(leaf).begin;
        std::for_each(first, first + count[leaf], look);
      };
      look_at(l);
      for (auto k = pool.start[l]; k < pool.start[l + 1]; ++k) look_at(pool.to[k]);
      for (auto k = pool.region_start[l]; k < pool.region_start[l + 1]; ++k) look(pool.regions[k]);
      std::sort(here.begin(), here.end());
      if (here == before) continue;  // as next door
      before = here;
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t j = i + 1; j < here.size(); ++j) pairs.emplace_back(here[i], here[j]);
      }
    }
    each_once(pairs);
  });
  Pairs pairs;
  for (const auto& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  each_once(pairs);
  return pairs;
}

std::vector<std::pair<std::int32_t, std::int32_t>> all_pairs(
    const std::vector<GrownPlane>& planes) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      pairs.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
    }
  }
  return pairs;
}

}  // namespace

void thin_planes(const CanonicalCloud& cloud, const CellTree& tree, const BeamNoise& noise,
                 const std::vector<std::int32_t>& region_of_cell, PlaneLabels& labels,
                 const BesideThinPlanes& beside) {
  std::vector<Moments> fixed(labels.planes.size());  // of the points that flat cells settled
  const PointPool pool = point_pool(cloud, tree, labels, region_of_cell, noise.sigma);
  const std::vector<Surfel> surfels = fit_surfels(pool, noise);
  ThinWork work{pool, noise, surfels, labels.planes, {}, {}, 0};
  work.label.assign(pool.place.size(), -1);
  work.asked.assign(pool.leaf.size(), 0);
  parallel_blocks(3, 1, [&](std::size_t task, std::size_t) {
    if (task == 0) {
      claim(work);
      find_more(work);
    } else if (task == 1) {
      beside.growing();
    } else {
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (labels.of_point[i] >= 0)
          fixed[static_cast<std::size_t>(labels.of_point[i])].add(cloud.x[i], cloud.y[i],
                                                                  cloud.z[i]);
      }
    }
  });
  std::vector<std::int32_t> become;  // what each plane has become
  const auto follow = [&](const std::vector<std::int32_t>& into) {
    const auto go = [&](std::int32_t& label) {
      if (label >= 0) label = into[static_cast<std::size_t>(label)];
    };
    std::for_each(work.label.begin(), work.label.end(), go);
    if (become.empty()) {
      become = into;
    } else {
      std::for_each(become.begin(), become.end(), go);
    }
    fixed.resize(into.size());
    for (std::size_t r = 0; r < into.size(); ++r) {
      const auto target = static_cast<std::size_t>(into[r]);
      if (target == r) continue;
      fixed[target].add(fixed[r]);
      fixed[r] = Moments{};
    }
  };
  PlaneChoice choice(pool, noise);
  choice.choose(fixed, 2, work.planes, work.label);
  parallel_blocks(2, 1, [&](std::size_t task, std::size_t) {
    if (task == 0) {
      overgrow(work, fixed);
    } else {
      beside.overgrowing();
    }
  });
  choice.choose(fixed, 1, work.planes, work.label);
  follow(join_planes(meeting_planes(pool, work.label), noise, same_plane, work.planes));
  // Where the sensor is known, what it saw between two pieces tells (connect_planes.hpp).
  if (!noise.sensor_known)
    follow(join_planes(all_pairs(work.planes), noise, surely_same_plane, work.planes));
  choice.choose(fixed, 2, work.planes, work.label);

  constexpr std::size_t block = 16384;
  // Small ones are dissolved.
  std::vector<std::int32_t> left(labels.planes.size());
  for (std::size_t r = 0; r < left.size(); ++r)
    left[r] = labels.planes[r].moments.n < static_cast<double>(fewest_points)
                  ? -1
                  : static_cast<std::int32_t>(r);
  for (auto& plane : become) plane = left[static_cast<std::size_t>(plane)];
  parallel_blocks(cloud.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      auto& label = labels.of_point[i];
      if (label >= 0) label = become[static_cast<std::size_t>(label)];
    }
  });
  parallel_blocks(pool.place.size(), block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const auto label = work.label[k];
      labels.of_point[pool.place[k]] = label < 0 ? -1 : left[static_cast<std::size_t>(label)];
    }
  });
}

}  // namespace scanchor
