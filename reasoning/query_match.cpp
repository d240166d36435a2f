#include "reasoning/query_match.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/math.hpp"
#include "reasoning/groups.hpp"
#include "reasoning/likelihood.hpp"

namespace scanchor {

namespace {

constexpr double least_class = 0.01;

/// P(exactly `rank` - 1 of independent rivals are better).
double place_probability(const std::vector<double>& better, int place) {
  if (static_cast<std::size_t>(place) > better.size() + 1) return 0.0;
  std::vector<double> p(static_cast<std::size_t>(place), 0.0);  // the last one: place - 1 or fewer
  p[0] = 1.0;
  for (const double b : better) {
    for (std::size_t k = p.size(); k-- > 0;) p[k] = p[k] * (1.0 - b) + (k > 0 ? p[k - 1] * b : 0.0);
  }
  return p.back();
}

bool needs_viewpoint(Relation relation) {
  return relation == Relation::left_of || relation == Relation::right_of ||
         relation == Relation::in_front_of || relation == Relation::behind ||
         relation == Relation::set_back;
}

/// The other way round: what was denied, and where nothing was seen, neither yes nor no.
void deny(ClauseMatch& match, double none, double seen) {
  match.value = seen * none + (1.0 - seen) * 0.5;
  match.weakest = match.own = match.value;
  match.unseen = seen < 0.5 && none > 0.5;
}

}  // namespace

bool RefMatch::holds() const {
  if (weakest < 0.5) return false;
  return std::none_of(clauses.begin(), clauses.end(), [](const auto& c) { return c.unseen; });
}

const std::vector<RefMatch>& QueryMatcher::match(const QueryRef& ref) {
  const auto at = known_.find(&ref);
  if (at != known_.end()) return at->second;
  std::vector<RefMatch> matches;
  for (std::int32_t id = 0; id < scene_.size(); ++id) {
    RefMatch m;
    m.id = id;
    m.of_class = scene_.probability(id, ref.classes);
    if (m.of_class < least_class) continue;
    m.probability = m.weakest = m.of_class;
    for (const auto& clause : ref.clauses) {
      ClauseMatch c = hold(clause, id);
      c.clause = &clause;
      m.probability *= c.value;
      m.weakest = std::min(m.weakest, c.weakest);
      m.clauses.push_back(std::move(c));
    }
    matches.push_back(std::move(m));
  }
  if (ref.rank) put_in_order(ref, matches);
  return known_.emplace(&ref, std::move(matches)).first->second;
}

void QueryMatcher::need_viewpoint(const std::string& words) const {
  if (scene_.around().viewpoint) return;
  fail_usage("'" + words + "' depends on where the robot stood, which the scan does not say",
             "give --sensor x,y,z");
}

ClauseMatch QueryMatcher::hold(const QueryClause& clause, std::int32_t id) {
  switch (clause.kind) {
    case QueryClause::Kind::plain: {
      ClauseMatch match;
      if (clause.plain.kind == ClauseKind::extremum && clause.plain.extremum == Extremum::largest) {
        fail_usage("'that is largest' says not among what", "write 'the largest ...'");
      }
      match.evidence = scene_.own(clause.plain, id);
      match.value = clause.negated ? 1.0 - match.evidence.likelihood : match.evidence.likelihood;
      match.weakest = match.own = match.value;
      return match;
    }
    case QueryClause::Kind::with:
      return hold_with(clause, id);
    case QueryClause::Kind::between:
      return hold_between(clause, id);
    default:
      return hold_relation(clause, id);
  }
}

ClauseMatch QueryMatcher::hold_relation(const QueryClause& clause, std::int32_t id) {
  ClauseMatch best;
  best.value = best.weakest = best.own = 0.0;
  double none = 1.0;
  bool best_is_one = false;
  double best_distance = INFINITY;
  for (const auto& term : clause.relations) {
    if (needs_viewpoint(term.relation)) need_viewpoint(relation_words(term.relation));
  }
  for (const auto& target : match(clause.targets.front())) {
    if (target.id == id) continue;
    double product = 1.0;
    double weakest = target.as_target();
    Evidence evidence;
    if (clause.kind == QueryClause::Kind::belongs) {
      product = scene_.belongs(id, target.id) ? 1.0 : 0.0;
      weakest = std::min(weakest, product);
    }
    for (std::size_t i = 0; i < clause.relations.size(); ++i) {
      const Evidence e = scene_.relate(clause.relations[i], id, target.id);
      if (i == 0 || e.likelihood < evidence.likelihood) evidence = e;
      product *= e.likelihood;
      weakest = std::min(weakest, e.likelihood);
    }
    const double value = target.probability * product;
    none *= 1.0 - value;
    // Of equally good ones that which is sure of its class, then the nearest: what a miss is told
    // of.
    const bool is_one = target.of_class >= 0.5;
    const double distance = (scene_.item(id).center - scene_.item(target.id).center).squaredNorm();
    const bool nearer = is_one != best_is_one ? is_one : distance < best_distance;
    if (best.targets.empty() || value > best.value || (value == best.value && nearer)) {
      best.value = value;
      best.weakest = weakest;
      best.own = product;
      best.evidence = evidence;
      best.targets = {target.id};
      best_is_one = is_one;
      best_distance = distance;
    }
  }
  if (clause.kind == QueryClause::Kind::belongs && best.own <= 0.0) best.targets.clear();
  if (clause.negated) deny(best, none, 1.0 - scene_.item(id).area.hidden);
  return best;
}

ClauseMatch QueryMatcher::hold_with(const QueryClause& clause, std::int32_t id) {
  ClauseMatch match_of;
  std::vector<double> held;
  double best = -1.0;
  double weakest = 0.0;
  for (const auto& target : match(clause.targets.front())) {
    if (target.id == id) continue;
    const Evidence e = scene_.held_by(target.id, id);
    const double value = target.probability * e.likelihood;
    if (value <= 0.0) continue;
    held.push_back(value);
    if (e.likelihood >= 0.5 && target.holds()) match_of.targets.push_back(target.id);
    if (value <= best) continue;
    best = value;
    weakest = std::min(target.as_target(), e.likelihood);
    match_of.evidence = e;
    if (match_of.targets.empty()) match_of.targets = {target.id};
  }
  const bool any = clause.count_low == 1 && clause.count_high > 1'000'000;
  if (clause.negated && any) {
    double none = 1.0;
    for (const double h : held) none *= 1.0 - h;
    deny(match_of, none, 1.0 - scene_.item(id).area.hidden);
  } else if (any) {
    match_of.value = std::max(0.0, best);
    match_of.weakest = weakest;
    match_of.own = best < 0.0 ? 0.0 : match_of.evidence.likelihood;
  } else {
    match_of.value = count_probability(held, clause.count_low, clause.count_high);
    if (clause.negated) match_of.value = 1.0 - match_of.value;
    match_of.weakest = match_of.own = match_of.value;
  }
  return match_of;
}

ClauseMatch QueryMatcher::hold_between(const QueryClause& clause, std::int32_t id) {
  ClauseMatch best;
  best.value = best.weakest = best.own = 0.0;
  for (const auto& a : match(clause.targets.front())) {
    for (const auto& b : match(clause.targets.back())) {
      if (a.id == id || b.id == id || a.id == b.id) continue;
      const double most = a.probability * b.probability;
      if (!best.targets.empty() && most <= best.value) continue;
      const Evidence e = scene_.between(id, a.id, b.id);
      if (!best.targets.empty() && most * e.likelihood <= best.value) continue;
      best.value = most * e.likelihood;
      best.weakest = std::min({a.as_target(), b.as_target(), e.likelihood});
      best.own = e.likelihood;
      best.evidence = e;
      best.targets = {a.id, b.id};
    }
  }
  if (clause.negated) best.value = best.weakest = best.own = 1.0 - best.value;
  return best;
}

std::pair<double, double> QueryMatcher::key_of(const QueryRef& ref, RefMatch& of) {
  const std::int32_t id = of.id;
  const Item& item = scene_.item(id);
  const auto size = [](const Quantity& q, double sign) {
    return std::make_pair(sign * q.value, q.sigma);
  };
  switch (*ref.rank) {
    case RankKey::nearest:
    case RankKey::farthest: {
      const double sign = *ref.rank == RankKey::nearest ? 1.0 : -1.0;
      if (ref.rank_to.empty()) {
        need_viewpoint(rank_text(ref));
        return {sign * (item.center - *scene_.around().viewpoint).norm(), item.extension.sigma};
      }
      // The likeliest one is meant; of equally likely ones the nearest.
      const RefMatch* to = nullptr;
      double gap = INFINITY;
      double sigma = 0.0;
      for (const auto& target : match(ref.rank_to.front())) {
        if (target.id == id) continue;
        const Evidence distance = scene_.distance(id, target.id);
        const bool likelier = to == nullptr || (target.holds() && !to->holds());
        const bool as_likely = to != nullptr && target.holds() == to->holds();
        if (!likelier && !(as_likely && distance.measured < gap)) continue;
        to = &target;
        gap = distance.measured;
        sigma = distance.sigma;
      }
      if (to == nullptr) {
        of.weakest = of.probability = 0.0;
        return {1e3, sigma};
      }
      of.rank_to = to->id;
      of.weakest = std::min(of.weakest, to->as_target());
      of.probability *= to->probability;
      return {sign * gap, sigma};
    }
    case RankKey::largest:
      return size(item.area, -1.0);
    case RankKey::smallest:
      return size(item.area, 1.0);
    case RankKey::highest:
      return {-item.z, item.z_sigma};
    case RankKey::lowest:
      return {item.z, item.z_sigma};
    case RankKey::longest:
      return size(item.extension, -1.0);
    case RankKey::shortest:
      return size(item.extension, 1.0);
    case RankKey::widest:
      return size(item.width, -1.0);
    case RankKey::narrowest:
      return size(item.width, 1.0);
    case RankKey::leftmost:
    case RankKey::rightmost:
      break;
  }
  need_viewpoint(rank_text(ref));
  const Eigen::Vector2d ray = (item.center - *scene_.around().viewpoint).head<2>();
  const double bearing = std::atan2(ray.y(), ray.x());
  return {*ref.rank == RankKey::leftmost ? -bearing : bearing,
          item.extension.sigma / std::max(ray.norm(), 0.1)};
}

void QueryMatcher::put_in_order(const QueryRef& ref, std::vector<RefMatch>& matches) {
  std::vector<std::pair<double, double>> keys;
  double base = 0.0;
  bool have_base = false;
  const bool turns = *ref.rank == RankKey::leftmost || *ref.rank == RankKey::rightmost;
  for (auto& m : matches) {
    auto key = key_of(ref, m);
    // Bearings are told apart around the first one: the scene may lie behind the robot's back.
    if (turns && !have_base) {
      base = key.first;
      have_base = true;
    }
    if (turns) key.first = std::remainder(key.first - base, 2.0 * pi);
    m.key = key.first;
    keys.push_back(key);
  }
  const auto anchor = [&](const RefMatch& m) {
    for (const auto& c : m.clauses) {
      if (c.clause->kind == QueryClause::Kind::belongs && !c.targets.empty() && c.value > 0.0)
        return c.targets.front();
    }
    return -1;
  };
  std::vector<double> before(matches.size());
  for (std::size_t i = 0; i < matches.size(); ++i) before[i] = matches[i].probability;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    std::vector<double> better;
    const std::int32_t own = anchor(matches[i]);
    for (std::size_t j = 0; j < matches.size(); ++j) {
      // Boards are counted within their shelf.
      if (j == i || before[j] < 1e-3 || anchor(matches[j]) != own) continue;
      const double s = std::max(std::hypot(keys[i].second, keys[j].second), 1e-9);
      const double p = upper_likelihood(keys[j].first, keys[i].first, s);
      // A rival counts as far as it is one; what surely is one counts in full.
      const double rival = matches[j].holds() ? 1.0 : before[j];
      better.push_back(rival * p);
    }
    matches[i].rank = place_probability(better, ref.place);
    matches[i].probability = before[i] * matches[i].rank;
  }
}

}  // namespace scanchor
