#include "reasoning/explain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reasoning/item.hpp"
#include "reasoning/limits.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

std::string rounded(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

int digits_for(const std::string& unit) { return unit == "deg" ? 1 : unit == "m2" ? 2 : 3; }

std::string measurement(double value, double sigma, const std::string& unit) {
  if (unit.empty()) return "not measured";
  const int digits = digits_for(unit);
  std::string text = rounded(value, digits);
  if (sigma > 0.0) text += " +- " + rounded(sigma, digits);
  return text + (unit == "1" ? "" : " " + unit);
}

std::string verdict(double likelihood) {
  if (likelihood >= 0.5) return "holds (" + rounded(likelihood, 2) + ")";
  return "fails (" + rounded(likelihood, 2) + ")";
}

const Entity& entity_of(const Labelling& labelling, std::int32_t id) {
  if (id < 0 || static_cast<std::size_t>(id) >= labelling.entities.size()) {
    fail_usage("there is no entity " + std::to_string(id),
               labelling.entities.empty()
                   ? "the labelling is empty"
                   : "they are numbered 0 to " + std::to_string(labelling.entities.size() - 1));
  }
  return labelling.entities[static_cast<std::size_t>(id)];
}

void explain_clause(const ProofClause& clause, const std::string& indent,
                    const std::set<std::int32_t>& done, std::vector<std::int32_t>& next,
                    std::string& out) {
  out += indent + clause.text + ": ";
  if (!clause.unit.empty()) out += measurement(clause.measured, clause.sigma, clause.unit) + ", ";
  out += verdict(clause.likelihood);
  if (!clause.targets.empty()) {
    out += " on";
    for (const auto t : clause.targets) {
      out += " " + std::to_string(t);
      if (done.count(t) == 0 && std::find(next.begin(), next.end(), t) == next.end())
        next.push_back(t);
    }
  } else if (!clause.target_class.empty() && clause.unit.empty()) {
    out += ", there is no " + clause.target_class;
  }
  out += "\n";
  for (const auto& nested : clause.that_is) explain_clause(nested, indent + "  ", done, next, out);
}

void explain_one(const Labelling& labelling, std::int32_t id, std::set<std::int32_t>& done,
                 std::vector<std::int32_t>& next, std::string& out) {
  const Entity& entity = entity_of(labelling, id);
  done.insert(id);
  out += std::to_string(id) + " is ";
  if (entity.label == "unknown") {
    out += "unknown (" + rounded(entity.probability, 2) + ")";
    for (const auto& c : entity.classes) {
      if (c.name == "unknown") continue;
      out += "; the nearest class is " + c.name + " (" + rounded(c.probability, 2) + ")";
      break;
    }
  } else if (entity.label == "ambiguous") {
    out += "ambiguous: ";
    int named = 0;
    for (const auto& c : entity.classes) {
      if (c.name == "unknown" || named == 2) continue;
      out += (named++ == 0 ? "" : " or ") + c.name + " (" + rounded(c.probability, 2) + ")";
    }
  } else {
    out += with_article(entity.label) + " (" + rounded(entity.probability, 2) + ")";
  }
  if (entity.whole >= 0) out += ", part of " + std::to_string(entity.whole);
  for (const auto& a : labelling.alternatives) {
    if (std::find(a.surfaces.begin(), a.surfaces.end(), id) == a.surfaces.end()) continue;
    const std::string before = a.of == 1 ? "one surface" : std::to_string(a.of) + " surfaces";
    out += "; " + before + " " + a.kind + ": as a " + a.class_name + " e^" +
           rounded(a.log_ratio, 1) + " times as likely";
  }
  out += "\n";
  for (const auto& clause : entity.proof) explain_clause(clause, "  ", done, next, out);
}

/// The limit that is missed: where the likelihood of the clause passes one half.
void needed_value(const Clause& clause, const Item& item, const ClauseValue& value,
                  const std::vector<Item>& items, const Surrounding& around, WhyNot& answer) {
  Limits limits;
  if (clause.kind == ClauseKind::relation) {
    if (value.target < 0) return;
    // The weakest relation of the conjunction is the one to mend.
    double least = 2.0;
    for (const auto& term : clause.relations) {
      const double l = relate(term, item, items[value.target], around).likelihood;
      if (l >= least) continue;
      least = l;
      limits = limits_of(term);
    }
  } else {
    limits = limits_of(clause);
  }
  answer.needed = answer.measured < limits.low ? limits.low : limits.high;
  answer.has_needed = std::isfinite(answer.needed) &&
                      (answer.measured < limits.low || answer.measured > limits.high);
}

}  // namespace

