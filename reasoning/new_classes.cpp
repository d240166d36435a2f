#include "reasoning/new_classes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "reasoning/background.hpp"
#include "reasoning/matcher.hpp"

namespace scanchor {

namespace {

/// Who describes a class has one of it in a room.
constexpr double usual_things = 1.0;

/// One thing in the rooms that the description may hold of.
struct Rival {
  double evidence;   ///< sum of the weighed likelihood ratios of the new class
  double others;     ///< ln of the sum of what all other classes say, none of them being 1
  std::string name;  ///< true name where no other class describes it; "" where one does
};

/// ln(1 + sum of exp(score) / prior_0 of all classes but the new ones) of each item.
std::vector<double> scores_of_others(const Ontology& ontology, const Matcher& matcher,
                                     const std::vector<char>& is_new) {
  std::vector<double> sum(matcher.items().size(), unknown_prior_of(ontology));
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    if (is_new[c] != 0 || only_a_member(ontology, static_cast<int>(c))) continue;
    for (const auto& candidate : matcher.candidates(static_cast<int>(c)))
      sum[static_cast<std::size_t>(candidate.item)] += std::exp(candidate.score);
  }
  const double none = std::log(unknown_prior_of(ontology));
  for (double& s : sum) s = std::log(s) - none;
  return sum;
}

/// The name of an item; of a group that of most of its members' area.
std::string name_of(const Matcher& matcher, const ReferenceRoom& room, const Item& item) {
  return item.group ? name_of_most(matcher, item, room.classes)
                    : room.classes[static_cast<std::size_t>(item.id)];
}

/// What the weighed clauses say of a thing of the class, on the average.
double usual_evidence(const std::vector<Clause>& clauses) {
  double sum = 0.0;
  for (const auto& clause : clauses) {
    const double a = hit_rate_of(clause), b = background_of(clause);
    if (clause.kind == ClauseKind::group) {
      sum += weight_of(clause) * std::log(a / b);
    } else {
      sum +=
          weight_of(clause) * (a * std::log(a / b) + (1.0 - a) * std::log((1.0 - a) / (1.0 - b)));
    }
  }
  return sum;
}

double sigmoid(double x) { return 1.0 / (1.0 + std::exp(-x)); }

/// The offset with which as many things are claimed as there are of the class: the maximum of the
/// likelihood of a logistic regression with nothing but an offset. Of the class are the rivals of
/// the name `own` and `unseen` more of usual evidence that nothing else is said of.
double offset_of(const std::vector<Rival>& rivals, const std::string& own, double unseen,
                 double usual) {
  double number = unseen;
  for (const auto& rival : rivals) number += !own.empty() && rival.name == own ? 1.0 : 0.0;
  double low = -60.0, high = 60.0;
  for (int i = 0; i < 60; ++i) {
    const double offset = 0.5 * (low + high);
    double claimed = unseen * sigmoid(offset + usual);
    for (const auto& rival : rivals) claimed += sigmoid(offset + rival.evidence - rival.others);
    (claimed > number ? high : low) = offset;
  }
  return low;
}

/// Of the names that no class describes at most one is what the new class means: the one that it
/// would claim most of.
std::string meant(const std::vector<Rival>& rivals, double offset) {
  std::map<std::string, double> claimed;
  for (const auto& rival : rivals) {
    if (!rival.name.empty()) claimed[rival.name] += sigmoid(offset + rival.evidence - rival.others);
  }
  const auto most =
      std::max_element(claimed.begin(), claimed.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most != claimed.end() ? most->first : "";
}

/// How often each clause holds of other things.
struct Rate {
  double sum = 0.0, number = 0.0;
  [[nodiscard]] double towards(double standard) const {
    return std::clamp((sum + 10.0 * standard) / (number + 10.0), 0.002, 0.998);
  }
};

/// The rooms as the classes see them.
using Matched = std::vector<std::unique_ptr<Matcher>>;

Matched match_all(const Ontology& ontology, const std::vector<ReferenceRoom>& rooms) {
  Matched matched;
  for (const auto& room : rooms) {
    matched.push_back(std::make_unique<Matcher>(ontology, room.items, room.around));
    matched.back()->run();
  }
  return matched;
}

void count_rates(Ontology& ontology, const std::vector<int>& classes,
                 const std::vector<ReferenceRoom>& rooms, const Matched& matched) {
  std::map<int, std::vector<Rate>> rates;
  for (const int c : classes)
    rates[c].resize(ontology.classes[static_cast<std::size_t>(c)].clauses.size());
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const Matcher& matcher = *matched[r];
    for (const int c : classes) {
      const auto& clauses = ontology.classes[static_cast<std::size_t>(c)].clauses;
      for (const auto& item : matcher.items()) {
        if (matcher.is_group_class(c) != item.group) continue;
        const bool candidate = matcher.belief(c, item.id) > 0.0;
        if (item.group && !candidate) continue;
        if (!item.group) {
          const int truth = ontology.find(rooms[r].classes[static_cast<std::size_t>(item.id)]);
          if (truth >= 0 && are_akin(ontology, c, truth)) continue;
        }
        for (std::size_t i = 0; i < clauses.size(); ++i) {
          if (clauses[i].usually && !candidate) continue;
          auto& rate = rates[c][i];
          rate.sum += matcher.evaluate(c, clauses[i], item.id).value;
          rate.number += 1.0;
        }
      }
    }
  }
  for (const int c : classes) {
    auto& clauses = ontology.classes[static_cast<std::size_t>(c)].clauses;
    for (std::size_t i = 0; i < clauses.size(); ++i)
      clauses[i].background = rates[c][i].towards(background_of(clauses[i]));
  }
}

std::map<int, std::vector<Rival>> find_rivals(const Ontology& ontology,
                                              const std::vector<int>& classes,
                                              const std::vector<char>& is_new,
                                              const std::vector<ReferenceRoom>& rooms,
                                              const Matched& matched) {
  std::map<int, std::vector<Rival>> rivals;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const Matcher& matcher = *matched[r];
    const auto others = scores_of_others(ontology, matcher, is_new);
    for (const int c : classes) {
      const auto clauses = all_clauses(ontology, c);  // with the rates that were counted just now
      for (const auto& candidate : matcher.candidates(c)) {
        const auto i = static_cast<std::size_t>(candidate.item);
        std::string name = name_of(matcher, rooms[r], matcher.items()[i]);
        const int truth = ontology.find(name);
        if (truth >= 0 && truth != c && are_akin(ontology, c, truth)) continue;
        if (truth >= 0 && truth != c) name.clear();
        double evidence = 0.0;
        for (const auto& clause : clauses) {
          const double value = matcher.evaluate(c, clause, candidate.item).value;
          evidence += ontology.temperature * weight_of(clause) * evidence_of(clause, value);
        }
        rivals[c].push_back({evidence, others[i], std::move(name)});
      }
    }
  }
  return rivals;
}

