#include "eval/gate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/text.hpp"

namespace scanchor {
namespace {

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0.0; }

std::size_t tolerance_index(const Protocol& protocol) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < protocol.plane_tolerances.size(); ++i) {
    const auto off = [&](std::size_t k) {
      return std::abs(protocol.plane_tolerances[k] - protocol.geometry_tolerance);
    };
    if (off(i) < off(best)) best = i;
  }
  return best;
}

using Row = std::vector<double>;
using CountsOf = std::function<Row(const Score&)>;

ObjectCounts object_counts(const Score& score, int class_id) {
  if (class_id < 0) return score.objects.total();
  const auto c = static_cast<std::size_t>(class_id);
  return c < score.objects.classes.size() ? score.objects.classes[c] : ObjectCounts{};
}

void use_objects(const std::string& kind, int class_id, PairedCounts& counts, CountsOf& row) {
  row = [class_id](const Score& score) {
    const auto c = object_counts(score, class_id);
    return Row{static_cast<double>(c.found), static_cast<double>(c.claims()),
               static_cast<double>(c.truths)};
  };
  if (kind == "f1")
    counts.value = [](std::span<const double> s) { return ratio(2 * s[0], s[1] + s[2]); };
  if (kind == "precision")
    counts.value = [](std::span<const double> s) { return ratio(s[0], s[1]); };
  if (kind == "recall") counts.value = [](std::span<const double> s) { return ratio(s[0], s[2]); };
}

// Classes with counts anywhere in the two runs, so that rows stay short.
std::vector<std::size_t> used_classes(const std::vector<const Score*>& before,
                                      const std::vector<const Score*>& after,
                                      const ClassRules& rules) {
  std::vector<char> used(rules.size(), 0);
  for (const auto* scores : {&before, &after}) {
    for (const auto* score : *scores) {
      for (std::size_t c = 0; c < rules.size(); ++c) {
        const bool seen =
            !class_points(score->points, c).absent() ||
            (c < score->panoptic.classes.size() && score->panoptic.classes[c] != PanopticCounts{});
        used[c] = used[c] || (rules.scored[c] && seen) ? 1 : 0;
      }
    }
  }
  std::vector<std::size_t> list;
  for (std::size_t c = 0; c < used.size(); ++c) {
    if (used[c]) list.push_back(c);
  }
  return list;
}

void use_classes(bool panoptic, const std::vector<std::size_t>& classes, bool skip_absent,
                 double all, PairedCounts& counts, CountsOf& row) {
  row = [=](const Score& score) {
    Row r;
    for (const auto c : classes) {
      if (panoptic) {
        const auto p =
            c < score.panoptic.classes.size() ? score.panoptic.classes[c] : PanopticCounts{};
        r.insert(r.end(), {p.iou.value(), static_cast<double>(p.matched) +
                                              0.5 * static_cast<double>(p.extra + p.missed)});
      } else {
        const auto p = class_points(score.points, c);
        r.insert(r.end(),
                 {static_cast<double>(p.right), static_cast<double>(p.right + p.wrong + p.missed)});
      }
    }
    return r;
  };
  counts.value = [=](std::span<const double> s) {
    double sum = 0, seen = 0;
    for (std::size_t k = 0; k + 1 < s.size(); k += 2) {
      if (s[k + 1] < 0.25) continue;  // counts are whole or half numbers
      sum += s[k] / s[k + 1];
      seen += 1;
    }
    return ratio(sum, skip_absent ? seen : all);
  };
}

Verdict judge(const GateMetric& metric, const GateOptions& options, double level) {
  if (metric.change.high < 0 && metric.difference() < -0.5 * options.margin &&
      metric.p_adjusted < level)
    return Verdict::regressed;
  if (metric.change.low > 0) return Verdict::improved;
  if (metric.change.low > -options.margin) return Verdict::not_worse;
  return Verdict::inconclusive;
}

GateMetric measure(const PairedCounts& counts, double level, const GateOptions& options, double p) {
  GateMetric metric;
  metric.name = counts.name;
  metric.before = pooled_value(counts, counts.before);
  metric.after = pooled_value(counts, counts.after);
  // Nothing changed in any scene: nothing to draw.
  if (counts.before == counts.after) return metric;
  metric.change = bca_interval(counts, 1.0 - 2.0 * level, options.replicates, options.seed);
  metric.p = p;
  return metric;
}

}  // namespace

