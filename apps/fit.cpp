// scanchor fit: counts on training rooms how often each clause of a class file holds, and keeps it
// beside the file.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "apps/command.hpp"
#include "apps/training_rooms.hpp"
#include "core/data_folder.hpp"
#include "eval/run.hpp"
#include "reasoning/fit.hpp"
#include "reasoning/reference_rooms.hpp"
#include "scenes/classes.hpp"
#include "sensors/suite.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct FitArguments {
  Common common;
  std::string suite;
  std::string ontology = "office";
  std::string out;
  int scenes = 0;
  int rooms = 24;
  PerceiveOptions perceive;
  ReasonOptions reason;
};

constexpr double clear_majority =
    0.6;  // of a surface's points have to be of one class for it to teach that class

/// Class of most of a surface's points; "" where no class has a clear majority.
std::vector<std::string> true_names(const Scan& scan, const Surfaces& surfaces) {
  std::vector<std::string> names;
  for (const auto& surface : surfaces.surfaces) {
    std::map<ClassId, std::size_t> votes;
    for (const auto point : surface.inliers)
      ++votes[scan.truth.class_id[static_cast<std::size_t>(point)]];
    std::string name;
    for (const auto& [id, count] : votes) {
      const bool clear =
          static_cast<double>(count) > clear_majority * static_cast<double>(surface.inliers.size());
      if (clear && id != unlabelled) name = class_info(id).name;
    }
    names.push_back(std::move(name));
  }
  return names;
}

/// office.background.json -> office.rooms.json
fs::path rooms_file(const fs::path& background) {
  std::string name = background.filename().string();
  for (const std::string_view end : {".json", ".background"}) {
    if (name.ends_with(end)) name.resize(name.size() - end.size());
  }
  return background.parent_path() / (name + ".rooms.json");
}

/// Rooms from all over the part, as many as are kept.
std::vector<ReferenceRoom> spread(const std::vector<TrainingScene>& scenes,
                                  const FitArguments& arguments) {
  std::vector<ReferenceRoom> rooms;
  const std::size_t count = std::min(scenes.size(), static_cast<std::size_t>(arguments.rooms));
  for (std::size_t i = 0; i < count; ++i)
    rooms.push_back(make_reference_room(scenes[i * scenes.size() / count], arguments.reason));
  return rooms;
}

int run_fit(FitArguments& arguments) {
  const ThreadLimit limit(arguments.common.threads);
  OptionList list;
  list.add_group("perceive", arguments.perceive);
  list.add_group("reason", arguments.reason);
  apply_settings(list, arguments.common);
  const Suite suite = read_suite(find_data_file("suites", arguments.suite, ".yaml"));
  const Ontology ontology = find_ontology(arguments.ontology);
  RunOptions part;
  part.split = "train";
  part.scenes = arguments.scenes;
  const auto tasks = tasks_of(suite, part);
  const auto scenes = look_at_scans(tasks, suite, arguments.common, "rooms",
                                    [&](const MadeScene&, const Scan& scan) {
                                      TrainingScene scene;
                                      scene.surfaces = perceive(scan.cloud, arguments.perceive);
                                      scene.classes = true_names(scan, scene.surfaces);
                                      return scene;
                                    });
  std::size_t surfaces = 0;
  for (const auto& scene : scenes) surfaces += scene.surfaces.surfaces.size();

  const std::string fitted_on =
      fmt::format("{}: {} rooms of the training part, {} scans, {} surfaces", suite.name,
                  tasks.size(), scenes.size(), surfaces);
  const Background background = fit_backgrounds(ontology, scenes, arguments.reason, fitted_on);
  const fs::path out = arguments.out.empty() ? fs::path(ontology.file).parent_path() /
                                                   (ontology.name + ".background.json")
                                             : fs::path(arguments.out);
  write_background(out, background);
  const fs::path beside = rooms_file(out);
  write_reference_rooms(beside, spread(scenes, arguments), fitted_on);

  Json json = background_to_json(background);
  json["file"] = out.string();
  json["rooms_file"] = beside.string();
  answer(arguments.common, json);
  say(arguments.common, "Counted on " + fitted_on + ".");
  const auto silent = std::count_if(background.rates.begin(), background.rates.end(),
                                    [](const ClauseRates& rate) { return rate.weight < 0.01; });
  say(arguments.common, fmt::format("Prior of unknown {:.2f}; {} clauses add nothing (weight 0).",
                                    background.unknown_prior, silent));
  say(arguments.common, fmt::format("{} clauses of {} classes: {}", background.rates.size(),
                                    ontology.classes.size(), out.string()));
  say(arguments.common, fmt::format("Rooms to hold new classes against: {}", beside.string()));
  return 0;
}

}  // namespace

void add_fit(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand(
      "fit", "Count on training rooms how often each clause of a class file holds, and weigh it");
  verb->footer(
      "Example:\n  scanchor fit work-training --ontology office --out "
      "office.background.json\n"
      "Only rooms of the suite's training part are looked at.");
  auto arguments = std::make_shared<FitArguments>();
  verb->add_option("suite", arguments->suite, "A suite by name or file")
      ->required()
      ->type_name("SUITE");
  verb->add_option("--ontology", arguments->ontology, "Descriptions: a name or a .sdl file")
      ->capture_default_str();
  verb->add_option("--out", arguments->out,
                   "File to write; without it: <ontology>.background.json beside the class file")
      ->type_name("FILE");
  verb->add_option("--rooms", arguments->rooms,
                   "So many of the rooms are kept beside it, to weigh classes that nobody counted")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb->add_option("--scenes", arguments->scenes, "At most so many training rooms; 0: all")
      ->check(CLI::Range(0, 1000000));
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run_fit(*arguments); });
}

}  // namespace scanchor::apps
