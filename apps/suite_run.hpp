#pragma once
// Suites on the command line, for the verbs that measure many scenes: score, check, baseline,
// sweep, blame, shrink.

#include "apps/command.hpp"
#include "eval/run.hpp"

namespace scanchor::apps {

struct SuiteArguments {
  Common common;
  std::string suite = "quick";
  std::string ontology = "office";
  std::string protocol = "scanchor-1";
  std::string method = "default";
  std::string split = "test";
  int scenes = 0;
  PerceiveOptions perceive;
  ReasonOptions reason;
};

void add_suite_arguments(CLI::App& verb, SuiteArguments& arguments);

/// The suite with --set applied.
Suite load_suite(SuiteArguments& arguments);
/// The method that --method names, or another one with the same options.
Method load_method(const SuiteArguments& arguments);
Method load_method(const SuiteArguments& arguments, const std::string& name);
RunOptions run_options(const SuiteArguments& arguments);

/// What of the command line decides a method's answers, as a hash: the options of the stages and
/// the text of the descriptions.
std::string options_stamp(const SuiteArguments& arguments);
/// Hash of the running program: what another version measured is not taken for this one's.
std::string program_stamp();

}  // namespace scanchor::apps
