#include "reasoning/reach.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/relation_model.hpp"
#include "reasoning/support_relations.hpp"

namespace scanchor {
namespace {

constexpr double unsure_end = 0.1;  // [m]

double near_limit(const RelationTerm& term) {
  return term.range.has_high() ? term.range.high : 0.5;
}

/// [m] between boxes; infinity: the relation needs no nearness.
double distance_of(const RelationTerm& term) {
  if (term.relation == Relation::touching) return 1.5;
  if (term.relation == Relation::near) return 2.0 * near_limit(term) + 1.5;
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

double at_most(const Clause& clause, const Item& a, const Item& b, const RelationModel& model) {
  if (a.group || b.group) return 1.0;
  double most = 1.0;
  for (const auto& term : clause.relations) {
    if (term.relation != Relation::near) continue;
    const double limit = near_limit(term);
    const double doubt = a.edge_sigma + b.edge_sigma + model.near_softness * limit;
    const double far = limit + model.near_short + 4.0 * doubt;
    if (a.box.squaredExteriorDistance(b.box) > far * far) most *= model.near_meets + 1e-4;
  }
  return most;
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
