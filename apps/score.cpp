// scanchor score: predictions, a program or methods against the truth of a data set or a suite.

#include <fmt/format.h>

#include <filesystem>

#include "apps/methods.hpp"
#include "apps/score_table.hpp"
#include "apps/suite_run.hpp"
#include "core/parallel.hpp"
#include "core/progress.hpp"
#include "eval/external.hpp"
#include "eval/predictions.hpp"
#include "results/score_plots.hpp"
#include "sensors/dataset.hpp"

namespace scanchor::apps {
namespace {

struct ScoreArguments : SuiteArguments {
  std::string truth;
  std::string predictions;
  std::string label_map;
  std::vector<std::string> methods;
  std::string out;
  std::string plots;
  ExternalOptions external;
};

/// What answers: a program, or methods by name.
std::vector<Method> chosen_methods(const ScoreArguments& arguments) {
  if (!arguments.external.command.empty()) return {external_method(arguments.external)};
  std::vector<Method> methods;
  for (const auto& name : arguments.methods) methods.push_back(load_method(arguments, name));
  return methods;
}

/// Every scan of the data set, or of one part of it, answered by a method.
MethodScore score_dataset(const Dataset& dataset, const Method& method,
                          const ScoreArguments& arguments, const Protocol& protocol) {
  MethodScore scored;
  scored.name = method.name;
  std::size_t total = 0;
  for (const auto& sequence : dataset.sequences) {
    if (arguments.split.empty() || sequence.split == arguments.split)
      total += sequence.scans.size();
  }
  Progress progress("scans", total, {.quiet = arguments.common.quiet || arguments.common.json});
  for (const auto& sequence : dataset.sequences) {
    if (!arguments.split.empty() && sequence.split != arguments.split) continue;
    const Scene scene = read_dataset_scene(sequence);
    for (std::size_t i = 0; i < sequence.scans.size() && !interrupted; ++i) {
      const Scan scan = read_dataset_scan(sequence, i);
      const std::string name = sequence.name + "/" + sequence.scans[i];
      try {
        const MethodAnswer given = method.answer(scan, name);
        scored.seconds += given.perceive_seconds + given.reason_seconds;
        ScanAnswer answer;
        answer.points = given.points;
        answer.surfaces = given.surfaces ? &*given.surfaces : nullptr;
        answer.labelling = given.labelling ? &*given.labelling : nullptr;
        answer.described = method.described;
        scored.score.add(score_scan(scan, &scene, answer, protocol));
      } catch (const std::exception& error) {
        scored.score.add(score_failed(scan, &scene, name, error.what(), protocol));
      }
      progress.add();
    }
  }
  if (interrupted)
    throw Error(ExitCode::nothing_measured, "interrupted: a part of the scans is no score");
  return scored;
}

/// Prediction files laid beside the data set. A scan without one is scored as all missed, and
/// listed.
MethodScore score_files(const Dataset& dataset, const ScoreArguments& arguments,
                        const Protocol& protocol) {
  PredictionOptions options;
  if (!arguments.label_map.empty()) options.label_map = read_label_map(arguments.label_map);
  const PredictionFolder folder = find_predictions(arguments.predictions, dataset, arguments.split);
  MethodScore scored;
  scored.name = arguments.predictions;
  auto file = folder.files.begin();
  Progress progress("scans", folder.files.size() + folder.missing.size(),
                    {.quiet = arguments.common.quiet || arguments.common.json});
  for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
    const auto& sequence = dataset.sequences[s];
    if (!arguments.split.empty() && sequence.split != arguments.split) continue;
    const bool ours = std::filesystem::exists(sequence.folder / "scene.json");
    const Scene scene = ours ? read_dataset_scene(sequence) : Scene{};
    for (std::size_t i = 0; i < sequence.scans.size(); ++i) {
      const Scan scan = read_dataset_scan(sequence, i);
      if (file != folder.files.end() && file->sequence_index == s && file->scan_index == i) {
        const PointPrediction prediction = read_prediction(file->path, scan.cloud, options);
        scored.score.add(score_scan(scan, ours ? &scene : nullptr, prediction, protocol));
        ++file;
      } else {
        scored.score.add(score_failed(scan, ours ? &scene : nullptr,
                                      sequence.name + "/" + sequence.scans[i], "no prediction",
                                      protocol));
      }
      progress.add();
    }
  }
  return scored;
}

/// A suite is made as it is scored: nothing is on disk.
MethodScore score_suite(const Suite& suite, const Method& method, const ScoreArguments& arguments) {
  RunOptions options = run_options(arguments);
  Progress progress(method.name + ", scenes", 0,
                    {.quiet = arguments.common.quiet || arguments.common.json});
  options.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  const RunResult run = run_suite(suite, method, options);
  if (run.interrupted)
    throw Error(ExitCode::nothing_measured, "interrupted: a part of the scenes is no score");
  const auto ms = [&](double seconds) {
    return 1e3 * seconds / static_cast<double>(std::max<std::size_t>(run.rows.size(), 1));
  };
  const StageTimes& t = run.times;
  return {method.name, run.pooled, t.perceive + t.reason,
          fmt::format("Times per scene [ms]: generate {:.0f}, settle {:.0f}, scan {:.0f}, perceive "
                      "{:.0f}, reason {:.0f}, score {:.0f}; at most {:.0f} MB.",
                      ms(t.generate), ms(t.settle), ms(t.scan), ms(t.perceive), ms(t.reason),
                      ms(t.score), run.peak_memory_mb)};
}

std::vector<MethodScore> score_all(ScoreArguments& arguments, const Protocol& protocol) {
  std::vector<MethodScore> scored;
  if (!arguments.truth.empty()) {
    const Dataset dataset = read_dataset(arguments.truth);
    if (!arguments.predictions.empty()) return {score_files(dataset, arguments, protocol)};
    OptionList list;
    list.add_group("perceive", arguments.perceive);
    list.add_group("reason", arguments.reason);
    apply_settings(list, arguments.common);
    for (const auto& method : chosen_methods(arguments))
      scored.push_back(score_dataset(dataset, method, arguments, protocol));
    return scored;
  }
  if (arguments.split.empty()) arguments.split = "test";
  const Suite suite = load_suite(arguments);
  for (const auto& method : chosen_methods(arguments))
    scored.push_back(score_suite(suite, method, arguments));
  return scored;
}

void check_arguments(const ScoreArguments& arguments) {
  if (arguments.truth.empty() == arguments.suite.empty())
    fail_usage("score wants either --truth or --suite");
  const int answers = (arguments.predictions.empty() ? 0 : 1) +
                      (arguments.external.command.empty() ? 0 : 1) +
                      (arguments.methods.empty() ? 0 : 1);
  if (answers != 1) fail_usage("score wants exactly one of --predictions, --pipeline and --method");
  if (arguments.truth.empty() && !arguments.predictions.empty())
    fail_usage("--predictions belong to a data set on disk",
               "make it with 'scanchor generate' and name it with --truth");
}

Json to_json(const std::vector<MethodScore>& scored, const Protocol& protocol) {
  if (scored.size() == 1) return score_to_json(scored.front().score, protocol);
  Json json;
  for (const auto& one : scored) json["methods"][one.name] = score_to_json(one.score, protocol);
  return json;
}

int run_score(ScoreArguments& arguments) {
  check_arguments(arguments);
  const ThreadLimit limit(arguments.common.threads);
  const Protocol protocol = find_protocol(arguments.protocol);
  const std::vector<MethodScore> scored = score_all(arguments, protocol);
  if (scored.front().score.scans == 0)
    throw Error(ExitCode::nothing_measured,
                fmt::format("{}: no scan of part '{}'", arguments.truth, arguments.split));
  const Common& common = arguments.common;
  const Json json = to_json(scored, protocol);
  if (!arguments.out.empty()) write_json(arguments.out, json);
  answer(common, json);
  if (scored.size() == 1) {
    print_score(common, scored.front().score, protocol);
    if (!scored.front().cost.empty()) say(common, scored.front().cost);
  } else {
    print_methods(common, scored, protocol);
  }
  if (!arguments.plots.empty()) {
    for (const auto& one : scored) {
      const std::filesystem::path folder =
          scored.size() == 1 ? std::filesystem::path(arguments.plots)
                             : std::filesystem::path(arguments.plots) / file_name_of(one.name);
      for (const auto& file : write_score_plots(folder, one.score, protocol, one.name))
        say(common, "plot: " + file.string());
    }
  }
  if (!arguments.out.empty()) say(common, "scores: " + arguments.out);
  for (const auto& one : scored) {
    if (static_cast<std::int64_t>(one.score.failed.size()) == one.score.scans)
      throw Error(ExitCode::nothing_measured,
                  fmt::format("{}: not one of {} scans got an answer; the first: {}", one.name,
                              one.score.scans, one.score.failed.front()));
  }
  return 0;
}

}  // namespace

