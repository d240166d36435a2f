#include "reasoning/groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace scanchor {

namespace {

constexpr double pair_gate = 0.3;
constexpr double seed_belief = 0.3;
constexpr std::size_t most_members = 32;  // the closure looks at all pairs

double pair_value(const Clause& clause, const Item& a, const Item& b, const Surrounding& around) {
  double product = 1.0;
  // The strictest first: most pairs are not stacked.
  for (auto term = clause.pairwise.rbegin(); term != clause.pairwise.rend(); ++term) {
    product *= relate(*term, a, b, around).likelihood;
    if (product < 1e-3) return product;
  }
  return product;
}

/// Stacked things lie within a metre of each other in the plan, so only neighbouring cells of a
/// grid need be looked at, and of those the first `most_neighbours`: a stack of more is no
/// furniture, and thousands of equal entities must not take all day.
class Neighbours {
 public:
  static constexpr std::size_t most_neighbours = 400;

  Neighbours(const std::vector<Item>& items, const std::vector<Member>& sorted,
             const Clause& clause)
      : count_(sorted.size()) {
    for (const auto& term : clause.pairwise)
      stacked_ =
          stacked_ || term.relation == Relation::aligned || term.relation == Relation::stacked;
    for (std::size_t i = 0; stacked_ && i < sorted.size(); ++i)
      cells_[cell(items[sorted[i].item], 0, 0)].push_back(i);
  }

  [[nodiscard]] std::vector<std::size_t> of(const Item& seed) const {
    std::vector<std::size_t> near;
    if (!stacked_) {
      near.resize(count_);
      for (std::size_t i = 0; i < count_; ++i) near[i] = i;
      return near;
    }
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto at = cells_.find(cell(seed, dx, dy));
        if (at != cells_.end()) near.insert(near.end(), at->second.begin(), at->second.end());
      }
    }
    std::sort(near.begin(), near.end());
    if (near.size() > most_neighbours) near.resize(most_neighbours);
    return near;
  }

 private:
  static std::pair<long, long> cell(const Item& item, int dx, int dy) {
    return {std::lround(std::floor(item.center.x())) + dx,
            std::lround(std::floor(item.center.y())) + dy};
  }
  std::map<std::pair<long, long>, std::vector<std::size_t>> cells_;
  std::size_t count_ = 0;
  bool stacked_ = false;
};

/// Order of seeds that depends on what the things are and not on how they are numbered.
bool comes_first(const Item& a, const Item& b) {
  if (a.area.value != b.area.value) return a.area.value > b.area.value;
  for (int i = 0; i < 3; ++i) {
    if (a.center[i] != b.center[i]) return a.center[i] < b.center[i];
  }
  return a.id < b.id;
}

}  // namespace

double count_probability(const std::vector<double>& members, int low, int high) {
  std::vector<double> p(members.size() + 1, 0.0);
  p[0] = 1.0;
  std::size_t done = 0;
  for (const double m : members) {
    for (std::size_t k = ++done; k > 0; --k) p[k] = p[k] * (1.0 - m) + p[k - 1] * m;
    p[0] *= 1.0 - m;
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (static_cast<int>(k) >= low && static_cast<int>(k) <= high) sum += p[k];
  }
  return std::clamp(sum, 0.0, 1.0);
}

std::vector<GroupFound> build_groups(const std::vector<Item>& items,
                                     const std::vector<Member>& pool, const Clause& clause,
                                     const Surrounding& around) {
  std::vector<Member> sorted;
  for (const auto& member : pool) {
    if (member.belief > seed_belief) sorted.push_back(member);
  }
  std::sort(sorted.begin(), sorted.end(), [&](const Member& a, const Member& b) {
    return comes_first(items[a.item], items[b.item]);
  });
  std::vector<bool> used(sorted.size(), false);
  std::vector<GroupFound> groups;
  const Neighbours neighbours(items, sorted, clause);
  for (std::size_t s = 0; s < sorted.size(); ++s) {
    if (used[s]) continue;
    const Item& seed = items[sorted[s].item];
    struct Near {
      std::size_t index;
      double value;
    };
    std::vector<Near> near;
    for (const std::size_t i : neighbours.of(seed)) {
      if (used[i] || i == s) continue;
      const double value = pair_value(clause, items[sorted[i].item], seed, around);
      if (value >= pair_gate) near.push_back({i, value});
    }
    std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
      return a.value != b.value ? a.value > b.value : a.index < b.index;
    });
    // Closure: a newcomer has to get on with everybody who is in.
    std::vector<std::size_t> members = {s};
    std::vector<double> weakest = {1.0};
    for (const auto& candidate : near) {
      if (static_cast<int>(members.size()) >= clause.count_high || members.size() >= most_members)
        break;
      double value = candidate.value;
      for (std::size_t k = 1; k < members.size() && value >= pair_gate; ++k) {
        value = std::min(value, pair_value(clause, items[sorted[candidate.index].item],
                                           items[sorted[members[k]].item], around));
      }
      if (value < pair_gate) continue;
      members.push_back(candidate.index);
      weakest.push_back(value);
    }
    if (static_cast<int>(members.size()) < clause.count_low) continue;
    GroupFound group;
    std::vector<double> p;
    for (std::size_t k = 0; k < members.size(); ++k) {
      used[members[k]] = true;
      group.members.push_back(sorted[members[k]].item);
      p.push_back(sorted[members[k]].belief * weakest[k]);
    }
    group.probability = count_probability(p, clause.count_low, clause.count_high);
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace scanchor