void GateOptions::describe(OptionList& list) {
  list.add("margin", margin, "1", "a drop up to that is accepted", 0, 1);
  list.add("alpha", alpha, "1", "share of false alarms of the whole gate, at most", 1e-6, 0.49);
  list.add("replicates", replicates, "", "of the bootstrap and the sign flips", 100, 10000000);
  list.add("seed", seed, "of the bootstrap and the sign flips");
  list.add("correction", correction, "of the p-values for several metrics",
           {"westfall-young", "holm"});
  list.add("strict", strict, "inconclusive is exit code 5");
}

std::string verdict_word(Verdict verdict) {
  switch (verdict) {
    case Verdict::not_worse:
      return "not worse";
    case Verdict::improved:
      return "improved";
    case Verdict::regressed:
      return "regressed";
    case Verdict::inconclusive:
      break;
  }
  return "inconclusive";
}

ExitCode GateReport::exit_code(bool strict) const {
  if (verdict == Verdict::regressed) return ExitCode::gate_failed;
  if (verdict == Verdict::inconclusive && strict) return ExitCode::inconclusive;
  return ExitCode::done;
}

PairedCounts paired_counts(const std::string& metric, const std::vector<const Score*>& before,
                           const std::vector<const Score*>& after, const Protocol& protocol) {
  PairedCounts counts;
  counts.name = metric;
  CountsOf row;
  const ClassRules rules = class_rules(protocol);
  const std::vector<std::string> known = {"objects.f1",       "objects.precision", "objects.recall",
                                          "panoptic.pq",      "points.miou",       "planes.f1",
                                          "planes.precision", "planes.recall"};
  const std::string of_class = "objects.f1.";
  if (metric.rfind(of_class, 0) == 0 && find_class(metric.substr(of_class.size()))) {
    use_objects("f1", *find_class(metric.substr(of_class.size())), counts, row);
  } else if (std::find(known.begin(), known.end(), metric) == known.end()) {
    fail_usage("no gate can be set on '" + metric + "'", suggestion(metric, known));
  } else if (metric.rfind("objects.", 0) == 0) {
    use_objects(metric.substr(8), -1, counts, row);
  } else if (metric.rfind("planes.", 0) == 0) {
    const std::size_t t = tolerance_index(protocol);
    row = [t](const Score& score) {
      const double correct = t < score.planes.hoover.size()
                                 ? static_cast<double>(score.planes.hoover[t].correct)
                                 : 0.0;
      return Row{correct, static_cast<double>(score.planes.regions),
                 static_cast<double>(score.planes.truths)};
    };
    if (metric == "planes.f1")
      counts.value = [](std::span<const double> s) { return ratio(2 * s[0], s[1] + s[2]); };
    if (metric == "planes.precision")
      counts.value = [](std::span<const double> s) { return ratio(s[0], s[1]); };
    if (metric == "planes.recall")
      counts.value = [](std::span<const double> s) { return ratio(s[0], s[2]); };
  } else {
    const auto scored =
        static_cast<double>(std::count(rules.scored.begin(), rules.scored.end(), 1));
    use_classes(metric == "panoptic.pq", used_classes(before, after, rules),
                protocol.absent_class == "skip", scored, counts, row);
  }
  for (const auto* score : before) counts.before.push_back(row(*score));
  for (const auto* score : after) counts.after.push_back(row(*score));
  return counts;
}

