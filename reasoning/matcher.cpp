#include "reasoning/matcher.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/background.hpp"
#include "reasoning/corner.hpp"
#include "reasoning/groups.hpp"
#include "reasoning/likelihood.hpp"
#include "reasoning/reach.hpp"

namespace scanchor {

namespace {

/// Fewer are looked at one by one.
constexpr std::size_t many_targets = 64;

}  // namespace

double log_likelihood_ratio(double value, double hit_rate, double background) {
  const double for_class = value * hit_rate + (1.0 - value) * (1.0 - hit_rate);
  const double for_other = value * background + (1.0 - value) * (1.0 - background);
  return std::log(for_class / for_other);
}

double evidence_of(const Clause& clause, double value) {
  // A group is there only because it was found, so its background is the rate of such finds
  // among other things, and nothing is known of finds that failed (docs/why/semantics.md).
  if (clause.kind == ClauseKind::group)
    return std::log(value * hit_rate_of(clause) / background_of(clause));
  return log_likelihood_ratio(value, hit_rate_of(clause), background_of(clause));
}

Matcher::Matcher(const Ontology& ontology, std::vector<Item> items, const Surrounding& around)
    : ontology_(ontology),
      items_(std::move(items)),
      around_(around),
      surface_count_(items_.size()) {
  const std::size_t count = ontology.classes.size();
  clauses_.resize(count);
  group_clause_.assign(count, -1);
  candidates_.resize(count);
  targets_.resize(count);
  runs_.resize(count);
  grids_.resize(count);
  twin_ = first_of_twins(items_);
  for (std::size_t c = 0; c < count; ++c) {
    class_of_name_.emplace(ontology.classes[c].name(), static_cast<int>(c));
    clauses_[c] = all_clauses(ontology, static_cast<int>(c));
    for (std::size_t i = 0; i < clauses_[c].size(); ++i) {
      clauses_[c][i].hit_rate = hit_rate_of(clauses_[c][i]);  // once, not for every candidate
      clauses_[c][i].background = background_of(clauses_[c][i]);
      if (clauses_[c][i].kind == ClauseKind::group) group_clause_[c] = static_cast<int>(i);
    }
  }
  for (const auto& item : items_) {
    horizontal_.push_back(horizontal(item, around_));
    vertical_.push_back(vertical(item, around_));
    rectangular_.push_back(rectangular(item));
  }
  index_ = UnaryIndex(items_, horizontal_, vertical_);
  group_value_.assign(items_.size(), 0.0);
  cornered_.resize(items_.size());
  extent_ = SceneExtent(items_, horizontal_);
}

int Matcher::target_class(const Clause& clause) const {
  const auto at = class_of_name_.find(clause.target);
  return at != class_of_name_.end() ? at->second : ontology_.find(clause.target);
}

double Matcher::belief(int class_index, std::int32_t item) const {
  const auto& list = candidates_[class_index];
  const auto at = std::lower_bound(list.begin(), list.end(), item,
                                   [](const Candidate& c, std::int32_t id) { return c.item < id; });
  return at != list.end() && at->item == item ? at->belief : 0.0;
}

const Evidence& Matcher::corner_of(std::int32_t id) const {
  // Looked for once, and only for what passed the clauses in front.
  const std::int32_t twin = twin_[id];  // faces in one plane have no edge with each other
  auto& corner = cornered_[static_cast<std::size_t>(twin)];
  if (!corner) corner = cornered(items_, items_[twin], around_);
  return *corner;
}

ClauseValue Matcher::evaluate_unary(const Clause& clause, std::int32_t id) const {
  const Item& item = items_[id];
  Evidence evidence;
  switch (clause.kind) {
    case ClauseKind::feature:
      evidence = feature(clause.feature, clause.range, item);
      break;
    case ClauseKind::horizontal:
      evidence = clause.range.has_high() ? horizontal(item, around_, clause.range.high)
                 : item.group            ? horizontal(item, around_)
                                         : horizontal_[id];
      break;
    case ClauseKind::vertical:
      evidence = clause.range.has_high() ? vertical(item, around_, clause.range.high)
                 : item.group            ? vertical(item, around_)
                                         : vertical_[id];
      break;
    case ClauseKind::rectangular:
      evidence = item.group ? rectangular(item) : rectangular_[id];
      break;
    case ClauseKind::group:
      evidence = {group_value_[id], static_cast<double>(item.members.size()), 0.0, "1"};
      break;
    case ClauseKind::extremum: {
      evidence = clause.extremum == Extremum::cornered
                     ? corner_of(id)
                     : extent_.extremum(clause.extremum, item, around_);
      break;
    }
    default:
      break;
  }
  ClauseValue result;
  result.value = evidence.likelihood;
  result.evidence = evidence;
  return result;
}

ClauseValue Matcher::evaluate_relation(const Clause& clause, std::int32_t id) const {
  const Item& a = items_[id];
  const int wanted = target_class(clause);
  ClauseValue best;
  double none = 1.0;  // P(no target satisfies it), for negation
  double best_distance = INFINITY;
  const auto related_by_birth = [&](std::int32_t target) {
    const auto& members = items_[target].members;
    return target == id || std::find(members.begin(), members.end(), id) != members.end() ||
           std::find(a.members.begin(), a.members.end(), target) != a.members.end();
  };
  const bool required = clause.kind == ClauseKind::relation;
  /// Holds it against `count` targets of one geometry; false: no later one can be better.
  const auto consider = [&](double belief, std::int32_t target, int count) {
    if (required && belief < best.value) return false;
    const Item& b = items_[target];
    if (required && best.target >= 0 &&
        (out_of_reach(clause, a, b) || belief * at_most(clause, a, b, *around_.model) < best.value))
      return true;
    double product = 1.0;
    Evidence weakest;
    for (std::size_t i = 0; i < clause.relations.size(); ++i) {
      const Evidence evidence = relate(clause.relations[i], a, b, around_);
      if (i == 0 || evidence.likelihood < weakest.likelihood) weakest = evidence;
      product *= evidence.likelihood;
      if (required && belief * product < best.value) break;
    }
    if (!clause.target_clauses.empty() && product > 0.0) product *= restriction(clause, target);
    for (int k = 0; k < count && !required; ++k) none *= 1.0 - belief * product;
    const double value = belief * product;
    const double distance = (a.center - b.center).squaredNorm();
    // Of equally good targets the nearest is named.
    if (best.target < 0 || value > best.value ||
        (value == best.value && distance < best_distance)) {
      best.value = value;
      best.evidence = weakest;
      best.target = target;
      best_distance = distance;
    }
    return true;
  };
  if (a.group) {  // which of equal surfaces are its members makes a difference
    for (const auto& target : targets_[wanted]) {
      if (!related_by_birth(target.item) && !consider(target.belief, target.item, 1)) break;
    }
  } else {
    const auto hold = [&](const Run& run) {
      if (run.count == 1) return related_by_birth(run.first) || consider(run.belief, run.first, 1);
      const bool within = twin_[id] == twin_[run.first] && belief(wanted, id) == run.belief;
      const std::int32_t target = run.first == id ? run.second : run.first;
      return consider(run.belief, target, run.count - (within ? 1 : 0));
    };
    const auto& runs = runs_[wanted];
    const double reach = required && runs.size() >= many_targets ? reach_of(clause, a) : INFINITY;
    // The likeliest is named where none is near.
    std::size_t next = 0;
    while (next < runs.size() && (best.target < 0 || std::isinf(reach)) && hold(runs[next])) ++next;
    if (std::isfinite(reach) && best.target >= 0) {
      std::vector<std::int32_t> near;
      grids_[wanted].near(a.box, reach, near);
      for (auto at = std::lower_bound(near.begin(), near.end(), static_cast<std::int32_t>(next));
           at != near.end() && hold(runs[*at]); ++at) {
      }
    }
  }
  if (clause.kind == ClauseKind::negation) {
    // Where the entity was not seen whole, something may be there unseen: neither yes nor no
    // (reasoning.md 2.7).
    const double seen = 1.0 - a.area.hidden;
    best.value = seen * none + (1.0 - seen) * 0.5;
  }
  return best;
}

const std::string& Matcher::text_of(const Clause& clause) const {
  auto [at, fresh] = texts_.try_emplace(&clause);
  if (fresh) at->second = clause_text(clause);
  return at->second;
}

double Matcher::restriction(const Clause& clause, std::int32_t target) const {
  // Of one clause and one target it is the same for every subject.
  const auto known = restrictions_.find({&clause, target});
  if (running_ && known != restrictions_.end()) return known->second;
  double product = 1.0;
  for (const auto& nested : clause.target_clauses) {
    product *= evaluate(target_class(clause), nested, target).value;
    if (product <= 0.0) break;
  }
  if (running_) restrictions_.emplace(std::make_pair(&clause, target), product);
  return product;
}

ClauseValue Matcher::evaluate_largest(int class_index, std::int32_t id) const {
  // P(no rival is larger); rivals weigh as much as they are believed to be of the class (five best,
  // reasoning.md 2.3).
  const Item& a = items_[id];
  ClauseValue result;
  double value = 1.0;
  int rivals = 0;
  for (const auto& target : targets_[class_index]) {
    if (target.item == id) continue;
    const Item& b = items_[target.item];
    const double s = std::hypot(a.area.sigma, b.area.sigma);
    value *= 1.0 - target.belief * lower_likelihood(b.area.value, a.area.value, std::max(s, 1e-9));
    if (++rivals == 5) break;
  }
  result.value = value;
  result.evidence = {value, a.area.value, a.area.sigma, "m2"};
  return result;
}

ClauseValue Matcher::evaluate(int class_index, const Clause& clause, std::int32_t item) const {
  if (clause.kind == ClauseKind::relation || clause.kind == ClauseKind::negation)
    return evaluate_relation(clause, item);
  if (clause.kind == ClauseKind::extremum && clause.extremum == Extremum::largest) {
    return evaluate_largest(class_index, item);
  }
  ClauseValue value = evaluate_unary(clause, item);
  if (clause.kind == ClauseKind::group) value.members = items_[item].members;
  return value;
}

std::vector<std::int32_t> Matcher::find_groups(const Clause& clause) {
  std::vector<Member> pool;
  for (const auto& target : targets_[target_class(clause)]) {
    if (!items_[target.item].group) pool.push_back({target.item, target.fit});
  }
  std::vector<std::int32_t> ids;
  for (auto& group : build_groups(items_, pool, clause, around_)) {
    // Two classes that are made of the same parts, a shelf and a bookcase, compete for one thing.
    const auto same = std::find_if(
        items_.begin() + static_cast<std::ptrdiff_t>(surface_count_), items_.end(),
        [&](const Item& item) {
          return group_value_[static_cast<std::size_t>(item.id)] == group.probability &&
                 std::is_permutation(item.members.begin(), item.members.end(),
                                     group.members.begin(), group.members.end());
        });
    if (same != items_.end()) {
      ids.push_back(same->id);
      continue;
    }
    Item item =
        make_group(items_, std::move(group.members), static_cast<std::int32_t>(items_.size()));
    ids.push_back(item.id);
    items_.push_back(std::move(item));
    group_value_.push_back(group.probability);
    twin_.push_back(ids.back());  // groups share no members: they are no twins
    cornered_.emplace_back();
  }
  return ids;
}

void Matcher::evaluate_class(int class_index) {
  const auto& clauses = clauses_[class_index];
  std::vector<std::int32_t> pool;
  if (group_clause_[class_index] >= 0) {
    pool = find_groups(clauses[group_clause_[class_index]]);
  } else {
    pool = index_.candidates(clauses);
  }
  auto& list = candidates_[class_index];
  const double prior = std::log(prior_of(ontology_, class_index));
  bool needs_rivals = false;
  for (const auto id : pool) {
    Candidate candidate;
    candidate.item = id;
    candidate.score = prior;
    bool possible = true;
    // Own features first: they are cheap and rule most out.
    for (const bool relational : {false, true}) {
      for (const auto& clause : clauses) {
        const bool is_relation =
            clause.kind == ClauseKind::relation || clause.kind == ClauseKind::negation;
        if (clause.usually || is_relation != relational) continue;
        if (clause.kind == ClauseKind::extremum && clause.extremum == Extremum::largest) {
          needs_rivals = true;
          continue;
        }
        const double value =
            is_relation ? evaluate_relation(clause, id).value : evaluate_unary(clause, id).value;
        if (value < required_gate) {
          possible = false;
          break;
        }
        candidate.fit *= value;
        candidate.score += ontology_.temperature * weight_of(clause) * evidence_of(clause, value);
      }
      if (!possible) break;
    }
    if (possible) list.push_back(candidate);
  }
  publish(class_index);
  if (!needs_rivals) return;
  std::vector<double> values;
  for (const auto& candidate : list)
    values.push_back(evaluate_largest(class_index, candidate.item).value);
  std::vector<Candidate> kept;
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (const auto& clause : clauses) {
      if (clause.usually || clause.kind != ClauseKind::extremum ||
          clause.extremum != Extremum::largest)
        continue;
      list[i].score += ontology_.temperature * weight_of(clause) * evidence_of(clause, values[i]);
    }
    if (values[i] >= required_gate) kept.push_back(list[i]);
  }
  list = kept;
  publish(class_index);
}

