#include "reasoning/limits.hpp"

namespace scanchor {

Limits limits_of(const RelationTerm& term) {
  const auto up_to = [&](double otherwise) {
    return Limits{-INFINITY, term.range.has_high() ? term.range.high : otherwise};
  };
  switch (term.relation) {
    case Relation::parallel:
      return {-INFINITY, 5.0};
    case Relation::orthogonal:
      return {85.0, 95.0};
    case Relation::above:
    case Relation::below:
      return {-0.05, INFINITY};
    case Relation::on:
    case Relation::supports:
      return {-0.03, 0.15};
    case Relation::inside:
      return {0.8, INFINITY};
    case Relation::near:
      return up_to(0.5);
    case Relation::touching:
      return {-INFINITY, 0.05};
    case Relation::same_size:
      return {1.0 / 1.15, 1.15};
    case Relation::aligned:
      return {-INFINITY, 0.15};
    case Relation::stacked:
      return {0.6, INFINITY};
    case Relation::coplanar:
      return up_to(0.03);
    case Relation::higher:
    case Relation::lower:
      return {0.0, INFINITY};
    case Relation::elevation:
    case Relation::bottom:
    case Relation::top:
    case Relation::set_back:
      return {term.range.low, term.range.high};
    case Relation::left_of:
    case Relation::right_of:
    case Relation::in_front_of:
    case Relation::behind:
      return {-INFINITY, 45.0};
  }
  return {};
}

Limits limits_of(const Clause& clause) {
  const double tolerance = clause.range.has_high() ? clause.range.high : 5.0;
  switch (clause.kind) {
    case ClauseKind::feature:
      return {clause.range.low, clause.range.high};
    case ClauseKind::rectangular:
      return {0.8, INFINITY};
    case ClauseKind::horizontal:
      return {-INFINITY, tolerance};
    case ClauseKind::vertical:
      return {90.0 - tolerance, 90.0 + tolerance};
    case ClauseKind::extremum:
      switch (clause.extremum) {
        case Extremum::outermost:
          return {-INFINITY, 0.02};
        case Extremum::cornered:
          return {-INFINITY, 0.06};
        case Extremum::lowest:
        case Extremum::highest:
          return {-INFINITY, 0.10};
        case Extremum::largest:
          return {};
      }
      return {};
    case ClauseKind::group:
      return {static_cast<double>(clause.count_low), static_cast<double>(clause.count_high)};
    case ClauseKind::relation:
    case ClauseKind::negation:
      return {};
  }
  return {};
}

}  // namespace scanchor