void add_score(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand(
      "score", "Hold predictions, a program or methods against the truth of a data set or suite");
  verb->footer(
      "Examples:\n  scanchor score --truth data --predictions mine --protocol semantickitti\n"
      "  scanchor score --truth data --pipeline 'mypipeline {scan} {out}' --time-limit 30\n"
      "  scanchor score --suite office --method default --plots plots\n"
      "  scanchor score --suite quick --method default --method paper --out scores.json");
  auto arguments = std::make_shared<ScoreArguments>();
  arguments->suite.clear();
  arguments->split.clear();
  verb->add_option("--truth", arguments->truth, "A data set on disk")->type_name("DIR");
  verb->add_option("--suite", arguments->suite, "A suite by name or file: made while it is scored")
      ->type_name("SUITE");
  verb->add_option("--predictions", arguments->predictions,
                   "Predictions: SemanticKITTI .label, PLY or PCD fields, or our JSON")
      ->type_name("DIR");
  verb->add_option("--pipeline", arguments->external.command,
                   "A program to run on every scan: 'CMD {scan} {out}'")
      ->type_name("CMD");
  verb->add_option("--method", arguments->methods,
                   "default, paper, or a peer: cgal-region-growing, cgal-ransac, "
                   "pcl-region-growing (repeatable: a table)")
      ->type_name("METHOD")
      ->expected(1)
      ->take_all();
  verb->add_option("--time-limit", arguments->external.time_limit,
                   "For the program, on one scan [s]")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  verb->add_option("--scan-format", arguments->external.scan_format, "What {scan} is")
      ->check(CLI::IsMember({"pcd", "ply", "bin"}))
      ->capture_default_str();
  verb->add_option("--out-format", arguments->external.out_format, "What {out} must be")
      ->check(CLI::IsMember({"label", "ply", "pcd", "json"}))
      ->capture_default_str();
  verb->add_option("--label-map", arguments->label_map, "YAML from label numbers to class names")
      ->type_name("FILE");
  verb->add_option("--split", arguments->split,
                   "Only train, valid or test; of a suite test, if not said")
      ->check(CLI::IsMember({"train", "valid", "test"}));
  verb->add_option("--scenes", arguments->scenes, "At most so many scenes of a suite; 0: all")
      ->check(CLI::Range(0, 1000000));
  verb->add_option("--protocol", arguments->protocol, "Scoring rules: a name or a file")
      ->capture_default_str();
  verb->add_option("--ontology", arguments->ontology, "Descriptions, with --method")
      ->capture_default_str();
  verb->add_option("--out", arguments->out, "Write scores.json")->type_name("FILE");
  verb->add_option("--plots", arguments->plots,
                   "Write reliability, risk, confusion and planes as SVG and PNG")
      ->type_name("DIR");
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run_score(*arguments); });
}

}  // namespace scanchor::apps
