#pragma once
// What all verbs share: the flags that are the same everywhere, how a result is printed, how an
// interrupt arrives.

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/options.hpp"

namespace scanchor {
struct Suite;
}

namespace scanchor::apps {

/// Flags that mean the same in every verb.
struct Common {
  bool json = false;             ///< print one JSON document on standard output and nothing else
  bool quiet = false;            ///< print only errors
  int threads = 0;               ///< 0: all cores
  std::vector<std::string> set;  ///< "stage.option=value"
};

/// Adds --json, --quiet, --threads and, where the verb has options of stages, --set.
void add_common(CLI::App& verb, Common& common, bool with_set = true);

/// Applies every `--set` to the list; an unknown name or a bad value is an Error(wrong_usage).
void apply_settings(OptionList& list, const Common& common);
/// The same where a suite is among what the list describes: "room.", "settle." and "lidar." go
/// through set_suite_option, which loads a preset and chooses the family; the rest goes to the
/// list.
void apply_settings(Suite& suite, OptionList& list, const Common& common);

/// Prints a line of the human answer; nothing under --quiet or --json.
void say(const Common& common, const std::string& line);
/// Prints the machine's answer under --json; nothing otherwise.
void answer(const Common& common, const Json& json);

/// True once SIGINT or SIGTERM came: long work stops at the next whole file.
extern std::atomic<bool> interrupted;

/// Parses "x,y,z". Throws Error(wrong_usage) naming the option.
Eigen::Vector3d parse_vector(const std::string& text, const std::string& option);

/// Where a verb's callback leaves the exit code.
using ExitCodeSlot = int;
/// Registers every verb below the root, in the order of the help.
void add_all_verbs(CLI::App& root, ExitCodeSlot& code);
void add_run(CLI::App& root, ExitCodeSlot& code);
void add_generate(CLI::App& root, ExitCodeSlot& code);
void add_label(CLI::App& root, ExitCodeSlot& code);
void add_segment(CLI::App& root, ExitCodeSlot& code);
void add_score(CLI::App& root, ExitCodeSlot& code);
void add_explain(CLI::App& root, ExitCodeSlot& code);
void add_find(CLI::App& root, ExitCodeSlot& code);
void add_ontology(CLI::App& root, ExitCodeSlot& code);
void add_render(CLI::App& root, ExitCodeSlot& code);
void add_report(CLI::App& root, ExitCodeSlot& code);
void add_figures(CLI::App& root, ExitCodeSlot& code);
void add_gallery(CLI::App& root, ExitCodeSlot& code);
void add_fit(CLI::App& root, ExitCodeSlot& code);
void add_fit_relations(CLI::App& root, ExitCodeSlot& code);
void add_check(CLI::App& root, ExitCodeSlot& code);
void add_baseline(CLI::App& root, ExitCodeSlot& code);
void add_sweep(CLI::App& root, ExitCodeSlot& code);
void add_blame(CLI::App& root, ExitCodeSlot& code);
void add_shrink(CLI::App& root, ExitCodeSlot& code);

}  // namespace scanchor::apps
