#pragma once
// Suites on the command line, for the verbs that measure many scenes: check, baseline, sweep,
// blame.

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
  std::string shard = "1/1";
  int scenes = 0;
  PerceiveOptions perceive;
  ReasonOptions reason;
};

void add_suite_arguments(CLI::App& verb, SuiteArguments& arguments);

/// The suite with --set applied.
Suite load_suite(SuiteArguments& arguments);
Method load_method(const SuiteArguments& arguments);
/// Options of a run, with progress on the terminal until `progress` dies.
RunOptions run_options(const SuiteArguments& arguments);

}  // namespace scanchor::apps
