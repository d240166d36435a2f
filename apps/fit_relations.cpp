// scanchor fit-relations: finds the constants of the relations' likelihoods on training rooms.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "apps/command.hpp"
#include "apps/training_rooms.hpp"
#include "core/data_folder.hpp"
#include "eval/relation_training.hpp"
#include "eval/run.hpp"
#include "sensors/suite.hpp"

namespace scanchor::apps {
namespace {

struct Arguments {
  Common common;
  std::string suite = "relations-training";
  std::string out = "relations.json";
  std::vector<double> noise = {0.0, 0.5, 1.0, 2.0, 4.0};
  int scenes = 0;
  PerceiveOptions perceive;
  ReasonOptions reason;
};

/// All training rooms at each noise.
std::vector<RelationScene> look_at(const Suite& suite, const Arguments& arguments) {
  RunOptions part;
  part.split = "train";
  part.scenes = arguments.scenes;
  std::vector<SceneTask> tasks;
  for (const double noise : arguments.noise) {
    Suite one = suite;
    one.lidar.range_sigma = 0.01 * noise;
    for (auto& task : tasks_of(one, part)) tasks.push_back(std::move(task));
  }
  return look_at_scans(
      tasks, suite, arguments.common, "scans", [&](const MadeScene& room, const Scan& scan) {
        return relation_scene(scan, room.scene, Protocol{}, arguments.perceive, arguments.reason);
      });
}

int run_fit_relations(Arguments& arguments) {
  const ThreadLimit limit(arguments.common.threads);
  OptionList list;
  list.add_group("perceive", arguments.perceive);
  list.add_group("reason", arguments.reason);
  apply_settings(list, arguments.common);
  const Suite suite = read_suite(find_data_file("suites", arguments.suite, ".yaml"));
  const auto scenes = look_at(suite, arguments);
  std::size_t pairs = 0, planes = 0;
  for (const auto& scene : scenes) {
    pairs += scene.samples.size();
    planes += scene.normals.size();
  }
  const RelationFit fit = fit_relations(scenes, RelationModel{});
  RelationFile file;
  file.fitted_on =
      fmt::format("{}: {} scans of the training part at {} cm of noise, {} planes, {} pairs",
                  suite.name, scenes.size(), fmt::join(arguments.noise, ", "), planes, pairs);
  file.model = fit.model;
  write_relation_file(arguments.out, file);

  Json json = relation_file_to_json(file);
  for (const auto& part : fit.parts) {
    json["parts"].push_back({{"part", part.name},
                             {"samples", part.samples},
                             {"before", part.before},
                             {"after", part.after}});
  }
  json["file"] = arguments.out;
  answer(arguments.common, json);
  say(arguments.common, "Fitted on " + file.fitted_on + ".");
  say(arguments.common, fmt::format("{:<10} {:>8}  loss of a sample", "part", "samples"));
  for (const auto& part : fit.parts) {
    say(arguments.common, fmt::format("{:<10} {:>8}  {:.4f} -> {:.4f}", part.name, part.samples,
                                      part.before, part.after));
  }
  say(arguments.common,
      fmt::format("{} constants: {}", relation_constants().size(), arguments.out));
  return 0;
}

}  // namespace

void add_fit_relations(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand(
      "fit-relations", "Find the constants of relations on training rooms, by maximum likelihood");
  verb->footer(
      "Example:\n  scanchor fit-relations relations-training --out ontologies/relations.json\n"
      "Only rooms of the suite's training part are looked at, each at every noise.");
  auto arguments = std::make_shared<Arguments>();
  verb->add_option("suite", arguments->suite, "A suite by name or file")
      ->type_name("SUITE")
      ->capture_default_str();
  verb->add_option("--out", arguments->out, "File to write")
      ->type_name("FILE")
      ->capture_default_str();
  verb->add_option("--noise", arguments->noise, "Range noises [cm] at which each room is scanned")
      ->delimiter(',')
      ->check(CLI::Range(0.0, 20.0))
      ->capture_default_str();
  verb->add_option("--scenes", arguments->scenes, "At most so many training rooms; 0: all")
      ->check(CLI::Range(0, 1000000));
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run_fit_relations(*arguments); });
}

}  // namespace scanchor::apps
