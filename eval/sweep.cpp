#include "eval/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "core/text.hpp"
#include "eval/gate.hpp"

namespace scanchor {
namespace {

double number_of(std::string_view text, const std::string& whole) {
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() ||
      !std::isfinite(value)) {
    fail_usage("'" + whole + "': '" + std::string(text) + "' is not a number",
               "write option=low..high, option=low..high/count or option=a,b,c");
  }
  return value;
}

std::vector<const Score*> scores_of(const RunResult& run) {
  std::vector<const Score*> scores;
  for (const auto& row : run.rows) scores.push_back(&row.score);
  return scores;
}

Interval interval_of(const RunResult& run, const std::string& metric, int replicates) {
  const auto scores = scores_of(run);
  return bca_interval_of_value(paired_counts(metric, scores, scores, run.protocol), 0.95,
                               replicates, 1);
}

// Where a curve through (x, y) falls below the limit for the first time; the end if it never does.
double crossing(const std::map<double, double>& curve, double limit) {
  const auto first = curve.begin();
  if (first->second < limit) return first->first;
  auto before = first;
  for (auto at = std::next(first); at != curve.end(); before = at++) {
    if (at->second >= limit) continue;
    const double share = (before->second - limit) / (before->second - at->second);
    return before->first + share * (at->first - before->first);
  }
  return before->first;
}

}  // namespace

double value_of(const RunResult& run, const std::string& metric) {
  const auto scores = scores_of(run);
  const auto counts = paired_counts(metric, scores, scores, run.protocol);
  return pooled_value(counts, counts.after);
}

Axis parse_axis(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    fail_usage("'" + text + "' is no axis", "write option=low..high");
  Axis axis;
  axis.option = text.substr(0, equals);
  const std::string_view rest = std::string_view(text).substr(equals + 1);
  const auto dots = rest.find("..");
  if (dots == std::string_view::npos) {
    for (std::size_t start = 0; start <= rest.size();) {
      const auto comma = std::min(rest.find(',', start), rest.size());
      axis.values.push_back(number_of(rest.substr(start, comma - start), text));
      start = comma + 1;
    }
  } else {
    auto last = rest.substr(dots + 2);
    int count = 6;
    if (const auto slash = last.find('/'); slash != std::string_view::npos) {
      const double wanted = number_of(last.substr(slash + 1), text);
      if (wanted < 2 || wanted > 1000 || wanted != std::floor(wanted))
        fail_usage("'" + text + "': the count must be a whole number from 2 to 1000");
      count = static_cast<int>(wanted);
      last = last.substr(0, slash);
    }
    const double low = number_of(rest.substr(0, dots), text), high = number_of(last, text);
    for (int i = 0; i < count; ++i)
      axis.values.push_back(i + 1 == count ? high : low + (high - low) * i / (count - 1));
  }
  for (std::size_t i = 1; i < axis.values.size(); ++i) {
    if (!(axis.values[i] > axis.values[i - 1])) fail_usage("'" + text + "': the values must rise");
  }
  return axis;
}

Suite with_options(const Suite& suite, const std::vector<std::pair<std::string, double>>& values) {
  Suite changed = suite;
  OptionList list;
  changed.describe(list);
  for (const auto& [name, value] : values) {
    list.set(name, shortest_text(value));
    // An option that the suite draws from scene to scene is now the same in all.
    std::erase_if(changed.vary, [&](const Variation& v) { return v.option == name; });
  }
  return changed;
}

