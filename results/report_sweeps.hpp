#pragma once
// Sweeps on the report's page: curves that answer to the mouse.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace scanchor {

/// What the page draws of sweep.json: {title, words, axis, measure, x, curves: [{name, value, low,
/// high}]}, one entry a plot. One axis: all metrics of the first method and, with several methods,
/// things and planes by method. Two axes: things over the first, a curve for each value of the
/// second. Throws Error(bad_data) naming `file`.
nlohmann::ordered_json report_sweeps(const nlohmann::ordered_json& sweep, const std::string& file);

/// All of them: `folders` hold sweep.json; so may the run's own folder.
nlohmann::ordered_json read_report_sweeps(const std::filesystem::path& run,
                                          const std::vector<std::filesystem::path>& folders);

}  // namespace scanchor
