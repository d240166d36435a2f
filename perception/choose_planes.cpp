#include "perception/choose_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.hpp"

namespace scanchor {

void add_by_label(const CanonicalCloud& cloud, const std::vector<std::int32_t>& label,
                  std::vector<Moments>& sums) {
  // Each task looks at all labels and takes the planes of its own: no sum changes its order.
  constexpr std::size_t tasks = 2;
  parallel_blocks(tasks, 1, [&](std::size_t task, std::size_t) {
    for (std::size_t p = 0; p < label.size(); ++p) {
      const auto r = static_cast<std::size_t>(label[p]);
      if (label[p] >= 0 && r % tasks == task) sums[r].add(cloud.x[p], cloud.y[p], cloud.z[p]);
    }
  });
}

/// Candidates of one leaf, and the choice of a point between them.
class PlaneChoice::Ballot {
 public:
  explicit Ballot(const std::vector<PlaneReach>& reach) : reach_(reach) {}
  void set(const Vote* first, std::size_t count) {
    candidates_.assign(first, first + count);
    cost_.clear();
  }
  void vote(std::int32_t id, float weight) {
    for (auto& candidate : candidates_) {
      if (candidate.id == id) {
        candidate.votes += weight;
        return;
      }
    }
    candidates_.push_back({id, weight});
  }
  [[nodiscard]] const std::vector<Vote>& candidates() const { return candidates_; }

  std::int32_t best(float x, float y, float z, float inverse_range) {
    in_reach_.clear();
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      const auto& reach = reach_[static_cast<std::size_t>(candidates_[k].id)];
      const float s = reach.scatter(inverse_range);
      const float r = reach.distance(x, y, z) / s;
      if (!(r > 3.0F)) in_reach_.push_back({k, r, s});
    }
    if (in_reach_.empty()) return -1;
    if (in_reach_.size() == 1) return candidates_[in_reach_[0].candidate].id;  // nothing to weigh
    if (cost_.empty()) {
      for (const auto& candidate : candidates_) cost_.push_back(-std::log(candidate.votes));
    }
    std::int32_t chosen = -1;
    float least = 3e38F;
    for (const auto& near : in_reach_) {
      const auto id = candidates_[near.candidate].id;
      const float cost =
          0.5F * near.scatters * near.scatters + std::log(near.scatter) + cost_[near.candidate];
      if (cost < least || (cost == least && id < chosen)) {
        least = cost;
        chosen = id;
      }
    }
    return chosen;
  }

 private:
  struct InReach {
    std::size_t candidate;
    float scatters, scatter;  // distance in scatters of the plane, and one of those [m]
  };
  const std::vector<PlaneReach>& reach_;
  std::vector<Vote> candidates_;
  std::vector<float> cost_;  // of each candidate's votes; empty: nobody asked
  std::vector<InReach> in_reach_;
};

PlaneChoice::PlaneChoice(const PointPool& pool, const BeamNoise& noise)
    : pool_(pool),
      noise_(noise),
      changed_(pool.leaf.size(), 1),
      candidates_(kept * pool.leaf.size()),
      candidate_count_(pool.leaf.size(), not_kept) {}

void PlaneChoice::count_votes(const std::vector<std::int32_t>& label) {
  constexpr std::size_t block = 1024;
  const std::size_t leaves = pool_.leaf.size();
  std::vector<std::uint32_t> start(leaves + 1, 0);
  std::vector<std::vector<Vote>> found((leaves + block - 1) / block);
  parallel_blocks(leaves, block, [&](std::size_t begin, std::size_t end) {
    auto& here = found[begin / block];
    for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
      const std::size_t first = here.size();
      const Cell& cell = pool_.cell(l);
      for (auto p = cell.begin; p < cell.end; ++p) {
        if (label[p] < 0) continue;
        std::size_t at = first;
        while (at < here.size() && here[at].id != label[p]) ++at;
        if (at == here.size()) here.push_back({label[p], 0.0F});
        here[at].votes += 1.0F;
      }
      start[l + 1] = static_cast<std::uint32_t>(here.size() - first);
      if (!start_.empty())
        changed_[l] = !std::equal(here.begin() + static_cast<std::ptrdiff_t>(first), here.end(),
                                  votes_.begin() + start_[l], votes_.begin() + start_[l + 1]);
    }
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  start_.swap(start);
  votes_.clear();
  for (const auto& here : found) votes_.insert(votes_.end(), here.begin(), here.end());
}

void PlaneChoice::count_around(std::uint32_t leaf, Ballot& ballot) {
  constexpr float flat_votes =
      4.0F;  // a flat cell next door speaks for as many points as a leaf holds
  bool stale = candidate_count_[leaf] == not_kept || changed_[leaf] != 0;
  for (auto k = pool_.start[leaf]; k < pool_.start[leaf + 1] && !stale; ++k)
    stale = changed_[pool_.to[k]] != 0;
  Vote* const kept_here = candidates_.data() + kept * leaf;
  if (!stale) {
    ballot.set(kept_here, candidate_count_[leaf]);
    return;
  }
  ballot.set(nullptr, 0);
  const auto ask = [&](std::uint32_t other) {
    for (auto k = start_[other]; k < start_[other + 1]; ++k)
      ballot.vote(votes_[k].id, votes_[k].votes);
  };
  ask(leaf);
  for (auto k = pool_.start[leaf]; k < pool_.start[leaf + 1]; ++k) ask(pool_.to[k]);
  for (auto k = pool_.region_start[leaf]; k < pool_.region_start[leaf + 1]; ++k)
    ballot.vote(pool_.regions[k], flat_votes);
  const auto& counted = ballot.candidates();
  candidate_count_[leaf] =
      counted.size() <= kept ? static_cast<std::uint8_t>(counted.size()) : not_kept;
  if (counted.size() <= kept) std::copy(counted.begin(), counted.end(), kept_here);
}

void PlaneChoice::choose(const std::vector<Moments>& fixed, int rounds,
                         std::vector<GrownPlane>& planes, std::vector<std::int32_t>& label) {
  const auto& c = pool_.cloud;
  std::vector<std::int32_t> next = label;
  for (int round = 0; round < rounds; ++round) {
    count_votes(label);
    const std::vector<PlaneReach> reach(planes.begin(), planes.end());
    parallel_blocks(pool_.leaf.size(), 512, [&](std::size_t begin, std::size_t end) {
      Ballot ballot(reach);
      for (auto l = static_cast<std::uint32_t>(begin); l < end; ++l) {
        count_around(l, ballot);
        const Cell& cell = pool_.cell(l);
        for (auto p = cell.begin; p < cell.end; ++p)
          next[p] = ballot.best(c.x[p], c.y[p], c.z[p], c.inverse_range[p]);
      }
    });
    label.swap(next);
    std::vector<Moments> sums = fixed;
    sums.resize(planes.size());
    add_by_label(c, label, sums);
    parallel_blocks(planes.size(), 32, [&](std::size_t begin, std::size_t end) {
      for (std::size_t r = begin; r < end; ++r) {
        if (sums[r].n >= 6.0) {
          planes[r] = grown_plane(sums[r], noise_);
        } else {
          planes[r].moments = sums[r];
        }
      }
    });
  }
}

}  // namespace scanchor
