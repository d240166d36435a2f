#include "reasoning/reach.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/support_relations.hpp"

namespace scanchor {
namespace {

constexpr double unsure_end = 0.1;  // [m]

/// [m] between boxes; infinity: the relation needs no nearness.
double distance_of(const RelationTerm& term) {
  if (term.relation == Relation::touching) return 1.5;
  if (term.relation == Relation::near)
    return 2.0 * (term.range.has_high() ? term.range.high : 0.5) + 1.5;
  return INFINITY;
}

bool is_over(Relation relation) { return relation == Relation::above || relation == Relation::on; }
bool is_under(Relation relation) {
  return relation == Relation::below || relation == Relation::supports;
}

}  // namespace

bool out_of_reach(const Clause& clause, const Item& a, const Item& b) {
  for (const auto& term : clause.relations) {
    if (is_over(term.relation) || is_under(term.relation)) {
      if (plan_gap(a, b) > overlap_reach(is_over(term.relation) ? b : a)) return true;
      continue;
    }
    const double reach = distance_of(term);
    if (std::isinf(reach) || std::max(a.edge_sigma, b.edge_sigma) > unsure_end) continue;
    if (a.box.exteriorDistance(b.box) > reach) return true;
  }
  return false;
}

double reach_of(const Clause& clause, const Item& a) {
  double least = INFINITY;
  for (const auto& term : clause.relations) {
    if (is_over(term.relation)) least = std::min(least, overlap_thickening);
    if (is_under(term.relation)) least = std::min(least, overlap_reach(a));
    if (a.edge_sigma <= unsure_end) least = std::min(least, distance_of(term));
  }
  return least;
}

bool reaches_far(const Item& target) {
  return target.edge_sigma > unsure_end || overlap_reach(target) > overlap_thickening;
}

}  // namespace scanchor
