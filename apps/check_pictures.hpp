#pragma once
// What the gate shows of the scenes that lost most: the named things before and after.

#include <filesystem>
#include <vector>

#include "eval/gate.hpp"

namespace scanchor::apps {

/// One picture a scene of the run, of the first scan: what a later check shows as "before".
void draw_baseline_pictures(const std::filesystem::path& folder, const Suite& suite,
                            const Method& method, const RunResult& run);

/// The worst scenes as they are now, beside the picture that `before` has of them, if it has.
/// Returns the files.
std::vector<std::filesystem::path> draw_worst_scenes(const std::filesystem::path& folder,
                                                     const std::filesystem::path& before,
                                                     const Suite& suite, const Method& method,
                                                     const GateReport& report);

}  // namespace scanchor::apps
