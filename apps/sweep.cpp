// scanchor sweep and scanchor blame: how the scores fall as something gets worse, and which stage
// costs what.

#include <fmt/format.h>

#include <filesystem>

#include "apps/suite_run.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "eval/blame.hpp"
#include "eval/gate.hpp"
#include "eval/sweep.hpp"
#include "results/score_plots.hpp"
#include "results/sweep_plots.hpp"
#include "results/table.hpp"

namespace scanchor::apps {
namespace {

struct SweepArguments : SuiteArguments {
  std::vector<std::string> vary;
  std::vector<std::string> against;
  std::string out = "scanchor-sweep";
  std::string breaking;
  std::string rank;
  std::string shard = "1/1";
  double limit = 0.5;
};

/// Of a class, or its F1 says nothing.
constexpr std::int64_t enough_things = 10;

/// Six metrics and an option fit 80 columns only without the family that all readers know.
std::string short_name(const std::string& metric) {
  return metric == "planes.f1" ? "planes f1" : metric.substr(metric.find('.') + 1);
}

void print_blame(const Common& common, const BlameResult& result,
                 const std::vector<std::string>& names) {
  std::vector<std::string> header = {"truth put in"};
  header.insert(header.end(), names.begin(), names.end());
  Table table(header);
  for (const auto& row : result.rows) {
    std::vector<TableCell> cells = {stage_word(row.perfect)};
    for (const auto& name : names)
      cells.emplace_back(fmt::format("{:.2f}", 100 * metric(row.score, result.protocol, name)));
    table.add_row(cells);
  }
  say(common, table.to_text({terminal_width(stdout), wants_color(stdout), 0}));
  header.front() = "gained by perfection of";
  Table losses(header);
  for (std::size_t stage = 0; stage < result.losses(names.front()).size(); ++stage) {
    std::vector<TableCell> cells = {result.losses(names.front())[stage].first};
    for (const auto& name : names)
      cells.emplace_back(fmt::format("{:+.2f}", 100 * result.losses(name)[stage].second));
    losses.add_row(cells);
  }
  say(common, losses.to_text({terminal_width(stdout), wants_color(stdout), 0}));
}

std::string breaking_text(const BreakingPoint& point, const std::string& option) {
  if (point.from_start) return fmt::format("below {} from the start", point.limit);
  if (!point.breaks) return fmt::format("stays above {} up to {:.4g}", point.limit, point.value);
  return fmt::format("falls below {} at {} = {:.4g} (95 %: {:.4g} .. {:.4g})", point.limit, option,
                     point.value, point.interval.low, point.interval.high);
}

Json breaking_json(const std::vector<BreakingPoint>& points, const std::string& option) {
  Json list = Json::array();
  for (const auto& point : points) {
    Json& one = list.emplace_back();
    one["metric"] = point.metric;
    one["option"] = option;
    one["limit"] = point.limit;
    one["breaks"] = point.breaks;
    one["from_start"] = point.from_start;
    one["value"] = point.value;
    one["interval"] = {point.interval.low, point.interval.high};
    one["runs"] = point.runs;
  }
  return list;
}

/// --breaking: one metric, or "classes" for F1 of every class that is often enough there.
std::vector<BreakingPoint> find_breaking_points(const SweepArguments& arguments, const Suite& suite,
                                                const Axis& axis, const PointRunner& runner) {
  std::vector<std::string> names = {arguments.breaking};
  if (arguments.breaking == "classes")
    names = class_metrics(runner(with_options(suite, {{axis.option, axis.values.front()}})),
                          enough_things);
  return breaking_points(suite, axis, names, arguments.limit, runner);
}

Json ranking_json(const std::vector<EffectCost>& costs) {
  Json list = Json::array();
  for (const auto& cost : costs) {
    Json& one = list.emplace_back();
    one["option"] = cost.option;
    one["from"] = cost.from;
    one["to"] = cost.to;
    one["before"] = cost.before;
    one["after"] = cost.after;
    one["change"] = {cost.change.low, cost.change.high};
  }
  return list;
}

/// --rank: each option from its first to its last value while all else stays.
int run_ranking(const SweepArguments& arguments, const Suite& suite, const std::vector<Axis>& axes,
                const SweepOptions& options, const Method& method) {
  Progress progress("runs", 2 * axes.size(),
                    {.quiet = arguments.common.quiet || arguments.common.json});
  const PointRunner kept = kept_runs(method, options);
  const auto costs = rank_effects(suite, axes, arguments.rank, [&](const Suite& point) {
    RunResult run = kept(point);
    if (run.interrupted)
      throw Error(ExitCode::nothing_measured, "interrupted; the same command goes on from there");
    progress.add();
    return run;
  });
  const std::filesystem::path out = arguments.out;
  const Json json{{"metric", arguments.rank}, {"effects", ranking_json(costs)}};
  write_json(out / "ranking.json", json);
  answer(arguments.common, json);
  Table table({"effect", "from", "to", arguments.rank, "then", "change [points]", "95 %"});
  for (const auto& cost : costs) {
    table.add_row(
        {cost.option, fmt::format("{:.4g}", cost.from), fmt::format("{:.4g}", cost.to),
         fraction_text(cost.before), fraction_text(cost.after),
         fmt::format("{:+.2f}", 100 * (cost.after - cost.before)),
         fmt::format("{:+.2f} .. {:+.2f}", 100 * cost.change.low, 100 * cost.change.high)});
  }
  say(arguments.common, table.to_text({terminal_width(stdout), wants_color(stdout), 0}));
  const auto plot = write_plot(out, "ranking", ranking_plot(costs, arguments.rank));
  say(arguments.common, fmt::format("ranking: {}/ranking.json, {}", arguments.out, plot.string()));
  return 0;
}

void print_sweep(const SweepArguments& arguments, const SweepResult& result,
                 const std::vector<std::string>& metrics) {
  std::vector<std::string> header;
  for (const auto& axis : result.axes) header.push_back(axis.option);
  for (const auto& metric : metrics) header.push_back(short_name(metric));
  Table table(header);
  for (const auto& point : result.points) {
    std::vector<TableCell> row;
    for (const double value : point.values) row.emplace_back(fmt::format("{:.4g}", value));
    for (const auto& metric_name : metrics)
      row.emplace_back(fraction_text(value_of(point.run, metric_name)));
    table.add_row(row);
  }
  say(arguments.common, table.to_text({terminal_width(stdout), wants_color(stdout), 0}));
}

/// One sweep a method, over the same scans.
std::vector<SweepResult> sweep_methods(const SweepArguments& arguments, const Suite& suite,
                                       const std::vector<Axis>& axes, const SweepOptions& options) {
  std::vector<std::string> names = {arguments.method};
  names.insert(names.end(), arguments.against.begin(), arguments.against.end());
  std::vector<Method> methods;
  for (const auto& name : names) methods.push_back(load_method(arguments, name));
  std::vector<SweepResult> results;
  for (const auto& method : methods) {
    Progress progress(method.name + ", points", 0,
                      {.quiet = arguments.common.quiet || arguments.common.json});
    SweepOptions own = options;
    own.progress = [&](std::size_t done, std::size_t total, const SweepPoint&) {
      progress.update(done, total);
    };
    results.push_back(sweep(suite, axes, method, own));
    if (results.back().interrupted)
      throw Error(ExitCode::nothing_measured, "interrupted; the same command goes on from there");
  }
  return results;
}

int run_sweep(SweepArguments& arguments) {
  const Suite suite = load_suite(arguments);
  std::vector<Axis> axes;
  for (const auto& text : arguments.vary) axes.push_back(parse_axis(text));
  // What was mistyped is said before hours are spent.
  for (const auto& axis : axes) with_options(suite, {{axis.option, axis.values.front()}});
  for (const auto& metric : {arguments.rank, arguments.breaking}) {
    if (!metric.empty() && metric != "classes")
      paired_counts(metric, {}, {}, find_protocol(arguments.protocol));
  }
  const std::filesystem::path out = arguments.out;
  make_folder(out);
  SweepOptions options;
  options.run = run_options(arguments);
  options.points = parse_shard(arguments.shard);
  options.folder = out / "points";
  options.stamp = program_stamp() + options_stamp(arguments);
  make_folder(options.folder);
  if (!arguments.rank.empty())
    return run_ranking(arguments, suite, axes, options, load_method(arguments));

  const std::vector<SweepResult> results = sweep_methods(arguments, suite, axes, options);
  if (results.front().elsewhere > 0) {
    answer(arguments.common, Json{{"points", results.front().points.size()},
                                  {"elsewhere", results.front().elsewhere}});
    say(arguments.common,
        fmt::format("{} points done, {} belong to other shards; with their files in {}/points, run "
                    "once more without --shard to finish.",
                    results.front().points.size(), results.front().elsewhere, arguments.out));
    return 0;
  }
  Json json = sweeps_to_json(results);
  std::vector<BreakingPoint> breaking;
  if (!arguments.breaking.empty()) {
    breaking = find_breaking_points(arguments, suite, axes.front(),
                                    kept_runs(load_method(arguments), options));
    json["breaking"] = breaking_json(breaking, axes.front().option);
  }
  write_json(out / "sweep.json", json);
  write_file(out / "sweep.csv", sweep_to_csv(results.front()));
  for (std::size_t m = 1; m < results.size(); ++m)
    write_file(out / ("sweep-" + arguments.against[m - 1] + ".csv"), sweep_to_csv(results[m]));
  answer(arguments.common, json);
  for (const auto& result : results) {
    if (results.size() > 1) say(arguments.common, result.method + ":");
    print_sweep(arguments, result, options.metrics);
  }
  if (arguments.breaking == "classes" && breaking.empty())
    say(arguments.common, fmt::format("no class has {} things in these scenes: nothing to say of "
                                      "where one breaks",
                                      enough_things));
  for (const auto& point : breaking)
    say(arguments.common, point.metric + ": " + breaking_text(point, axes.front().option));
  say(arguments.common, fmt::format("curves: {0}/sweep.json, {0}/sweep.csv", arguments.out));
  for (const auto& file : write_sweep_plots(out, results, {"objects.f1", "planes.f1"}))
    say(arguments.common, "plot: " + file.string());
  return 0;
}

int run_blame(SuiteArguments& arguments) {
  const Suite suite = load_suite(arguments);
  RunOptions options = run_options(arguments);
  Progress progress("scenes", 0, {.quiet = arguments.common.quiet || arguments.common.json});
  options.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  if (arguments.method != "default" && arguments.method != "paper")
    fail_usage("blame looks into the stages of our own methods", "known are: default, paper");
  arguments.perceive.method = arguments.reason.mode = arguments.method;
  const BlameResult result = blame(suite, arguments.perceive, find_ontology(arguments.ontology),
                                   arguments.reason, options);
  const std::vector<std::string> names = {"objects.f1", "panoptic.pq", "points.miou"};
  Json json;
  for (const auto& name : names) {
    for (const auto& [stage, loss] : result.losses(name)) json[name][stage] = loss;
  }
  answer(arguments.common, json);
  print_blame(arguments.common, result, names);
  return 0;
}

}  // namespace

void add_sweep(CLI::App& root, ExitCodeSlot& code) {
  auto* verb =
      root.add_subcommand("sweep", "Scores over the values of an option: noise until it breaks");
  verb->footer(
      "Examples:\n  scanchor sweep quick --vary lidar.range_sigma=0..0.05 --breaking objects.f1 "
      "--out noise\n"
      "  scanchor sweep quick --vary lidar.range_sigma=0..0.04/5 --against paper --out both\n"
      "  scanchor sweep quick --vary lidar.range_sigma=0..0.04/5 --vary lidar.lines=50,100,200 "
      "--out map\n"
      "  scanchor sweep quick --vary lidar.range_sigma=0,0.03 --vary lidar.loss=0,0.3 --rank "
      "objects.f1");
  auto arguments = std::make_shared<SweepArguments>();
  add_suite_arguments(*verb, *arguments);
  verb->add_option("--vary", arguments->vary,
                   "option=a..b, option=a..b/n or option=a,b,c (repeatable: all combinations)")
      ->required()
      ->expected(1)
      ->take_all();
  verb->add_option("--against", arguments->against,
                   "Another method over the same scans (repeatable)")
      ->type_name("METHOD")
      ->expected(1)
      ->take_all();
  verb->add_option("--rank", arguments->rank,
                   "Instead of all combinations: each option alone, from its first to its last "
                   "value, ranked by what it costs in this metric")
      ->type_name("METRIC");
  verb->add_option("--shard", arguments->shard, "Only part i of n of the points")
      ->type_name("I/N")
      ->capture_default_str();
  verb->add_option("--breaking", arguments->breaking,
                   "Also the value of the first option at which this metric falls below --limit; "
                   "\"classes\": F1 of every class")
      ->type_name("METRIC");
  verb->add_option("--limit", arguments->limit, "For --breaking")->capture_default_str();
  verb->add_option("--out", arguments->out, "Folder; finished points are kept and found again")
      ->type_name("DIR")
      ->capture_default_str();
  verb->callback([arguments, &code] { code = run_sweep(*arguments); });
}

void add_blame(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand(
      "blame", "Which stage loses how much: the truth put in for one stage after another");
  verb->footer("Example:\n  scanchor blame quick --scenes 10");
  auto arguments = std::make_shared<SuiteArguments>();
  add_suite_arguments(*verb, *arguments);
  verb->callback([arguments, &code] { code = run_blame(*arguments); });
}

}  // namespace scanchor::apps
