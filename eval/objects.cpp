#include "eval/objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "eval/segments.hpp"
#include "eval/statistics.hpp"

namespace scanchor {
namespace {

std::vector<ThingResult> list_things(const Segments& segments, const ScanTruth& truth,
                                     const ClassRules& rules,
                                     const std::vector<ClassId>& described) {
  std::map<std::int32_t, const ThingTruth*> by_instance;
  for (const auto& thing : truth.things) by_instance[thing.instance] = &thing;
  std::vector<char> has_word(rules.size(), described.empty() ? 1 : 0);
  for (const auto id : described) {
    if (const auto counted = rules.of(id); counted >= 0)
      has_word[static_cast<std::size_t>(counted)] = 1;
  }
  std::vector<ThingResult> things;
  for (const auto& segment : segments.truth) {
    ThingResult thing;
    thing.instance = segment.instance;
    thing.class_id = segment.class_id;
    thing.points = segment.points;
    thing.name = rules.names[static_cast<std::size_t>(segment.class_id)];
    if (segment.instance >= 0) {
      thing.name += fmt::format(" {}", segment.instance);
      if (const auto found = by_instance.find(segment.instance); found != by_instance.end()) {
        thing.visible_fraction = found->second->visible_fraction;
      }
    }
    if (segment.ignored) thing.status = ThingStatus::ignored;
    if (!has_word[static_cast<std::size_t>(segment.class_id)])
      thing.status = ThingStatus::not_described;
    things.push_back(thing);
  }
  return things;
}

// For each claim, the truth that most of it lies on.
void lay_claims(const Segments& segments, const Protocol& protocol,
                std::vector<ClaimResult>& claims) {
  std::vector<std::int64_t> most(claims.size(), 0);
  for (const auto& overlap : segments.overlaps) {
    const auto p = static_cast<std::size_t>(overlap.predicted);
    if (segments.truth[static_cast<std::size_t>(overlap.truth)].ignored ||
        overlap.points <= most[p])
      continue;
    most[p] = overlap.points;
    claims[p].thing = overlap.truth;
  }
  for (std::size_t p = 0; p < claims.size(); ++p) {
    const auto& segment = segments.predicted[p];
    claims[p].purity = ratio_of(most[p], segment.points - segment.void_points);
    if (claims[p].purity <= protocol.object_purity) claims[p].thing = -1;
  }
}

void match(const Segments& segments, const Protocol& protocol, std::vector<ThingResult>& things,
           std::vector<ClaimResult>& claims) {
  // The claim with the most points on the thing finds it; on a tie the surer one, then the first.
  std::vector<std::int64_t> best(things.size(), 0);
  for (const auto& overlap : segments.overlaps) {
    const auto t = static_cast<std::size_t>(overlap.truth);
    const auto p = static_cast<std::size_t>(overlap.predicted);
    ThingResult& thing = things[t];
    ClaimResult& claim = claims[p];
    if (claim.thing != overlap.truth || claim.class_id != thing.class_id) continue;
    if (thing.status == ThingStatus::not_described) {
      claim.status = ClaimStatus::ignored;
      continue;
    }
    claim.status = ClaimStatus::repeated;
    if (thing.status == ThingStatus::ignored ||
        ratio_of(overlap.points, thing.points) < protocol.object_coverage)
      continue;
    const bool surer = overlap.points == best[t] &&
                       claim.confidence > claims[static_cast<std::size_t>(thing.claim)].confidence;
    if (overlap.points < best[t] || (overlap.points == best[t] && !surer)) continue;
    best[t] = overlap.points;
    thing.claim = overlap.predicted;
    thing.coverage = ratio_of(overlap.points, thing.points);
  }
  for (auto& thing : things) {
    if (thing.claim < 0) continue;
    thing.status = ThingStatus::found;
    claims[static_cast<std::size_t>(thing.claim)].status = ClaimStatus::right;
  }
  // As in panopticapi: points that do not count keep no claim from being right, but one that finds
  // nothing is not held against it where most of its points are such.
  for (std::size_t p = 0; p < claims.size(); ++p) {
    const auto& segment = segments.predicted[p];
    if (claims[p].status != ClaimStatus::right && 2 * segment.void_points > segment.points)
      claims[p].status = ClaimStatus::ignored;
  }
  std::vector<std::int64_t> named(things.size(), 0);
  for (const auto& overlap : segments.overlaps) {
    auto& thing = things[static_cast<std::size_t>(overlap.truth)];
    auto& most = named[static_cast<std::size_t>(overlap.truth)];
    if (overlap.points <= most) continue;
    most = overlap.points;
    thing.called = segments.predicted[static_cast<std::size_t>(overlap.predicted)].class_id;
  }
}

}  // namespace

double ObjectCounts::precision() const { return ratio_of(found, claims()); }
double ObjectCounts::recall() const { return ratio_of(found, truths); }
double ObjectCounts::f1() const { return ratio_of(2 * found, claims() + truths); }

void ObjectCounts::add(const ObjectCounts& other) {
  truths += other.truths;
  found += other.found;
  wrong += other.wrong;
  repeated += other.repeated;
}

void ObjectScore::add(const ObjectScore& other) {
  if (classes.size() < other.classes.size()) classes.resize(other.classes.size());
  for (std::size_t c = 0; c < other.classes.size(); ++c) classes[c].add(other.classes[c]);
  ignored += other.ignored;
  not_described += other.not_described;
}

ObjectCounts ObjectScore::total() const {
  ObjectCounts sum;
  for (const auto& counts : classes) sum.add(counts);
  return sum;
}

double ObjectScore::mean_f1() const {
  double sum = 0;
  int count = 0;
  for (const auto& counts : classes) {
    if (counts.truths + counts.claims() == 0) continue;
    sum += counts.f1();
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

ObjectSummary summarize_objects(const ScanTruth& truth, const PointPrediction& prediction,
                                const Protocol& protocol, const std::vector<ClassId>& described) {
  const ClassRules rules = class_rules(protocol);
  Protocol own = protocol;
  own.merge_stuff = true;
  own.small = "ignore";
  const Segments segments =
      make_segments({truth.class_id, truth.instance}, {prediction.class_id, prediction.instance},
                    prediction.confidence, truth.ignored_instances, rules, own);
  ObjectSummary summary;
  summary.things = list_things(segments, truth, rules, described);
  for (const auto& segment : segments.predicted) {
    summary.claims.push_back(
        {segment.instance, segment.class_id, segment.points, segment.confidence});
  }
  lay_claims(segments, protocol, summary.claims);
  match(segments, protocol, summary.things, summary.claims);

  summary.score.classes.resize(rules.size());
  for (const auto& thing : summary.things) {
    auto& counts = summary.score.classes[static_cast<std::size_t>(thing.class_id)];
    if (thing.status == ThingStatus::ignored) ++summary.score.ignored;
    if (thing.status == ThingStatus::not_described) ++summary.score.not_described;
    if (thing.status == ThingStatus::found || thing.status == ThingStatus::missed) ++counts.truths;
    if (thing.status == ThingStatus::found) ++counts.found;
  }
  for (const auto& claim : summary.claims) {
    auto& counts = summary.score.classes[static_cast<std::size_t>(claim.class_id)];
    if (claim.status == ClaimStatus::wrong) ++counts.wrong;
    if (claim.status == ClaimStatus::repeated) ++counts.repeated;
  }
  const auto stuff_first = [&](std::int32_t id) {
    return rules.thing[static_cast<std::size_t>(id)] != 0;
  };
  // The claims refer to things by index: sort an order, then renumber.
  std::vector<std::int32_t> order(summary.things.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::int32_t>(i);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return stuff_first(summary.things[static_cast<std::size_t>(a)].class_id) <
           stuff_first(summary.things[static_cast<std::size_t>(b)].class_id);
  });
  std::vector<ThingResult> sorted;
  std::vector<std::int32_t> place(order.size());
  for (const auto i : order) {
    place[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(sorted.size());
    sorted.push_back(summary.things[static_cast<std::size_t>(i)]);
  }
  summary.things = std::move(sorted);
  for (auto& claim : summary.claims) {
    if (claim.thing >= 0) claim.thing = place[static_cast<std::size_t>(claim.thing)];
  }
  return summary;
}

ObjectSummary summarize_objects(const Scan& scan, const Scene* scene, const Surfaces& surfaces,
                                const Labelling& labelling, const Protocol& protocol,
                                const std::vector<ClassId>& described) {
  return summarize_objects(truth_of(scan, scene, protocol), predict_points(surfaces, labelling),
                           protocol, described);
}

std::string objects_to_text(const ObjectSummary& summary, bool with_lists) {
  std::string text = fmt::format("{:<18} {:>6} {:>6} {:>7} {:>6} {:>10} {:>7}\n", "class", "there",
                                 "found", "missed", "wrong", "precision", "recall");
  const auto line = [&](const std::string& name, const ObjectCounts& c) {
    const auto percent = [](std::int64_t whole, double value) {
      return whole > 0 ? fmt::format("{:.0f} %", 100 * value) : std::string("-");
    };
    text += fmt::format("{:<18} {:>6} {:>6} {:>7} {:>6} {:>10} {:>7}\n", name, c.truths, c.found,
                        c.missed(), c.wrong + c.repeated, percent(c.claims(), c.precision()),
                        percent(c.truths, c.recall()));
  };
  for (std::size_t id = 0; id < summary.score.classes.size(); ++id) {
    const auto& counts = summary.score.classes[id];
    if (counts.truths + counts.claims() > 0)
      line(std::string(class_info(static_cast<ClassId>(id)).name), counts);
  }
  line("all", summary.score.total());
  if (!with_lists) return text;
  for (const auto& thing : summary.things) {
    if (thing.status != ThingStatus::missed) continue;
    text += fmt::format("missed: {} ({} points, {:.0f} % of its best face seen{})\n", thing.name,
                        thing.points, 100 * thing.visible_fraction,
                        thing.called == unlabelled
                            ? ""
                            : fmt::format(", called {}", class_info(thing.called).name));
  }
  for (const auto& claim : summary.claims) {
    if (claim.status != ClaimStatus::wrong && claim.status != ClaimStatus::repeated) continue;
    text += fmt::format(
        "{}: {} ({} points, {:.2f}) {}\n",
        claim.status == ClaimStatus::wrong ? "wrong" : "repeated", class_info(claim.class_id).name,
        claim.points, claim.confidence,
        claim.thing < 0 ? "lies on nothing in particular"
                        : "lies on " + summary.things[static_cast<std::size_t>(claim.thing)].name);
  }
  if (summary.score.ignored > 0)
    text += fmt::format("{} things could not be seen well enough and do not count\n",
                        summary.score.ignored);
  if (summary.score.not_described > 0)
    text += fmt::format("{} things are of classes that are not described and do not count\n",
                        summary.score.not_described);
  return text;
}

}  // namespace scanchor
