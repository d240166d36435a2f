#include "results/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "cloud/io.hpp"
#include "core/data_folder.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/markup.hpp"
#include "results/image.hpp"
#include "results/pack.hpp"
#include "results/report_scene.hpp"
#include "results/report_sweeps.hpp"
#include "sensors/scan.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;

constexpr double bytes_a_point = 9.0;      // packed, measured on scans of rooms
constexpr double bytes_of_a_scene = 40e3;  // surfaces and proofs

Json read_summary(const fs::path& path) {
  const fs::path file = fs::is_directory(path) ? path / "summary.json" : path;
  if (!fs::exists(file)) {
    fail_data(file.string(), "", "there is no run here", "'scanchor run --out DIR' makes one");
  }
  return read_json(file);
}

/// The 3D view of one room, packed; empty if its files are not there.
std::string scene_view(const fs::path& folder, const std::string& name, std::size_t points) {
  for (const char* file : {"scan.pcd", "surfaces.json", "labels.json"}) {
    if (!fs::exists(folder / file)) return "";
  }
  const Scan scan = scan_from_cloud(read_cloud(folder / "scan.pcd"));
  const Surfaces surfaces = read_surfaces(folder / "surfaces.json");
  const fs::path labels = folder / "labels.json";
  const Labelling labelling = labelling_from_json(read_json(labels), labels.string());
  return packed(report_scene(name, scan, surfaces, labelling, points));
}

std::string thumbnail(const fs::path& folder) {
  for (const char* file : {"labels.png", "planes.png", "cloud.png", "scene.png"}) {
    if (!fs::exists(folder / file)) continue;
    const Image image = read_png(folder / file);
    return "data:image/png;base64," +
           base64(png_bytes(smaller(image, std::max(1, image.width / 420))));
  }
  return "";
}

}  // namespace

void write_report(const fs::path& run_folder, const fs::path& html, const ReportOptions& options) {
  const std::string script = read_file(find_data_file("results/report", "bundle", ".js"));
  const std::string style = read_file(find_data_file("results/report", "style", ".css"));
  const fs::path folder = fs::is_directory(run_folder) ? run_folder : run_folder.parent_path();
  const Json summary = read_summary(run_folder);
  Json baseline;
  if (!options.baseline.empty()) baseline = read_summary(options.baseline);
  Json data = report_data(summary, options.baseline.empty() ? nullptr : &baseline,
                          (folder / "summary.json").string());
  data["sentence"] = report_sentence(data);
  data["baseline"] = options.baseline.string();
  const std::string title =
      options.title.empty() ? "Scanchor: " + data.at("suite").get<std::string>() : options.title;
  data["title"] = title;
  data["sweeps"] = read_report_sweeps(folder, options.sweeps);

  Json& scenes = data.at("scenes");
  const double share = options.scene_megabytes * 1e6 / std::max<double>(1.0, double(scenes.size()));
  const double most = std::max(500.0, (share - bytes_of_a_scene) / bytes_a_point);
  const auto points = std::size_t(std::min(double(options.points_per_scene), most));
  write_file(html, [&](std::ostream& out) {
    out << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        << "<title>" << escape_markup(title) << "</title>\n<style>\n"
        << style << "</style>\n</head>\n<body>\n<div id=\"app\"><p>"
        << escape_markup(data.at("sentence").get<std::string>())
        << "</p></div>\n<noscript>This report needs JavaScript for its plots and 3D "
           "views.</noscript>\n";
    // A scene is inert text until somebody opens it, so a thousand of them cost nothing at the
    // start.
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const std::string name = scenes[i].at("name").get<std::string>();
      std::string view;
      try {
        view = scene_view(folder / name, name, points);
      } catch (const Error& error) {
        // One damaged room does not take the report of all others away; the page says what is wrong
        // with it.
        scenes[i]["problem"] = error.what();
      }
      scenes[i]["view"] = !view.empty();
      if (!view.empty()) {
        out << "<script type=\"text/plain\" id=\"scene-" << i << "\">" << view << "</script>\n";
      }
      if (options.progress) options.progress(i + 1, scenes.size());
      if (i < std::size_t(options.thumbnails)) {
        if (std::string image = thumbnail(folder / name); !image.empty()) {
          scenes[i]["picture"] = std::move(image);
        }
      }
    }
    out << "<script type=\"application/json\" id=\"run\">" << script_safe(data.dump())
        << "</script>\n<script>\n"
        << script << "\n</script>\n</body>\n</html>\n";
  });
}

}  // namespace scanchor
