#include "perception/thin_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "perception/chi_square.hpp"

namespace scanchor {
namespace {

// Everything the steps share. Labels here are of pool points; planes are numbered as in PlaneLabels.
struct Work {
  const PointPool& pool;
  double sigma;
  std::vector<GrownPlane>& planes;
  std::vector<std::int32_t> label;    // a pool point
  std::vector<std::uint32_t> asked;   // the growth that last visited a leaf
  std::uint32_t asking = 0;

  [[nodiscard]] double distance(const MomentPlane& plane, std::uint32_t p) const {
    const auto& c = pool.cloud;
    return plane.normal.x() * c.x[p] + plane.normal.y() * c.y[p] + plane.normal.z() * c.z[p] - plane.offset;
  }
};

// Takes free points within `reach` of the plane, from leaf to leaf; `refit`: the plane follows its points.
void grow(Work& work, GrownPlane& grown, std::vector<std::uint32_t>& queue, double reach, bool refit,
          std::vector<std::uint32_t>& members) {
  ++work.asking;
  members.clear();
  for (const auto l : queue) work.asked[l] = work.asking;
  double fitted = std::max(grown.moments.n, 12.0);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const auto l = queue[head];
    const Cell& cell = work.pool.cell(l);
    bool any = false;
    for (auto p = cell.begin; p < cell.end; ++p) {
      if (work.label[p] >= 0 || std::abs(work.distance(grown.plane, p)) > reach) continue;
      any = true;
      members.push_back(p);
      grown.moments.add(work.pool.cloud.x[p], work.pool.cloud.y[p], work.pool.cloud.z[p]);
    }
    if (!any) continue;
    if (refit && grown.moments.n >= 1.3 * fitted) {
      grown = grown_plane(grown.moments, work.sigma);
      fitted = grown.moments.n;
    }
    for (auto k = work.pool.start[l]; k < work.pool.start[l + 1]; ++k) {
      const auto next = work.pool.to[k];
      if (work.asked[next] == work.asking) continue;
      work.asked[next] = work.asking;
      queue.push_back(next);
    }
  }
}

// Regions of flat cells take the pool points on their planes, the largest region first.
void claim(Work& work) {
  const auto& pool = work.pool;
  std::vector<std::vector<std::uint32_t>> seeds(work.planes.size());
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    for (auto k = pool.region_start[l]; k < pool.region_start[l + 1]; ++k) {
      seeds[static_cast<std::size_t>(pool.regions[k])].push_back(l);
    }
  }
  std::vector<std::uint32_t> order(work.planes.size()), members;
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return work.planes[a].moments.n > work.planes[b].moments.n; });
  for (const auto r : order) {
    GrownPlane& grown = work.planes[r];
    grow(work, grown, seeds[r], 3.0 * grown.sigma, false, members);
    for (const auto p : members) work.label[p] = static_cast<std::int32_t>(r);
  }
}

// A plane guessed from the free points around a leaf.
struct Guess {
  std::uint32_t leaf;
  double score;
  GrownPlane grown;
};

// Fits, drops what lies beyond 2.5 sigma, fits again.
bool guess_plane(const Work& work, const std::vector<std::uint32_t>& points, Guess& guess) {
  const auto& c = work.pool.cloud;
  constexpr double tilt = 0.2, breadth = 4.0;
  const double reach = 2.5 * work.sigma, sigma2 = work.sigma * work.sigma;
  Moments moments;
  for (const auto p : points) moments.add(c.x[p], c.y[p], c.z[p]);
  for (int round = 0; round < 3; ++round) {
    if (moments.n < 8.0) return false;
    const MomentPlane plane = fit_plane_fast(moments);
    Moments next;
    double score = 0.0;
    for (const auto p : points) {
      const double r = work.distance(plane, p) / reach;
      if (std::abs(r) > 1.0) continue;
      next.add(c.x[p], c.y[p], c.z[p]);
      score += 1.0 - r * r;
    }
    guess.score = score;
    moments = next;
  }
  if (moments.n < 8.0) return false;
  guess.grown = grown_plane(moments, work.sigma);
  const auto& v = guess.grown.plane.variances;
  return v[1] >= breadth * v[0] && v[1] >= breadth * sigma2 && sigma2 <= tilt * tilt * moments.n * v[1];
}