std::string explain(const Labelling& labelling, std::int32_t entity) {
  std::string out;
  std::set<std::int32_t> done;
  std::vector<std::int32_t> next = {entity};
  entity_of(labelling, entity);
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (done.count(next[i]) == 0) explain_one(labelling, next[i], done, next, out);
  }
  return out;
}

WhyNot why_not(const Surfaces& surfaces, const Ontology& ontology, const Labelling& labelling,
               std::int32_t entity, const std::string& class_name) {
  const Entity& wanted = entity_of(labelling, entity);
  const int c = ontology.find(class_name);
  if (c < 0)
    fail_usage("the ontology has no class '" + class_name + "'",
               suggestion(class_name, ontology.class_names()));
  const Eigen::Matrix3d R = levelling(labelling.up);
  Surrounding around;
  around.up_sigma = labelling.up_sigma;
  if (!surfaces.sensor_positions.empty()) around.viewpoint = R * surfaces.sensor_positions.front();
  Matcher matcher(ontology, make_items(surfaces, R), around);
  matcher.run();
  if (static_cast<std::size_t>(entity) >= matcher.items().size()) {
    fail_usage("entity " + std::to_string(entity) + " is none of these surfaces",
               "label them anew");
  }
  WhyNot answer;
  answer.holds = true;
  std::string table;
  for (const auto& clause : matcher.clauses(c)) {
    const ClauseValue value = matcher.evaluate(c, clause, entity);
    const std::string text = clause_text(clause);
    table +=
        "  " + text + ": " +
        (value.evidence.unit[0] != '\0'
             ? measurement(value.evidence.measured, value.evidence.sigma, value.evidence.unit) +
                   ", "
             : "") +
        verdict(value.value) + (value.target >= 0 ? " on " + std::to_string(value.target) : "") +
        "\n";
    if (clause.usually || value.value >= 0.5 || !answer.clause.empty()) continue;
    answer.holds = false;
    answer.clause = text;
    answer.likelihood = value.value;
    answer.measured = value.evidence.measured;
    answer.sigma = value.evidence.sigma;
    answer.unit = value.evidence.unit;
    if (value.target >= 0)
      answer.target = std::to_string(value.target) + " (" + clause.target + ")";
    // Where the target itself is what fails, the number to change is the target's.
    const Clause* blamed = &clause;
    ClauseValue blamed_value = value;
    std::int32_t blamed_item = entity;
    for (const auto& nested : clause.target_clauses) {
      if (value.target < 0) break;
      const ClauseValue of_target =
          matcher.evaluate(ontology.find(clause.target), nested, value.target);
      if (of_target.value >= 0.5) continue;
      blamed = &nested;
      blamed_value = of_target;
      blamed_item = value.target;
      answer.measured = of_target.evidence.measured;
      answer.sigma = of_target.evidence.sigma;
      answer.unit = of_target.evidence.unit;
      answer.clause = clause_text(nested);
      break;
    }
    needed_value(*blamed, matcher.items()[blamed_item], blamed_value, matcher.items(), around,
                 answer);
    if (answer.unit.empty() && !clause.target.empty()) answer.target.clear();
  }

  const std::string& name = ontology.classes[c].name();
  std::string head = std::to_string(entity) + " is not " + with_article(name);
  if (wanted.label == name) head = std::to_string(entity) + " is " + with_article(name);
  if (answer.holds) {
    if (wanted.label == name) {
      head += ": every clause holds";
    } else {
      head += " although every clause holds: ";
      const bool rival = wanted.label != "unknown" && wanted.label != "ambiguous";
      head += rival ? wanted.label + " is likelier (" + rounded(wanted.probability, 2) + ")"
                    : "the description is not specific enough for " + rounded(0.5, 1);
    }
  } else {
    head += ": '" + answer.clause + "' fails";
    if (answer.unit.empty()) {
      head += ", nothing in the scene satisfies it";
    } else {
      head += ", measured " + measurement(answer.measured, answer.sigma, answer.unit);
      if (!answer.target.empty()) head += " on " + answer.target;
      if (answer.has_needed) {
        const double change = answer.needed - answer.measured;
        head += "; it would hold from " + measurement(answer.needed, 0.0, answer.unit) +
                ", a change of " + (change > 0.0 ? "+" : "") +
                measurement(change, 0.0, answer.unit);
      }
    }
  }
  answer.text = head + "\n" + table;
  return answer;
}

}  // namespace scanchor