void Matcher::publish(int class_index) {
  const double unknown = std::log(unknown_prior_of(ontology_));
  auto& targets = targets_[class_index];
  targets.clear();
  for (auto& candidate : candidates_[class_index]) {
    candidate.belief = 1.0 / (1.0 + std::exp(unknown - candidate.score));
    targets.push_back({candidate.belief, candidate.item, candidate.fit});
  }
  std::sort(targets.begin(), targets.end(), [](const Target& a, const Target& b) {
    return a.belief != b.belief ? a.belief > b.belief : a.item < b.item;
  });
  auto& runs = runs_[class_index];
  runs.clear();
  std::map<std::int32_t, std::size_t> known;  // of this belief: the run of a geometry
  for (const auto& target : targets) {
    if (!runs.empty() && runs.back().belief != target.belief) known.clear();
    const auto [at, fresh] = known.try_emplace(twin_[target.item], runs.size());
    if (fresh) {
      runs.push_back({target.belief, target.item, -1, 1});
      continue;
    }
    Run& run = runs[at->second];
    if (run.second < 0) run.second = target.item;
    ++run.count;
  }
  if (runs.size() < many_targets) return;
  std::vector<Eigen::AlignedBox3d> boxes;
  std::vector<std::int32_t> far;
  for (const auto& run : runs) {
    if (reaches_far(items_[run.first])) far.push_back(static_cast<std::int32_t>(boxes.size()));
    boxes.push_back(items_[run.first].box);
  }
  grids_[class_index] = PlanGrid(boxes, far);
}

void Matcher::evaluate_context(int class_index) {
  for (const auto& clause : clauses_[class_index]) {
    if (!clause.usually) continue;
    for (auto& candidate : candidates_[class_index]) {
      const double value = evaluate(class_index, clause, candidate.item).value;
      candidate.score += ontology_.temperature * weight_of(clause) * evidence_of(clause, value);
    }
  }
}

void Matcher::run() {
  running_ = true;
  for (const int c : evaluation_order(ontology_)) evaluate_class(c);
  // Context looks at the beliefs of the first pass only: no support of oneself, and the order of
  // classes does not matter.
  for (std::size_t c = 0; c < clauses_.size(); ++c) evaluate_context(static_cast<int>(c));
  running_ = false;
}

}  // namespace scanchor
