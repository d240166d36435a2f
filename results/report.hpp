#pragma once
// One HTML file that opens without a network and shows what a run did: sentence, scores, plots,
// gallery, and every scene in 3D with the proof of each label. docs/reference/report.md.

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace scanchor {

struct ReportOptions {
  std::string title;  ///< empty: made of the run
  std::filesystem::path
      baseline;  ///< folder or summary.json of another run to compare with; empty: none
  std::vector<std::filesystem::path> sweeps;  ///< folders of sweeps to show as curves
  int points_per_scene = 30000;               ///< most points of a scene in its 3D view
  double scene_megabytes = 60.0;  ///< of all 3D views together: many scenes have fewer points each
  int thumbnails = 24;            ///< pictures in the gallery
  std::function<void(std::size_t done, std::size_t total)> progress;  ///< rooms; may be empty
};

/// Reads what `scanchor run` left in the folder (summary.json; in each room scan, surfaces, labels,
/// pictures) and writes the page, whole or not at all. A room whose files are missing or damaged is
/// listed without its 3D view, damage with its cause. Throws Error(bad_data) if there is no run in
/// the folder, or no viewer (results/report/bundle.js) beside the program.
void write_report(const std::filesystem::path& run_folder, const std::filesystem::path& html,
                  const ReportOptions& options = {});

/// The run as the page's script reads it, without the 3D views. `summary` is summary.json;
/// `baseline` may be null.
nlohmann::ordered_json report_data(const nlohmann::ordered_json& summary,
                                   const nlohmann::ordered_json* baseline, const std::string& file);

/// "Of 31 things in 3 rooms 27 were found (87 %); of 29 claims 27 were right (93 %)."
std::string report_sentence(const nlohmann::ordered_json& data);

}  // namespace scanchor
