// scanchor find: a question in the words of the class files, put to a scan.

#include <fmt/format.h>

#include <filesystem>

#include "apps/scan_input.hpp"
#include "core/data_folder.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "reasoning/alternatives.hpp"
#include "reasoning/answer.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/places.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct FindArguments : ScanArguments {
  std::string question;
};

struct Labelled {
  Surfaces surfaces;
  Labelling labelling;
};

/// What label or run wrote: the folder, or the labels.json in it.
bool read_labelled(const std::string& input, Labelled& scene) {
  std::error_code error;
  fs::path folder = input;
  if (fs::path(input).filename() == "labels.json") folder = fs::path(input).parent_path();
  if (!fs::is_directory(input, error) && fs::path(input).extension() != ".json") return false;
  const fs::path labels =
      fs::path(input).extension() == ".json" ? fs::path(input) : folder / "labels.json";
  scene.labelling = labelling_from_json(read_json(labels), labels.string());
  if (fs::path(input).extension() == ".json") folder = fs::path(input).parent_path();
  scene.surfaces = read_surfaces(folder / "surfaces.json");
  return true;
}

int exit_code(Answer::Status status) {
  switch (status) {
    case Answer::Status::ok:
      return static_cast<int>(ExitCode::done);
    case Answer::Status::not_found:
      return static_cast<int>(ExitCode::nothing_measured);
    default:
      return static_cast<int>(ExitCode::inconclusive);
  }
}

/// What label or run wrote is not labelled again: options of the labelling would change nothing.
void refuse_labelling_options(const CLI::App& verb, const std::string& input) {
  for (const char* option : {"--noise", "--method", "--up", "--mode", "--set", "--options"}) {
    const auto* given = verb.get_option_no_throw(option);
    if (given == nullptr || given->count() == 0) continue;
    fail_usage(fmt::format("{}: {} is labelled already, and '{}' is an option of the labelling",
                           option, input, option),
               "ask the scan itself, or label it again with the option");
  }
}

/// The class file that a scene was labelled with. A user's own is known by its name alone.
Ontology ontology_of(const Labelling& labelling, const std::string& input) {
  const std::string& name = labelling.ontology;
  std::error_code error;
  if (!look_up_data_file("ontologies", name, ".sdl") && !fs::is_regular_file(name + ".sdl", error))
    fail_data(input, "", "was labelled with '" + name + "', which is not found here",
              "name its file: --ontology " + name + ".sdl");
  return find_ontology(name);
}

int run_find(FindArguments& arguments, const CLI::App& verb) {
  const ThreadLimit limit(arguments.common.threads);
  Labelled scene;
  const bool labelled = read_labelled(arguments.scan, scene);
  if (labelled) refuse_labelling_options(verb, arguments.scan);
  const bool ontology_given = verb.count("--ontology") > 0;
  const Ontology ontology = labelled && !ontology_given
                                ? ontology_of(scene.labelling, arguments.scan)
                                : find_ontology(arguments.ontology);
  const auto room = parse_place_question(arguments.question, ontology);
  const Query query = room ? room->thing : parse_query(arguments.question, ontology);
  if (!labelled) {
    const PointCloud cloud = load_scan(arguments);
    scene.surfaces = perceive(cloud, arguments.perceive);
    require_surfaces(arguments, cloud, scene.surfaces);
    scene.labelling = interpret(scene.surfaces, cloud, ontology, arguments.reason);
  } else if (arguments.sensor != "auto" && arguments.sensor != "none") {
    scene.surfaces.sensor_positions = {parse_vector(arguments.sensor, "--sensor")};
  }
  const SceneThings things(scene.surfaces, ontology, scene.labelling);
  if (room) {
    const PlaceAnswer found = find_places(*room, scene.surfaces, scene.labelling, things);
    answer(arguments.common, places_to_json(found, things));
    std::string text = places_text(found, things);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    say(arguments.common, text);
    return exit_code(found.status);
  }
  const Answer found = scanchor::answer(query, things);
  answer(arguments.common, answer_to_json(found, things));
  std::string text = answer_text(found, things);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  say(arguments.common, text);
  return exit_code(found.status);
}

}  // namespace

void add_find(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("find", "Ask a scan: what is where, how many, how far, and why");
  verb->footer(
      "Examples:\n"
      "  scanchor find \"screen on a desk\" room.pcd\n"
      "  scanchor find \"second board from the top of the shelf\" scanchor-room\n"
      "  scanchor find \"how many chairs near a table\" scanchor-room --json\n"
      "  scanchor find \"desk with no screen\" scanchor-room\n"
      "  scanchor find \"the nearest cabinet that is left of a window\" scanchor-room\n"
      "  scanchor find \"distance from the door to the nearest desk\" scanchor-room\n"
      "  scanchor find \"free place of 30 x 40 cm on a desk\" scanchor-room\n"
      "  scanchor find \"where could a robot stand in front of the cabinet\" scanchor-room\n"
      "SCAN may be what label or run wrote: it is not labelled again.\n"
      "Exit codes: 0 answered, 4 not found, 5 ambiguous or not seen.");
  auto arguments = std::make_shared<FindArguments>();
  verb->add_option("question", arguments->question, "In the words of the class files")
      ->required()
      ->type_name("TEXT");
  add_scan_arguments(*verb, *arguments, true);
  verb->callback([arguments, verb, &code] { code = run_find(*arguments, *verb); });
}

}  // namespace scanchor::apps