SweepResult sweep(const Suite& suite, const std::vector<Axis>& axes, const SweepOptions& options,
                  const PointRunner& runner) {
  SweepResult result;
  result.axes = axes;
  std::size_t total = 1;
  for (const auto& axis : axes) total *= axis.values.size();
  for (std::size_t n = 0; n < total; ++n) {
    if (options.run.stop && options.run.stop->load()) {
      result.interrupted = true;
      break;
    }
    if (!options.points.has(static_cast<int>(n))) {
      ++result.elsewhere;
      continue;
    }
    SweepPoint point;
    std::size_t rest = n;
    std::vector<std::pair<std::string, double>> values(axes.size());
    for (std::size_t a = axes.size(); a-- > 0;) {
      values[a] = {axes[a].option, axes[a].values[rest % axes[a].values.size()]};
      rest /= axes[a].values.size();
    }
    for (const auto& value : values) point.values.push_back(value.second);
    point.run = runner(with_options(suite, values));
    if (point.run.interrupted) {
      result.interrupted = true;
      break;
    }
    for (const auto& metric : options.metrics)
      point.intervals.emplace_back(metric, interval_of(point.run, metric, options.replicates));
    if (options.progress) options.progress(n + 1, total, point);
    result.points.push_back(std::move(point));
  }
  return result;
}

BreakingPoint breaking_point(const Suite& suite, const Axis& range, const std::string& metric,
                             double limit, const PointRunner& runner, double resolution,
                             int replicates) {
  BreakingPoint found;
  found.metric = metric;
  found.limit = limit;
  std::map<double, double> value, lower, upper;
  const auto evaluate = [&](double x) {
    const RunResult run = runner(with_options(suite, {{range.option, x}}));
    const Interval interval = interval_of(run, metric, replicates);
    value[x] = value_of(run, metric);
    lower[x] = std::min(interval.low, value[x]);
    upper[x] = std::max(interval.high, value[x]);
    ++found.runs;
    return value[x];
  };
  double low = range.values.front(), high = range.values.back();
  const double width = (high - low) * resolution;
  found.from_start = evaluate(low) < limit;
  found.breaks = found.from_start || evaluate(high) < limit;
  if (!found.from_start && found.breaks) {
    while (high - low > width) {
      const double middle = 0.5 * (low + high);
      (evaluate(middle) < limit ? high : low) = middle;
    }
  }
  found.value = crossing(value, limit);
  found.interval = {crossing(lower, limit), crossing(upper, limit)};
  return found;
}

std::vector<BreakingPoint> breaking_points(const Suite& suite, const Axis& range,
                                           const std::vector<std::string>& metrics, double limit,
                                           const PointRunner& runner, double resolution,
                                           int replicates) {
  // Bisections of the same range ask for the same values again and again.
  std::map<std::string, RunResult> known;
  const PointRunner shared = [&](const Suite& point) -> RunResult {
    const std::string key = data_stamp(point, "");
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    return known.emplace(key, runner(point)).first->second;
  };
  std::vector<BreakingPoint> points;
  for (const auto& metric : metrics)
    points.push_back(breaking_point(suite, range, metric, limit, shared, resolution, replicates));
  return points;
}

std::vector<std::string> class_metrics(const RunResult& run, std::int64_t least) {
  std::vector<std::string> names;
  for (const auto& info : class_list()) {
    const auto c = static_cast<std::size_t>(info.id);
    if (c < run.pooled.objects.classes.size() && run.pooled.objects.classes[c].truths >= least)
      names.push_back("objects.f1." + std::string(info.name));
  }
  return names;
}

std::vector<EffectCost> rank_effects(const Suite& suite, const std::vector<Axis>& axes,
                                     const std::string& metric, const PointRunner& runner,
                                     int replicates) {
  std::vector<EffectCost> costs;
  for (const auto& axis : axes) {
    EffectCost cost;
    cost.option = axis.option;
    cost.from = axis.values.front();
    cost.to = axis.values.back();
    const RunResult before = runner(with_options(suite, {{axis.option, cost.from}}));
    const RunResult after = runner(with_options(suite, {{axis.option, cost.to}}));
    const auto counts = paired_counts(metric, scores_of(before), scores_of(after), after.protocol);
    cost.before = pooled_value(counts, counts.before);
    cost.after = pooled_value(counts, counts.after);
    cost.change = bca_interval(counts, 0.95, replicates, 1);
    costs.push_back(cost);
  }
  std::stable_sort(costs.begin(), costs.end(), [](const EffectCost& a, const EffectCost& b) {
    return a.after - a.before < b.after - b.before;
  });
  return costs;
}

}  // namespace scanchor
