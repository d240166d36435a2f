#include "perception/choose_planes.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

// What a plane means to a point, in the type of the points.
struct Candidate {
  std::int32_t id;
  float votes;
  PlaneReach reach;
  float cost;
};

class Ballot {
 public:
  explicit Ballot(const std::vector<GrownPlane>& planes) : planes_(planes) {}
  void clear() { candidates_.clear(); }
  void vote(std::int32_t id, float weight) {
    for (auto& candidate : candidates_) {
      if (candidate.id == id) {
        candidate.votes += weight;
        return;
      }
    }
    candidates_.push_back({id, weight, PlaneReach(planes_[static_cast<std::size_t>(id)]), 0.0F});
  }
  void count() {
    for (auto& candidate : candidates_) candidate.cost = -std::log(candidate.votes);
  }
  [[nodiscard]] std::int32_t best(float x, float y, float z, float inverse_range) const {
    std::int32_t chosen = -1;
    float least = 3e38F;
    for (const auto& k : candidates_) {
      const float s = k.reach.scatter(inverse_range);
      const float r = k.reach.distance(x, y, z) / s;
      if (r > 3.0F) continue;
      const float cost = 0.5F * r * r + std::log(s) + k.cost;
      if (cost < least || (cost == least && k.id < chosen)) {
        least = cost;
        chosen = k.id;
      }
    }
    return chosen;
  }

 private:
  const std::vector<GrownPlane>& planes_;
  std::vector<Candidate> candidates_;
};

}  // namespace

void choose_planes(const PointPool& pool, const BeamNoise& noise, const std::vector<Moments>& fixed,
                   int rounds, std::vector<GrownPlane>& planes, std::vector<std::int32_t>& label) {
  constexpr float flat_votes =
      4.0F;  // a flat cell next door speaks for as many points as a leaf holds
  const auto& c = pool.cloud;
  std::vector<std::int32_t> next = label;
  for (int round = 0; round < rounds; ++round) {
    parallel_blocks(pool.leaf.size(), 512, [&](std::size_t begin, std::size_t end) {
      Ballot ballot(planes);
      for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
        ballot.clear();
        const auto ask = [&](std::uint32_t leaf) {
          const Cell& cell = pool.cell(leaf);
          for (auto p = cell.begin; p < cell.end; ++p) {
            if (label[p] >= 0) ballot.vote(label[p], 1.0F);
          }
        };
        ask(l);
        for (auto k = pool.start[l]; k < pool.start[l + 1]; ++k) ask(pool.to[k]);
        for (auto k = pool.region_start[l]; k < pool.region_start[l + 1]; ++k)
          ballot.vote(pool.regions[k], flat_votes);
        ballot.count();
        const Cell& cell = pool.cell(l);
        for (auto p = cell.begin; p < cell.end; ++p)
          next[p] = ballot.best(c.x[p], c.y[p], c.z[p], c.inverse_range[p]);
      }
    });
    label.swap(next);
    std::vector<Moments> sums = fixed;
    sums.resize(planes.size());
    for (std::uint32_t p = 0; p < label.size(); ++p) {
      if (label[p] >= 0) sums[static_cast<std::size_t>(label[p])].add(c.x[p], c.y[p], c.z[p]);
    }
    for (std::size_t r = 0; r < planes.size(); ++r) {
      if (sums[r].n >= 6.0) {
        planes[r] = grown_plane(sums[r], noise);
      } else {
        planes[r].moments = sums[r];
      }
    }
  }
}

}  // namespace scanchor
