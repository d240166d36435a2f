#include "apps/command.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include "sensors/suite.hpp"

namespace scanchor::apps {

std::atomic<bool> interrupted{false};

void add_common(CLI::App& verb, Common& common, bool with_set) {
  verb.add_flag("--json", common.json, "Print one JSON document and nothing else");
  verb.add_flag("--quiet,-q", common.quiet, "Print only errors");
  verb.add_option("--threads", common.threads, "Threads to use; 0: all cores")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  if (with_set) {
    verb.add_option("--set", common.set,
                    "Set an option of a stage: stage.option=value (repeatable)")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
  }
}

void apply_settings(OptionList& list, const Common& common) {
  for (const auto& assignment : common.set) list.set_assignment(assignment);
}

void apply_settings(Suite& suite, OptionList& list, const Common& common) {
  for (const std::string& assignment : common.set) {
    const auto equals = assignment.find('=');
    const bool of_suite = equals != std::string::npos &&
                          (assignment.starts_with("room.") || assignment.starts_with("settle.") ||
                           assignment.starts_with("lidar."));
    if (of_suite) {
      set_suite_option(suite, std::string_view(assignment).substr(0, equals),
                       std::string_view(assignment).substr(equals + 1));
    } else {
      list.set_assignment(assignment);
    }
  }
}

void say(const Common& common, const std::string& line) {
  if (!common.json && !common.quiet) fmt::print("{}\n", line);
}

void answer(const Common& common, const Json& json) {
  if (common.json) fmt::print("{}\n", json.dump(2));
}

Eigen::Vector3d parse_vector(const std::string& text, const std::string& option) {
  Eigen::Vector3d vector;
  const char* at = text.data();
  const char* end = at + text.size();
  for (int i = 0; i < 3; ++i) {
    const auto result = std::from_chars(at, end, vector[i]);
    const bool last = i == 2;
    if (result.ec != std::errc() || !std::isfinite(vector[i]) ||
        (last ? result.ptr != end : result.ptr == end || *result.ptr != ',')) {
      fail_usage(fmt::format("{}: '{}' is not three numbers", option, text), "write x,y,z");
    }
    at = result.ptr + (last ? 0 : 1);
  }
  return vector;
}

}  // namespace scanchor::apps
