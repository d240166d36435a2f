#include "reasoning/answer.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/limits.hpp"
#include "reasoning/query_match.hpp"

namespace scanchor {

namespace {

constexpr double nearness_margin = 0.1;  // two things nearer than that are told apart by nobody
constexpr double well_hidden = 0.5;      // of an anchor: what would be there may be unseen

Limits limits_of_clause(const QueryClause& clause, const ClauseMatch& match,
                        const SceneThings& scene, std::int32_t id) {
  if (clause.negated) return {};
  if (clause.kind == QueryClause::Kind::plain) return limits_of(clause.plain);
  if (clause.kind == QueryClause::Kind::between) return {120.0, INFINITY};
  if (clause.kind != QueryClause::Kind::relation || match.targets.empty()) return {};
  const RelationTerm* weakest = nullptr;
  double least = 2.0;
  for (const auto& term : clause.relations) {
    const double l = scene.relate(term, id, match.targets.front()).likelihood;
    if (l >= least) continue;
    least = l;
    weakest = &term;
  }
  return weakest != nullptr ? limits_of(*weakest) : Limits{};
}

/// Of the number that an order goes by; "" where it depends on the frame.
std::string rank_unit(RankKey key) {
  switch (key) {
    case RankKey::largest:
    case RankKey::smallest:
      return "m2";
    case RankKey::highest:
    case RankKey::lowest:
    case RankKey::leftmost:
    case RankKey::rightmost:
      return "";
    default:
      return "m";
  }
}

std::string is_one(const QueryRef& ref) {
  QueryRef bare;
  bare.name = ref.name;
  return "is " + ref_text(bare);
}

std::vector<AnswerStep> steps_of(const RefMatch& match, const QueryRef& ref, QueryMatcher& matcher,
                                 const SceneThings& scene, bool of_class);

/// Why `id` is what is said of it.
std::vector<AnswerStep> because_of(const QueryRef& ref, std::int32_t id, QueryMatcher& matcher,
                                   const SceneThings& scene) {
  for (const auto& target : matcher.match(ref)) {
    if (target.id == id) return steps_of(target, ref, matcher, scene, true);
  }
  return {};
}

AnswerStep step_of(const ClauseMatch& match, std::int32_t id, QueryMatcher& matcher,
                   const SceneThings& scene) {
  const QueryClause& clause = *match.clause;
  AnswerStep step;
  step.text = query_clause_text(clause);
  step.likelihood = match.own;
  step.measured = match.evidence.measured;
  step.sigma = match.evidence.sigma;
  step.unit = match.evidence.unit;
  step.unseen = match.unseen;
  step.targets = match.targets;
  if (match.own < 0.5 && !step.unit.empty()) {
    const Limits limits = limits_of_clause(clause, match, scene, id);
    const double needed = step.measured < limits.low ? limits.low : limits.high;
    const bool missed = step.measured < limits.low || step.measured > limits.high;
    if (missed && std::isfinite(needed)) step.needed = needed;
  }
  if (!match.targets.empty() && !clause.targets.empty())
    step.because = because_of(clause.targets.front(), match.targets.front(), matcher, scene);
  return step;
}

std::vector<AnswerStep> steps_of(const RefMatch& match, const QueryRef& ref, QueryMatcher& matcher,
                                 const SceneThings& scene, bool of_class) {
  std::vector<AnswerStep> steps;
  if (of_class && !ref.classes.empty()) {
    AnswerStep step;
    step.text = is_one(ref);
    step.likelihood = match.of_class;
    steps.push_back(std::move(step));
  }
  for (const auto& clause : match.clauses)
    steps.push_back(step_of(clause, match.id, matcher, scene));
  if (ref.rank) {
    AnswerStep step;
    step.text = order_text(ref);
    step.likelihood = match.rank;
    if (ref.rank_to.empty() || match.rank_to >= 0) step.unit = rank_unit(*ref.rank);
    if (match.rank_to >= 0) {
      step.targets = {match.rank_to};
      step.because = because_of(ref.rank_to.front(), match.rank_to, matcher, scene);
    }
    if (!step.unit.empty()) step.measured = std::abs(match.key);
    steps.push_back(std::move(step));
  }
  return steps;
}

AnswerThing thing_of(const RefMatch& match, const QueryRef& ref, QueryMatcher& matcher,
                     const SceneThings& scene) {
  AnswerThing thing;
  thing.id = match.id;
  thing.label = scene.entity(match.id).label;
  thing.of_class = match.of_class;
  thing.probability = match.probability;
  thing.steps = steps_of(match, ref, matcher, scene, false);
  for (const auto& clause : match.clauses) {
    if (clause.clause->negated) continue;
    for (const auto t : clause.targets) {
      if (std::find(thing.anchors.begin(), thing.anchors.end(), t) == thing.anchors.end())
        thing.anchors.push_back(t);
    }
  }
  if (match.rank_to >= 0 &&
      std::find(thing.anchors.begin(), thing.anchors.end(), match.rank_to) == thing.anchors.end())
    thing.anchors.push_back(match.rank_to);
  return thing;
}

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

/// The order in which two things differ most, against their own uncertainty.
std::string what_tells_apart(const SceneThings& scene, std::int32_t a, std::int32_t b) {
  const Item& first = scene.item(a);
  const Item& second = scene.item(b);
  double best = 1.0;  // less than a deviation tells nothing
  std::string ask;
  const auto offer = [&](const std::string& low_word, const std::string& high_word, double x,
                         double y, double sigma, const std::string& unit) {
    const double apart = std::abs(x - y) / std::max(sigma, 0.05);
    if (apart <= best) return;
    best = apart;
    const bool a_low = x < y;
    const auto side = [&](std::int32_t id, double value) {
      std::string text = metres(value);
      if (unit == "m2") text += "2";
      return std::to_string(id) + " at " + text;
    };
    ask = "the " + low_word + " (" + side(a_low ? a : b, std::min(x, y)) + ") or the " + high_word +
          " (" + side(a_low ? b : a, std::max(x, y)) + ")?";
  };
  if (const auto& eye = scene.around().viewpoint) {
    offer("nearest", "farthest", (first.center - *eye).norm(), (second.center - *eye).norm(), 0.1,
          "m");
  }
  offer("lowest", "highest", first.z, second.z, std::hypot(first.z_sigma, second.z_sigma), "m");
  offer("smallest", "largest", first.area.value, second.area.value,
        std::hypot(first.area.sigma, second.area.sigma), "m2");
  return ask;
}

/// Where a thing that is missing could be without having been seen.
bool may_be_hidden(const RefMatch& match, const SceneThings& scene) {
  for (const auto& clause : match.clauses) {
    if (clause.unseen) return true;
    if (clause.value >= 0.5 || clause.targets.empty() || clause.clause->negated) continue;
    for (const auto& term : clause.clause->relations) {
      const bool local = term.relation == Relation::on || term.relation == Relation::inside;
      if (local && scene.item(clause.targets.front()).area.hidden > well_hidden) return true;
    }
  }
  return false;
}

/// The same of a class of which there is nothing at all: is an anchor that is there well hidden?
bool anchor_is_hidden(const QueryRef& ref, QueryMatcher& matcher, const SceneThings& scene) {
  for (const auto& clause : ref.clauses) {
    if (clause.kind != QueryClause::Kind::relation || clause.negated) continue;
    const bool local =
        std::any_of(clause.relations.begin(), clause.relations.end(), [](const RelationTerm& term) {
          return term.relation == Relation::on || term.relation == Relation::inside;
        });
    if (!local) continue;
    for (const auto& target : matcher.match(clause.targets.front())) {
      if (target.holds() && scene.item(target.id).area.hidden > well_hidden) return true;
    }
  }
  return false;
}

void nothing_found(Answer& result, const QueryRef& ref, const std::vector<RefMatch>& matches,
                   QueryMatcher& matcher, const SceneThings& scene) {
  result.status = Answer::Status::not_found;
  // The nearest miss is of the class for sure where there is one, and fails by as little as can be.
  const RefMatch* best = nullptr;
  for (const auto& m : matches) {
    const auto better = [&](const RefMatch& x, const RefMatch& y) {
      if ((x.of_class >= 0.5) != (y.of_class >= 0.5)) return x.of_class >= 0.5;
      const auto cannot_tell = [](const RefMatch& r) {
        return r.weakest >= 0.5 ? 1 : 0;  // only unseen things stand against it
      };
      if (cannot_tell(x) != cannot_tell(y)) return cannot_tell(x) > cannot_tell(y);
      const auto failing = [](const RefMatch& r) {
        return std::count_if(r.clauses.begin(), r.clauses.end(),
                             [](const ClauseMatch& c) { return c.value < 0.5; });
      };
      if (failing(x) != failing(y)) return failing(x) < failing(y);
      return x.probability > y.probability;
    };
    if (best == nullptr || better(m, *best)) best = &m;
  }
  if (best == nullptr) {
    result.failing = is_one(ref);
    if (anchor_is_hidden(ref, matcher, scene)) result.status = Answer::Status::not_seen;
    return;
  }
  if (may_be_hidden(*best, scene)) result.status = Answer::Status::not_seen;
  result.closest = thing_of(*best, ref, matcher, scene);
  if (best->of_class < 0.5) {
    result.failing = is_one(ref);
    return;
  }
  const ClauseMatch* failing = nullptr;
  for (const auto& clause : best->clauses) {
    if (clause.unseen || clause.weakest < 0.5) {
      failing = &clause;
      break;
    }
  }
  if (failing != nullptr) {
    result.failing = query_clause_text(*failing->clause);
  } else if (!ref.rank_to.empty()) {
    result.failing = order_text(ref);  // there is nothing to be near to
  }
}

void find(Answer& result, const QueryRef& ref, QueryMatcher& matcher, const SceneThings& scene) {
  const auto& matches = matcher.match(ref);
  std::vector<const RefMatch*> holding;
  for (const auto& m : matches) {
    if (m.holds()) holding.push_back(&m);
  }
  if (holding.empty()) {
    nothing_found(result, ref, matches, matcher, scene);
    return;
  }
  std::stable_sort(holding.begin(), holding.end(), [](const RefMatch* a, const RefMatch* b) {
    return a->probability > b->probability;
  });
  const bool one = ref.definite || ref.rank.has_value();
  if (ref.rank) {
    // There may be fewer than the place that was asked for.
    if (holding.front()->rank < 0.05) {
      result.status = Answer::Status::not_found;
      result.closest = thing_of(*holding.front(), ref, matcher, scene);
      result.failing = rank_text(ref);
      return;
    }
    std::erase_if(holding, [](const RefMatch* m) { return m->rank < 0.05; });
  }
  for (const auto* m : holding) result.things.push_back(thing_of(*m, ref, matcher, scene));
  result.status = Answer::Status::ok;
  const bool unclear_order = ref.rank && holding.front()->rank < 0.5;
  if (one && holding.size() > 1 &&
      (unclear_order || holding[0]->probability - holding[1]->probability < nearness_margin)) {
    result.status = Answer::Status::ambiguous;
    result.ask = what_tells_apart(scene, holding[0]->id, holding[1]->id);
  }
}

void count(Answer& result, const std::vector<RefMatch>& matches) {
  result.count = static_cast<int>(result.things.size());
  double none = 1.0;
  std::vector<double> p = {1.0};
  for (const auto& m : matches) {
    result.expected += m.probability;
    none *= 1.0 - m.probability;
    if (m.probability < 1e-6) continue;
    p.push_back(0.0);
    for (std::size_t k = p.size(); k-- > 0;)
      p[k] = p[k] * (1.0 - m.probability) + (k > 0 ? p[k - 1] * m.probability : 0.0);
  }
  while (p.size() > 1 && p.back() < 5e-4) p.pop_back();
  result.distribution = std::move(p);
  result.exists = 1.0 - none;
}

}  // namespace

std::string status_word(Answer::Status status) {
  switch (status) {
    case Answer::Status::ok:
      return "ok";
    case Answer::Status::ambiguous:
      return "ambiguous";
    case Answer::Status::not_found:
      return "not_found";
    case Answer::Status::not_seen:
      return "not_seen";
  }
  return {};
}

Answer answer(const Query& query, const SceneThings& scene) {
  Answer result;
  result.query = query;
  QueryMatcher matcher(scene);
  const QueryRef& first = result.query.refs.front();
  find(result, first, matcher, scene);
  count(result, matcher.match(first));
  if (query.kind == Query::Kind::count && result.status == Answer::Status::not_found)
    result.status = Answer::Status::ok;  // none is an answer
  if (query.kind == Query::Kind::exists && result.status == Answer::Status::not_found)
    result.status = Answer::Status::ok;
  if (query.kind != Query::Kind::distance) return result;

  const bool found = !result.things.empty();
  const Answer::Status of_first = result.status;
  std::vector<AnswerThing> things;
  if (found) things.push_back(result.things.front());
  if (!found) return result;
  Answer other;
  const QueryRef& second = result.query.refs.back();
  find(other, second, matcher, scene);
  std::erase_if(other.things, [&](const AnswerThing& t) { return t.id == things.front().id; });
  result.things = std::move(things);
  if (other.things.empty()) {
    result.status = other.status == Answer::Status::ok ? Answer::Status::not_found : other.status;
    result.closest = std::move(other.closest);
    result.failing = std::move(other.failing);
    if (other.status == Answer::Status::ok) result.failing = "is another " + second.name;
    return result;
  }
  result.things.push_back(other.things.front());
  result.distance = scene.distance(result.things[0].id, result.things[1].id);
  const bool unclear =
      of_first == Answer::Status::ambiguous || other.status == Answer::Status::ambiguous;
  result.status = unclear ? Answer::Status::ambiguous : Answer::Status::ok;
  if (result.ask.empty()) result.ask = other.ask;
  return result;
}

}  // namespace scanchor
