#pragma once
// Sets of entities that belong together pair by pair: the boards of a shelf. reasoning.md
// section 2.6.

#include <cstdint>
#include <vector>

#include "reasoning/item.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {

struct Member {
  std::int32_t item = 0;
  double belief = 0.0;  ///< that it meets the description of the class that the group is made of
};

struct GroupFound {
  std::vector<std::int32_t> members;  ///< item ids
  double probability = 0.0;           ///< P(the number of true members is in the clause's range)
};

/// P(low <= N <= high) for independent members, Poisson-binomial by dynamic programming, O(n * n).
double count_probability(const std::vector<double>& members, int low, int high);

/// Disjoint groups, larger entities first as seeds; independent of the order of `pool`.
/// Every pair inside a group satisfies the pair relations with at least 0.3.
std::vector<GroupFound> build_groups(const std::vector<Item>& items,
                                     const std::vector<Member>& pool, const Clause& clause,
                                     const Surrounding& around);

}  // namespace scanchor