GateReport compare_runs(const RunResult& before, const RunResult& after, const GateOptions& options,
                        double level) {
  require_comparable(before.pooled, after.pooled);
  const double alpha = level > 0 ? level : options.alpha;
  GateReport report;
  report.confidence = 1.0 - 2.0 * alpha;
  report.suite = after.suite;
  report.data = after.data;
  report.protocol = protocol_stamp(after.protocol);
  report.before_method = before.method;
  report.after_method = after.method;
  std::map<int, const SceneRow*> old;
  for (const auto& row : before.rows) old[row.index] = &row;
  std::vector<const Score*> first, second;
  std::vector<const SceneRow*> rows;
  for (const auto& row : after.rows) {
    const auto found = old.find(row.index);
    if (found == old.end()) continue;
    if (found->second->seed != row.seed) {
      fail_data("", "scene " + row.name, "was made from another seed in the baseline",
                "scenes must not be drawn anew between runs");
    }
    const std::string& was_hash = found->second->scan_hash;
    if (!was_hash.empty() && !row.scan_hash.empty() && was_hash != row.scan_hash) {
      fail_data("", "scene " + row.name, "has other scans than in the baseline",
                "what makes rooms or scans changed: measure the baseline anew");
    }
    first.push_back(&found->second->score);
    second.push_back(&row.score);
    rows.push_back(&row);
    for (const auto& line : row.score.failed) {
      const std::string scan = line.substr(0, line.find(": "));
      const auto& was = found->second->score.failed;
      const bool known = std::any_of(was.begin(), was.end(), [&](const std::string& l) {
        return l.rfind(scan + ": ", 0) == 0;
      });
      if (!known) report.newly_failed.push_back(line);
    }
  }
  report.scenes = rows.size();
  if (rows.empty()) throw Error(ExitCode::nothing_measured, "the two runs have no scene in common");
  std::vector<PairedCounts> counts;
  for (const auto& name : options.metrics)
    counts.push_back(paired_counts(name, first, second, after.protocol));
  std::vector<double> single;
  auto adjusted = step_down_p(counts, options.replicates, options.seed, &single);
  if (options.correction == "holm") adjusted = holm_adjust(single);
  for (std::size_t i = 0; i < counts.size(); ++i)
    report.gated.push_back(measure(counts[i], alpha, options, single[i]));
  bool regressed = !report.newly_failed.empty(), inconclusive = false,
       improved = !report.gated.empty();
  for (std::size_t i = 0; i < report.gated.size(); ++i) {
    auto& metric = report.gated[i];
    metric.p_adjusted = adjusted[i];
    metric.verdict =
        counts[i].before == counts[i].after ? Verdict::not_worse : judge(metric, options, alpha);
    regressed = regressed || metric.verdict == Verdict::regressed;
    inconclusive = inconclusive || metric.verdict == Verdict::inconclusive;
    improved = improved && metric.verdict == Verdict::improved;
  }
  report.verdict = regressed      ? Verdict::regressed
                   : inconclusive ? Verdict::inconclusive
                   : improved     ? Verdict::improved
                                  : Verdict::not_worse;
  for (const auto& info : class_list()) {
    if (!options.class_details) break;
    PairedCounts one =
        paired_counts("objects.f1." + std::string(info.name), first, second, after.protocol);
    if (one.before == one.after) continue;
    GateOptions quick = options;
    quick.replicates = std::min(options.replicates, 2000);
    report.classes.push_back(
        measure(one, alpha, quick, sign_flip_p(one, quick.replicates, quick.seed)));
  }
  std::stable_sort(
      report.classes.begin(), report.classes.end(),
      [](const GateMetric& a, const GateMetric& b) { return a.difference() < b.difference(); });
  if (counts.empty()) return report;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double difference = scene_difference(counts.front(), i);
    if (difference < 0)
      report.worst.push_back(
          {rows[i]->index, rows[i]->name, rows[i]->family, rows[i]->seed, difference});
  }
  std::stable_sort(
      report.worst.begin(), report.worst.end(),
      [](const GateScene& a, const GateScene& b) { return a.difference < b.difference; });
  if (report.worst.size() > 3) report.worst.resize(3);
  return report;
}

GateReport check_against(const RunResult& baseline, const std::function<RunResult(int scenes)>& run,
                         const GateOptions& options, std::vector<int> looks) {
  const int there = static_cast<int>(baseline.rows.size());
  if (there == 0) throw Error(ExitCode::nothing_measured, "the baseline has no scenes");
  std::erase_if(looks, [&](int n) { return n >= there || n < 1; });
  looks.push_back(there);  // the last look takes all that the baseline has
  std::sort(looks.begin(), looks.end());
  GateReport report;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    report = compare_runs(baseline, run(looks[i]), options, look_alpha(looks, i, options.alpha));
    if (report.verdict != Verdict::inconclusive) return report;
  }
  report.next = "the baseline has " + std::to_string(there) + " scenes: make one with " +
                std::to_string(2 * there) + " to see more";
  return report;
}

}  // namespace scanchor
