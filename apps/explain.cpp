// scanchor explain: why a thing has its label, and what would have to change for it to have
// another.

#include <fmt/format.h>

#include <filesystem>

#include "apps/command.hpp"
#include "reasoning/explain.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct ExplainArguments {
  Common common;
  std::string folder;
  int entity = 0;
  std::string why_not;
  std::string ontology;
};

int run_explain(ExplainArguments& arguments) {
  const fs::path labels = fs::path(arguments.folder) / "labels.json";
  const Labelling labelling = labelling_from_json(read_json(labels), labels.string());
  Json json;
  json["id"] = arguments.entity;
  std::string text;
  if (arguments.why_not.empty()) {
    text = explain(labelling, arguments.entity);
  } else {
    const Surfaces surfaces = read_surfaces(fs::path(arguments.folder) / "surfaces.json");
    const Ontology ontology =
        find_ontology(arguments.ontology.empty() ? labelling.ontology : arguments.ontology);
    const WhyNot reason =
        why_not(surfaces, ontology, labelling, arguments.entity, arguments.why_not);
    text = reason.text;
    json["class"] = arguments.why_not;
    json["holds"] = reason.holds;
    json["clause"] = reason.clause;
    json["likelihood"] = reason.likelihood;
    json["measured"] = reason.measured;
    json["unit"] = reason.unit;
    if (reason.has_needed) json["needed"] = reason.needed;
  }
  json["text"] = text;
  answer(arguments.common, json);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  say(arguments.common, text);
  return 0;
}

}  // namespace

void add_explain(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("explain", "Say why a thing has its label, or why not another");
  verb->footer(
      "Examples:\n  scanchor explain scanchor-room 7\n  scanchor explain scanchor-room 7 --why-not "
      "desk");
  auto arguments = std::make_shared<ExplainArguments>();
  verb->add_option("folder", arguments->folder,
                   "What label or run wrote: labels.json and surfaces.json lie in it")
      ->required()
      ->type_name("DIR");
  verb->add_option("id", arguments->entity, "The thing, by its id in labels.json")->required();
  verb->add_option("--why-not", arguments->why_not,
                   "Name the first clause of this class that fails, and what would mend it")
      ->type_name("CLASS");
  verb->add_option("--ontology", arguments->ontology,
                   "Descriptions; default: those of labels.json");
  add_common(*verb, arguments->common, false);
  verb->callback([arguments, &code] { code = run_explain(*arguments); });
}

}  // namespace scanchor::apps
