// scanchor ontology: class files in their standard form, checked, shown and carried to OWL.

#include <fmt/format.h>

#include <filesystem>

#include "apps/command.hpp"
#include "core/data_folder.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "reasoning/catalogue.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/owl.hpp"
#include "reasoning/sdl_format.hpp"
#include "reasoning/sdl_lint.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct OntologyArguments {
  Common common;
  std::vector<std::string> files;
  std::string file;
  bool check = false;
  bool in_place = false;
  std::string to;
  std::string out;
  std::string class_name;
};

bool is_turtle(const std::string& file) { return fs::path(file).extension() == ".ttl"; }

fs::path path_of(const std::string& file) {
  return is_turtle(file) ? fs::path(file) : find_data_file("ontologies", file, ".sdl");
}

Ontology load(const std::string& file) {
  const fs::path path = path_of(file);
  return is_turtle(file) ? ontology_from_turtle(read_file(path), path.string())
                         : read_ontology(path);
}

void write_or_print(const OntologyArguments& arguments, const std::string& text) {
  if (arguments.out.empty()) {
    fmt::print("{}", text);
  } else {
    write_file(arguments.out, text);
    say(arguments.common, fmt::format("written:  {}", arguments.out));
  }
}

int format(const OntologyArguments& arguments) {
  Json json = Json::array();
  int differing = 0;
  for (const auto& file : arguments.files) {
    const fs::path path = path_of(file);
    const std::string text = read_file(path);
    const std::string formatted = format_sdl(text, path.string());
    const bool same = text == formatted;
    differing += same ? 0 : 1;
    json.push_back({{"file", path.string()}, {"standard", same}});
    if (arguments.check) {
      if (!same) say(arguments.common, fmt::format("{}: not in standard form", path.string()));
    } else if (arguments.in_place) {
      if (!same) write_file(path, formatted);
      say(arguments.common, fmt::format("{}: {}", path.string(), same ? "as it was" : "formatted"));
    } else if (!arguments.common.json) {
      fmt::print("{}", formatted);
    }
  }
  answer(arguments.common, json);
  return arguments.check && differing > 0 ? static_cast<int>(ExitCode::gate_failed) : 0;
}

int lint_files(const OntologyArguments& arguments) {
  Json json = Json::array();
  std::size_t count = 0;
  for (const auto& file : arguments.files) {
    const Ontology ontology = load(file);
    const auto findings = lint(ontology);
    count += findings.size();
    for (const auto& finding : findings) {
      json.push_back({{"rule", finding.rule},
                      {"file", finding.file},
                      {"line", finding.place.line},
                      {"column", finding.place.column},
                      {"text", finding.text},
                      {"explanation", lint_explanation(finding.rule)}});
      say(arguments.common, lint_text(finding));
      say(arguments.common, "    " + lint_explanation(finding.rule));
    }
    if (findings.empty())
      say(arguments.common, fmt::format("{}: {} classes, nothing to complain about", ontology.file,
                                        ontology.classes.size()));
  }
  answer(arguments.common, json);
  return count > 0 ? static_cast<int>(ExitCode::gate_failed) : 0;
}

int show(const OntologyArguments& arguments) {
  Ontology ontology = load(arguments.file);
  if (!arguments.class_name.empty()) {
    const int c = ontology.find(arguments.class_name, true);
    if (c < 0)
      fail_usage("the ontology has no class '" + arguments.class_name + "'",
                 suggestion(arguments.class_name, ontology.class_names()));
    const auto users = built_on(ontology, ontology.classes[c].name());
    Ontology one = ontology;
    one.imports.clear();
    one.closing_comments.clear();
    one.classes = {ontology.classes[c]};
    std::string text = ontology_to_sdl(one);
    for (std::size_t i = 0; i < users.size(); ++i)
      text += (i == 0 ? "# asked for by: " : ", ") + users[i];
    if (!users.empty()) text += "\n";
    Json all = catalogue_json(ontology);
    answer(arguments.common, all["classes"][static_cast<std::size_t>(c)]);
    if (!arguments.common.json) fmt::print("{}", text);
    return 0;
  }
  answer(arguments.common, catalogue_json(ontology));
  for (const auto& description : ontology.classes) {
    const std::string whole = !description.parent.empty()    ? ", a kind of " + description.parent
                              : !description.part_of.empty() ? ", part of " + description.part_of
                                                             : "";
    const char* noun = description.clauses.size() == 1 ? "clause" : "clauses";
    say(arguments.common, fmt::format("{:<18} {:>2} {}{}", description.name(),
                                      description.clauses.size(), noun, whole));
  }
  return 0;
}