/// ln of the prior, none of the classes being 0.
double calibrated(const ClassDescription& described, const std::vector<Rival>& rivals,
                  std::size_t rooms, double usual) {
  const double usual_number = usual_things * static_cast<double>(rooms);
  for (const auto& name : described.names) {  // the rooms know the class by its name
    const bool known = std::any_of(rivals.begin(), rivals.end(),
                                   [&](const Rival& rival) { return rival.name == name; });
    if (known) return offset_of(rivals, name, 0.1 * usual_number, usual);
  }
  const std::string own = meant(rivals, offset_of(rivals, "", usual_number, usual));
  const auto seen = std::count_if(rivals.begin(), rivals.end(), [&](const Rival& rival) {
    return !own.empty() && rival.name == own;
  });
  return offset_of(rivals, own, std::max(0.0, usual_number - static_cast<double>(seen)), usual);
}

}  // namespace

std::vector<int> new_classes(const Ontology& ontology) {
  std::vector<int> found;
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    const auto& described = ontology.classes[c];
    const auto uncounted =
        std::count_if(described.clauses.begin(), described.clauses.end(),
                      [](const Clause& clause) { return clause.hit_rate < 0.0; });
    const bool own_words = 2 * static_cast<std::size_t>(uncounted) > described.clauses.size();
    if (described.prior < 0.0 || own_words) found.push_back(static_cast<int>(c));
  }
  return found;
}

void weigh_new_classes(Ontology& ontology, const std::vector<int>& classes,
                       const std::vector<ReferenceRoom>& rooms) {
  if (rooms.empty() || classes.empty()) return;
  std::vector<char> is_new(ontology.classes.size(), 0);
  for (const int c : classes) is_new[static_cast<std::size_t>(c)] = 1;
  Matched matched = match_all(ontology, rooms);
  count_rates(ontology, classes, rooms, matched);
  const double none = unknown_prior_of(ontology);
  // New classes that build on each other need the offsets of the first round.
  for (int round = 0; round < (classes.size() > 1 ? 2 : 1); ++round) {
    if (round > 0) matched = match_all(ontology, rooms);
    const auto rivals = find_rivals(ontology, classes, is_new, rooms, matched);
    for (const int c : classes) {
      auto& described = ontology.classes[static_cast<std::size_t>(c)];
      const auto own = rivals.find(c);
      const double offset =
          calibrated(described, own != rivals.end() ? own->second : std::vector<Rival>(),
                     rooms.size(), usual_evidence(all_clauses(ontology, c)));
      described.prior = none * std::exp(offset);
    }
  }
}

}  // namespace scanchor
