// scanchor score: anybody's predictions, or anybody's program, against the truth of a data set.

#include <fmt/format.h>

#include <filesystem>

#include "apps/command.hpp"
#include "apps/score_table.hpp"
#include "core/parallel.hpp"
#include "core/progress.hpp"
#include "eval/external.hpp"
#include "eval/predictions.hpp"
#include "eval/run.hpp"
#include "sensors/dataset.hpp"

namespace scanchor::apps {
namespace {

struct Arguments {
  Common common;
  std::string truth;
  std::string predictions;
  std::string split;
  std::string protocol = "scanchor-1";
  std::string label_map;
  std::string ontology = "office";
  std::string method;
  std::string out;
  ExternalOptions external;
};

/// The method that answers: a program, or one of ours by name.
Method chosen_method(Arguments& arguments) {
  if (!arguments.external.command.empty()) return external_method(arguments.external);
  PerceiveOptions perceive;
  ReasonOptions reason;
  perceive.method = arguments.method;
  reason.mode = arguments.method;
  OptionList list;
  list.add_group("perceive", perceive);
  list.add_group("reason", reason);
  apply_settings(list, arguments.common);
  return own_method(perceive, find_ontology(arguments.ontology), reason);
}

struct Scored {
  Score score;
  std::size_t missing = 0;
};

/// Every scan of the data set, or of one part of it, answered by a method.
Scored score_method(const Dataset& dataset, const Method& method, const Arguments& arguments,
                    const Protocol& protocol) {
  Scored scored;
  Progress progress("scans", 0, {.quiet = arguments.common.quiet || arguments.common.json});
  for (const auto& sequence : dataset.sequences) {
    if (!arguments.split.empty() && sequence.split != arguments.split) continue;
    const Scene scene = read_dataset_scene(sequence);
    for (std::size_t i = 0; i < sequence.scans.size() && !interrupted; ++i) {
      const Scan scan = read_dataset_scan(sequence, i);
      const std::string name = sequence.name + "/" + sequence.scans[i];
      try {
        const MethodAnswer given = method.answer(scan, name);
        Answer answer;
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
  return scored;
}

/// Prediction files laid beside the data set. A scan without one is scored as all missed, and
/// listed.
Scored score_files(const Dataset& dataset, const Arguments& arguments, const Protocol& protocol) {
  PredictionOptions options;
  if (!arguments.label_map.empty()) options.label_map = read_label_map(arguments.label_map);
  const PredictionFolder folder = find_predictions(arguments.predictions, dataset, arguments.split);
  Scored scored;
  scored.missing = folder.missing.size();
  auto file = folder.files.begin();
  for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
    const auto& sequence = dataset.sequences[s];
    if (!arguments.split.empty() && sequence.split != arguments.split) continue;
    const bool ours = std::filesystem::exists(sequence.folder / "scene.json");
    const Scene scene = ours ? read_dataset_scene(sequence) : Scene{};
    for (std::size_t i = 0; i < sequence.scans.size(); ++i) {
      const Scan scan = read_dataset_scan(sequence, i);
      if (file != folder.files.end() && file->sequence_index == s && file->scan_index == i) {
        const PointPrediction prediction = read_prediction(file->path, scan.cloud.size(), options);
        scored.score.add(score_scan(scan, ours ? &scene : nullptr, prediction, protocol));
        ++file;
      } else {
        scored.score.add(score_failed(scan, ours ? &scene : nullptr,
                                      sequence.name + "/" + sequence.scans[i], "no prediction",
                                      protocol));
      }
    }
  }
  return scored;
}

int run(Arguments& arguments) {
  const ThreadLimit limit(arguments.common.threads);
  const int answers = (arguments.predictions.empty() ? 0 : 1) +
                      (arguments.external.command.empty() ? 0 : 1) +
                      (arguments.method.empty() ? 0 : 1);
  if (answers != 1) fail_usage("score wants exactly one of --predictions, --pipeline and --method");
  const Protocol protocol = find_protocol(arguments.protocol);
  const Dataset dataset = read_dataset(arguments.truth);
  const Scored scored = arguments.predictions.empty()
                            ? score_method(dataset, chosen_method(arguments), arguments, protocol)
                            : score_files(dataset, arguments, protocol);
  if (scored.score.scans == 0)
    throw Error(ExitCode::nothing_measured,
                fmt::format("{}: no scan of part '{}'", arguments.truth, arguments.split));

  const Json json = score_to_json(scored.score, protocol);
  if (!arguments.out.empty()) write_json(arguments.out, json);
  answer(arguments.common, json);
  print_score(arguments.common, scored.score, protocol);
  if (!arguments.out.empty()) say(arguments.common, "scores: " + arguments.out);
  return 0;
}

}  // namespace

void add_score(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand(
      "score", "Hold predictions, a program or a method against the truth of a data set");
  verb->footer(
      "Examples:\n  scanchor score --truth data --predictions mine --protocol semantickitti\n"
      "  scanchor score --truth data --pipeline 'mypipeline {scan} {out}' --time-limit 30\n"
      "  scanchor score --truth data --method paper --split test --out scores.json");
  auto arguments = std::make_shared<Arguments>();
  verb->add_option("--truth", arguments->truth, "The data set")->required()->type_name("DIR");
  verb->add_option("--predictions", arguments->predictions,
                   "Predictions: SemanticKITTI .label, PLY or PCD fields, or our JSON")
      ->type_name("DIR");
  verb->add_option("--pipeline", arguments->external.command,
                   "A program to run on every scan: 'CMD {scan} {out}'")
      ->type_name("CMD");
  verb->add_option("--method", arguments->method, "One of ours: default or paper")
      ->check(CLI::IsMember({"default", "paper"}));
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
  verb->add_option("--split", arguments->split, "Only train, valid or test");
  verb->add_option("--protocol", arguments->protocol, "Scoring rules: a name or a file")
      ->capture_default_str();
  verb->add_option("--ontology", arguments->ontology, "Descriptions, with --method")
      ->capture_default_str();
  verb->add_option("--out", arguments->out, "Write scores.json")->type_name("FILE");
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run(*arguments); });
}

}  // namespace scanchor::apps
