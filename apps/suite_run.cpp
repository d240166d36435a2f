#include "apps/suite_run.hpp"

#include "apps/methods.hpp"
#include "core/data_folder.hpp"
#include "core/file.hpp"
#include "reasoning/sdl_format.hpp"

namespace scanchor::apps {

void add_suite_arguments(CLI::App& verb, SuiteArguments& arguments) {
  verb.add_option("suite", arguments.suite, "quick, office, storage, home, stress, or a YAML file")
      ->type_name("SUITE")
      ->capture_default_str();
  verb.add_option("--scenes", arguments.scenes, "At most so many scenes of the part; 0: all")
      ->check(CLI::Range(0, 1000000));
  verb.add_option("--split", arguments.split, "Part of the suite: train, valid or test")
      ->check(CLI::IsMember({"train", "valid", "test"}))
      ->capture_default_str();
  verb.add_option("--method", arguments.method,
                  "default, paper, or a peer: cgal-region-growing, cgal-ransac, pcl-region-growing")
      ->type_name("METHOD")
      ->capture_default_str();
  verb.add_option("--ontology", arguments.ontology, "Descriptions: a name or a .sdl file")
      ->capture_default_str();
  verb.add_option("--protocol", arguments.protocol, "Scoring rules: a name or a file")
      ->capture_default_str();
  add_common(verb, arguments.common);
}

Suite load_suite(SuiteArguments& arguments) {
  Suite suite = read_suite(find_data_file("suites", arguments.suite, ".yaml"));
  OptionList list;
  suite.describe(list);
  list.add_group("perceive", arguments.perceive);
  list.add_group("reason", arguments.reason);
  apply_settings(suite, list, arguments.common);
  return suite;
}

Method load_method(const SuiteArguments& arguments) {
  return load_method(arguments, arguments.method);
}

Method load_method(const SuiteArguments& arguments, const std::string& name) {
  return find_method(name, arguments.perceive, find_ontology(arguments.ontology), arguments.reason);
}

RunOptions run_options(const SuiteArguments& arguments) {
  RunOptions options;
  options.protocol = find_protocol(arguments.protocol);
  options.split = arguments.split;
  options.scenes = arguments.scenes;
  options.threads = arguments.common.threads;
  options.stop = &interrupted;
  return options;
}

std::string options_stamp(const SuiteArguments& arguments) {
  SuiteArguments copy = arguments;
  OptionList list;
  list.add_group("perceive", copy.perceive);
  list.add_group("reason", copy.reason);
  return sha256(list.to_json().dump() + ontology_to_sdl(find_ontology(arguments.ontology)));
}

std::string program_stamp() { return sha256(read_file("/proc/self/exe")); }

}  // namespace scanchor::apps
