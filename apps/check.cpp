// scanchor check and scanchor baseline: the regression gate, and the stored run that it compares
// with.

#include <fmt/format.h>

#include <ctime>
#include <filesystem>

#include "apps/check_pictures.hpp"
#include "apps/suite_run.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "eval/baseline.hpp"
#include "eval/gate.hpp"

namespace scanchor::apps {
namespace {

struct CheckArguments : SuiteArguments {
  std::string baseline;
  std::string junit;
  std::string markdown;
  std::string bencher;
  std::string pictures;
  std::string reason_text;
  bool draw = false;
  GateOptions gate;
};

RunResult measured(const Suite& suite, const CheckArguments& arguments, int scenes) {
  RunOptions options = run_options(arguments);
  options.scenes = scenes;
  Progress progress("scenes", 0, {.quiet = arguments.common.quiet || arguments.common.json});
  options.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  RunResult result = run_suite(suite, load_method(arguments), options);
  if (result.interrupted)
    throw Error(ExitCode::nothing_measured, "interrupted: nothing was compared");
  return result;
}

/// Where the pictures of a baseline are: "quick.json" has "quick.pictures/".
std::filesystem::path pictures_beside(const std::string& baseline) {
  return std::filesystem::path(baseline).replace_extension(".pictures");
}

int check(CheckArguments& arguments) {
  const Suite suite = load_suite(arguments);
  const Baseline baseline = read_baseline(arguments.baseline);
  const int available = static_cast<int>(baseline.run.rows.size());
  const GateReport report = check_against(
      baseline.run,
      [&](int scenes) {
        return measured(suite, arguments,
                        arguments.scenes > 0 ? std::min(scenes, arguments.scenes)
                                             : std::min(scenes, available));
      },
      arguments.gate);
  if (!arguments.junit.empty()) write_file(arguments.junit, gate_to_junit(report));
  if (!arguments.markdown.empty()) write_file(arguments.markdown, gate_to_markdown(report));
  if (!arguments.bencher.empty()) write_json(arguments.bencher, gate_to_bencher(report));
  answer(arguments.common, gate_to_json(report));
  say(arguments.common, gate_to_text(report));
  if (!arguments.pictures.empty()) {
    for (const auto& file :
         draw_worst_scenes(arguments.pictures, pictures_beside(arguments.baseline), suite,
                           load_method(arguments), report))
      say(arguments.common, "picture: " + file.string());
  }
  return static_cast<int>(report.exit_code(arguments.gate.strict));
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16] = {};
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

int update(CheckArguments& arguments) {
  const Suite suite = load_suite(arguments);
  RunResult run = measured(suite, arguments, arguments.scenes);
  Baseline next;
  std::vector<std::string> changes;
  if (std::filesystem::exists(arguments.baseline)) {
    const Baseline old = read_baseline(arguments.baseline);
    changes = describe_change(old.run, run);
    next = update_baseline(old, std::move(run), arguments.reason_text, today());
  } else {
    next.run = std::move(run);
    next.history.push_back(
        {today(), arguments.reason_text.empty() ? "first baseline" : arguments.reason_text, {}});
  }
  write_baseline(arguments.baseline, next);
  if (arguments.draw)
    draw_baseline_pictures(pictures_beside(arguments.baseline), suite, load_method(arguments),
                           next.run);
  answer(arguments.common, Json{{"baseline", arguments.baseline}, {"changes", changes}});
  for (const auto& change : changes) say(arguments.common, "  " + change);
  say(arguments.common, fmt::format("{}: {} scenes", arguments.baseline, next.run.rows.size()));
  return 0;
}

}  // namespace

void add_check(CLI::App& root, ExitCodeSlot& code) {
  auto* verb =
      root.add_subcommand("check", "Fail when a run over a suite is worse than the baseline");
  verb->footer(
      "Example:\n  scanchor check quick --baseline results/baselines/quick.json --junit gate.xml\n"
      "Exit codes: 0 not worse, 1 worse, 3 other data or protocol, 4 nothing measured, 5 "
      "inconclusive with --strict.");
  auto arguments = std::make_shared<CheckArguments>();
  add_suite_arguments(*verb, *arguments);
  verb->add_option("--baseline", arguments->baseline, "The stored run")
      ->required()
      ->type_name("FILE");
  verb->add_option("--margin", arguments->gate.margin,
                   "A drop up to that is accepted, 0.01: one point")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb->add_flag("--strict", arguments->gate.strict, "Inconclusive is exit code 5");
  verb->add_option("--junit", arguments->junit, "Write JUnit XML")->type_name("FILE");
  verb->add_option("--markdown", arguments->markdown, "Write a summary for a pull request")
      ->type_name("FILE");
  verb->add_option("--bencher", arguments->bencher, "Write Bencher's metric format")
      ->type_name("FILE");
  verb->add_option("--pictures", arguments->pictures,
                   "Draw the three scenes that lost most, beside the baseline's pictures")
      ->type_name("DIR");
  verb->add_option("--correction", arguments->gate.correction, "Of p-values for several metrics")
      ->check(CLI::IsMember({"westfall-young", "holm"}))
      ->capture_default_str();
  verb->callback([arguments, &code] { code = check(*arguments); });
}

void add_baseline(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("baseline",
                                   "Measure a suite and keep the result as the baseline of check");
  verb->footer(
      "Example:\n  scanchor baseline quick --baseline results/baselines/quick.json --reason "
      "\"first run of the new matcher\"");
  auto arguments = std::make_shared<CheckArguments>();
  add_suite_arguments(*verb, *arguments);
  verb->add_option("--baseline", arguments->baseline, "The stored run; made if absent")
      ->required()
      ->type_name("FILE");
  verb->add_option("--reason", arguments->reason_text,
                   "Why the baseline changes, at least three words");
  verb->add_flag("--pictures", arguments->draw,
                 "Also draw each scene, into FILE.pictures: what check shows as before");
  verb->callback([arguments, &code] { code = update(*arguments); });
}

}  // namespace scanchor::apps