int convert(OntologyArguments& arguments) {
  if (arguments.to.empty()) {
    arguments.to = !arguments.out.empty() && fs::path(arguments.out).has_extension()
                       ? fs::path(arguments.out).extension().string().substr(1)
                   : is_turtle(arguments.file) ? "sdl"
                                               : "ttl";
  }
  if (arguments.to != "sdl" && arguments.to != "ttl" && arguments.to != "md")
    fail_usage("cannot convert to '" + arguments.to + "'", "known are: sdl, ttl, md");
  Ontology ontology = load(arguments.file);
  // The converted file stands for itself: what was imported is in it.
  ontology.imports.clear();
  const std::string text = arguments.to == "ttl"   ? ontology_to_turtle(ontology)
                           : arguments.to == "sdl" ? ontology_to_sdl(ontology)
                                                   : catalogue_markdown(ontology);
  write_or_print(arguments, text);
  return 0;
}

}  // namespace

void add_ontology(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("ontology", "Format, check, show and convert class files");
  verb->require_subcommand(1);
  verb->footer(
      "Examples:\n"
      "  scanchor ontology format --check mine.sdl\n"
      "  scanchor ontology lint mine.sdl --json\n"
      "  scanchor ontology show office --class desk\n"
      "  scanchor ontology convert office --to ttl --out office.ttl\n"
      "FILE is a .sdl file, a name that comes with the program or, but for format, a .ttl file.\n"
      "Exit codes: 0 done, 1 format --check or lint found something, 3 a file is broken.");
  const auto add = [&](const char* name, const char* text, const char* footer, auto run,
                       bool several) {
    auto arguments = std::make_shared<OntologyArguments>();
    auto* sub = verb->add_subcommand(name, text);
    sub->footer(footer);
    if (several) {
      sub->add_option("file", arguments->files, "Class files")->required()->type_name("FILE");
    } else {
      sub->add_option("file", arguments->file, "Class file")->required()->type_name("FILE");
    }
    add_common(*sub, arguments->common, false);
    sub->callback([arguments, run, &code] { code = run(*arguments); });
    return std::make_pair(sub, arguments);
  };
  const auto formatter =
      add("format", "Print a class file in its standard form",
          "Example:\n  scanchor ontology format --in-place mine.sdl", format, true);
  auto* check = formatter.first->add_flag("--check", formatter.second->check,
                                          "Only say which files differ; exit 1 if one does");
  formatter.first->add_flag("--in-place,-i", formatter.second->in_place, "Rewrite the files")
      ->excludes(check);
  add("lint", "Find what is legal in a class file but cannot be meant",
      "Example:\n  scanchor ontology lint mine.sdl", lint_files, true);
  const auto shower = add("show", "List the classes, or print one",
                          "Example:\n  scanchor ontology show office --class monitor", show, false);
  shower.first
      ->add_option("--class", shower.second->class_name, "Print this class and who asks for it")
      ->type_name("NAME");
  const auto converter =
      add("convert", "Carry a class file to OWL in Turtle and back, or to a Markdown catalogue",
          "Example:\n  scanchor ontology convert mine.ttl --out mine.sdl", convert, false);
  converter.first
      ->add_option("--to", converter.second->to,
                   "ttl, sdl or md; default: by --out, else ttl for .sdl and sdl for .ttl")
      ->type_name("KIND");
  converter.first->add_option("--out", converter.second->out, "Write here; default: print")
      ->type_name("FILE");
}

}  // namespace scanchor::apps
