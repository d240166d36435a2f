// scanchor sweep and scanchor blame: how the scores fall as something gets worse, and which stage
// costs what.

#include <fmt/format.h>

#include <filesystem>

#include "apps/suite_run.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "eval/blame.hpp"
#include "eval/sweep.hpp"
#include "results/table.hpp"

namespace scanchor::apps {
namespace {

struct Arguments : SuiteArguments {
  std::vector<std::string> vary;
  std::string out = "scanchor-sweep";
  std::string breaking;
  double limit = 0.5;
};

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

void print_breaking_point(const Arguments& arguments, const Suite& suite, const Method& method,
                          const SweepOptions& options) {
  const Axis axis = parse_axis(arguments.vary.front());
  const BreakingPoint point =
      breaking_point(suite, axis, arguments.breaking, arguments.limit,
                     [&](const Suite& s) { return run_suite(s, method, options.run); });
  const std::string where =
      point.from_start ? fmt::format("below {} from the start", point.limit)
      : point.breaks
          ? fmt::format("falls below {} at {} = {:.4g} (95 %: {:.4g} .. {:.4g})", point.limit,
                        axis.option, point.value, point.interval.low, point.interval.high)
          : fmt::format("stays above {} up to {:.4g}", point.limit, point.value);
  say(arguments.common, fmt::format("{}: {}", point.metric, where));
}

int run_sweep(Arguments& arguments) {
  const Suite suite = load_suite(arguments);
  std::vector<Axis> axes;
  for (const auto& text : arguments.vary) axes.push_back(parse_axis(text));
  const std::filesystem::path out = arguments.out;
  make_folder(out);
  SweepOptions options;
  options.run = run_options(arguments);
  options.folder = out / "points";
  make_folder(options.folder);
  const Method method = load_method(arguments);
  SweepResult result;
  {
    Progress progress("points", 0, {.quiet = arguments.common.quiet || arguments.common.json});
    options.progress = [&](std::size_t done, std::size_t, const SweepPoint&) {
      progress.update(done);
    };
    result = sweep(suite, axes, method, options);
  }
  if (result.interrupted)
    throw Error(ExitCode::nothing_measured, "interrupted; the same command goes on from there");
  const Json json = sweep_to_json(result);
  write_json(out / "sweep.json", json);
  write_file(out / "sweep.csv", sweep_to_csv(result));
  answer(arguments.common, json);

  std::vector<std::string> header;
  for (const auto& axis : axes) header.push_back(axis.option);
  for (const auto& metric : options.metrics) header.push_back(short_name(metric));
  Table table(header);
  for (const auto& point : result.points) {
    std::vector<TableCell> row;
    for (const double value : point.values) row.emplace_back(fmt::format("{:.4g}", value));
    for (const auto& metric_name : options.metrics)
      row.emplace_back(fraction_text(value_of(point.run, metric_name)));
    table.add_row(row);
  }
  say(arguments.common, table.to_text({terminal_width(stdout), wants_color(stdout), 0}));
  if (!arguments.breaking.empty() && !arguments.common.json)
    print_breaking_point(arguments, suite, method, options);
  say(arguments.common, fmt::format("curves: {0}/sweep.json, {0}/sweep.csv", arguments.out));
  return 0;
}

int run_blame(SuiteArguments& arguments) {
  const Suite suite = load_suite(arguments);
  const BlameResult result = blame(suite, arguments.perceive, find_ontology(arguments.ontology),
                                   arguments.reason, run_options(arguments));
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
      "Example:\n  scanchor sweep quick --vary lidar.range_sigma=0..0.05 --breaking objects.f1 "
      "--out noise");
  auto arguments = std::make_shared<Arguments>();
  add_suite_arguments(*verb, *arguments);
  verb->add_option("--vary", arguments->vary,
                   "option=a..b, option=a..b/n or option=a,b,c (repeatable: all combinations)")
      ->required()
      ->expected(1)
      ->take_all();
  verb->add_option("--breaking", arguments->breaking,
                   "Also the value at which this metric falls below --limit");
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