void find_more(Work& work) {
  const auto& pool = work.pool;
  std::vector<Guess> guesses;
  std::vector<std::uint32_t> points;
  for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
    points.clear();
    const auto take = [&](std::uint32_t leaf) {
      const Cell& cell = pool.cell(leaf);
      for (auto p = cell.begin; p < cell.end; ++p) {
        if (work.label[p] < 0) points.push_back(p);
      }
    };
    take(l);
    if (points.empty()) continue;
    for (auto k = pool.start[l]; k < pool.start[l + 1]; ++k) take(pool.to[k]);
    Guess guess{l, 0.0, {}};
    if (guess_plane(work, points, guess)) guesses.push_back(guess);
  }
  std::stable_sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.score > b.score; });
  std::vector<std::uint32_t> queue, members;
  for (const auto& guess : guesses) {
    const Cell& cell = pool.cell(guess.leaf);
    bool free = false;
    for (auto p = cell.begin; p < cell.end; ++p) free |= work.label[p] < 0;
    if (!free) continue;
    GrownPlane grown = guess.grown;
    for (int round = 0; round < 2; ++round) {  // once to find the plane, once to take its points
      queue.assign(1, guess.leaf);
      GrownPlane start = grown;
      start.moments = Moments{};
      grow(work, start, queue, 2.5 * work.sigma, round == 0, members);
      if (members.size() < fewest_points) break;
      grown = grown_plane(start.moments, work.sigma);
    }
    if (members.size() < fewest_points) continue;
    for (const auto p : members) work.label[p] = static_cast<std::int32_t>(work.planes.size());
    work.planes.push_back(grown);
  }
}

// Each pool point chooses between the planes around it: least squared distance, minus the logarithm of how many of its neighbours
// chose the same (iterated conditional modes, Besag 1986). Then the planes follow their points.
void choose(Work& work, const std::vector<Moments>& fixed, int rounds) {
  const auto& pool = work.pool;
  std::vector<std::int32_t> near, next = work.label;
  std::vector<double> votes;
  for (int round = 0; round < rounds; ++round) {
    for (std::uint32_t l = 0; l < pool.leaf.size(); ++l) {
      near.clear();
      votes.clear();
      const auto vote = [&](std::int32_t label, double weight) {
        for (std::size_t i = 0; i < near.size(); ++i) {
          if (near[i] == label) {
            votes[i] += weight;
            return;
          }
        }
        near.push_back(label);
        votes.push_back(weight);
      };
      const auto ask = [&](std::uint32_t leaf) {
        const Cell& cell = pool.cell(leaf);
        for (auto p = cell.begin; p < cell.end; ++p) {
          if (work.label[p] >= 0) vote(work.label[p], 1.0);
        }
      };
      ask(l);
      for (auto k = pool.start[l]; k < pool.start[l + 1]; ++k) ask(pool.to[k]);
      for (auto k = pool.region_start[l]; k < pool.region_start[l + 1]; ++k) vote(pool.regions[k], 4.0);
      const Cell& cell = pool.cell(l);
      for (auto p = cell.begin; p < cell.end; ++p) {
        double best = 4.5;  // beyond 3 sigma nothing is chosen
        std::int32_t chosen = -1;
        double best_cost = 1e300;
        for (std::size_t i = 0; i < near.size(); ++i) {
          const GrownPlane& grown = work.planes[static_cast<std::size_t>(near[i])];
          const double r = work.distance(grown.plane, p) / grown.sigma;
          const double fit = 0.5 * r * r;
          if (fit > best) continue;
          const double cost = fit + std::log(grown.sigma) - std::log(votes[i]);
          if (cost < best_cost || (cost == best_cost && near[i] < chosen)) {
            best_cost = cost;
            chosen = near[i];
          }
        }
        next[p] = chosen;
      }
    }
    work.label = next;
    std::vector<Moments> sums = fixed;
    sums.resize(work.planes.size());
    for (std::uint32_t p = 0; p < work.label.size(); ++p) {
      if (work.label[p] < 0) continue;
      sums[static_cast<std::size_t>(work.label[p])].add(pool.cloud.x[p], pool.cloud.y[p], pool.cloud.z[p]);
    }
    for (std::size_t r = 0; r < work.planes.size(); ++r) {
      if (sums[r].n >= 6.0) work.planes[r] = grown_plane(sums[r], work.sigma);
      else work.planes[r].moments = sums[r];
    }
  }
}

}  // namespace

void thin_planes(const CanonicalCloud& cloud, const CellTree& tree, double sigma,
                 const std::vector<std::int32_t>& region_of_cell, PlaneLabels& labels) {
  const PointPool pool = point_pool(cloud, tree, labels, region_of_cell);
  Work work{pool, sigma, labels.planes, {}, {}, 0};
  work.label.assign(pool.place.size(), -1);
  work.asked.assign(pool.leaf.size(), 0);
  std::vector<Moments> fixed(labels.planes.size());  // of the points that flat cells settled
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (labels.of_point[i] >= 0) fixed[static_cast<std::size_t>(labels.of_point[i])].add(cloud.x[i], cloud.y[i], cloud.z[i]);
  }
  claim(work);
  find_more(work);
  choose(work, fixed, 3);

  for (std::size_t k = 0; k < pool.place.size(); ++k) labels.of_point[pool.place[k]] = work.label[k];
  for (auto& label : labels.of_point) {
    if (label >= 0 && labels.planes[static_cast<std::size_t>(label)].moments.n < static_cast<double>(fewest_points)) label = -1;
  }
}

}  // namespace scanchor
