#include "results/report_sweeps.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "results/sweep_plots.hpp"

namespace scanchor {
namespace {

constexpr const char* things = "objects.f1";
constexpr const char* planes = "planes.f1";

/// One metric over the given points.
Json curve(const std::string& name, const std::vector<JsonReader>& points,
           const std::string& metric) {
  Json json = Json::object();
  json["name"] = name;
  Json value = Json::array(), low = Json::array(), high = Json::array();
  for (const auto& point : points) {
    const auto intervals = point.at("intervals");
    value.push_back(point.at("gated").at(metric).raw());
    if (!intervals.has(metric)) continue;
    low.push_back(intervals.at(metric).at(0).raw());
    high.push_back(intervals.at(metric).at(1).raw());
  }
  json["value"] = std::move(value);
  if (low.size() == points.size()) {
    json["low"] = std::move(low);
    json["high"] = std::move(high);
  }
  return json;
}

std::vector<JsonReader> rows(const JsonReader& points) {
  std::vector<JsonReader> list;
  for (std::size_t i = 0; i < points.size(); ++i) list.push_back(points.at(i));
  return list;
}

Json plot(const std::string& title, const JsonReader& axis, const std::string& measure) {
  Json json = Json::object();
  json["title"] = title;
  json["words"] = "bands: 95 % over scenes";
  json["axis"] = axis.at("option").text();
  json["measure"] = measure;
  json["x"] = axis.at("values").raw();
  json["curves"] = Json::array();
  return json;
}

void one_axis(const JsonReader& sweep, Json& plots) {
  const auto axis = sweep.at("axes").at(0);
  const auto points = rows(sweep.at("points"));
  if (points.empty()) return;
  Json all = plot("Scores over " + axis.at("option").text(), axis, "share");
  for (const auto& [metric, interval] : points.front().at("intervals").raw().items())
    all["curves"].push_back(curve(metric, points, metric));
  plots.push_back(std::move(all));
  if (!sweep.has("methods") || sweep.at("methods").size() < 2) return;
  const auto methods = sweep.at("methods");
  for (const char* metric : {things, planes}) {
    Json by_method = plot(fmt::format("{} by method", metric), axis, metric);
    for (std::size_t m = 0; m < methods.size(); ++m)
      by_method["curves"].push_back(curve(finder_name(methods.at(m).at("method").text()),
                                          rows(methods.at(m).at("points")), metric));
    plots.push_back(std::move(by_method));
  }
}

void two_axes(const JsonReader& sweep, Json& plots) {
  const auto first = sweep.at("axes").at(0), second = sweep.at("axes").at(1);
  const auto points = rows(sweep.at("points"));
  const std::size_t columns = second.at("values").size();
  const std::string option = second.at("option").text();
  Json json = plot(fmt::format("{} over {} and {}", things, first.at("option").text(), option),
                   first, things);
  for (std::size_t c = 0; c < columns; ++c) {
    std::vector<JsonReader> column;
    for (std::size_t n = c; n < points.size(); n += columns) column.push_back(points[n]);
    json["curves"].push_back(curve(
        fmt::format("{} {:.4g}", option, second.at("values").at(c).number()), column, things));
  }
  plots.push_back(std::move(json));
}

}  // namespace

Json report_sweeps(const Json& sweep, const std::string& file) {
  const JsonReader reader(sweep, file);
  if (!reader.has("format") || reader.at("format").text() != "scanchor-sweep")
    reader.fail("is no sweep", "'scanchor sweep --out DIR' writes one");
  Json plots = Json::array();
  if (reader.at("axes").size() == 1) one_axis(reader, plots);
  if (reader.at("axes").size() == 2) two_axes(reader, plots);
  return plots;
}

Json read_report_sweeps(const std::filesystem::path& run,
                        const std::vector<std::filesystem::path>& folders) {
  Json plots = Json::array();
  const auto add = [&](const std::filesystem::path& file) {
    for (auto& one : report_sweeps(read_json(file), file.string())) plots.push_back(std::move(one));
  };
  if (std::filesystem::exists(run / "sweep.json")) add(run / "sweep.json");
  for (const auto& folder : folders) {
    const auto file = std::filesystem::is_directory(folder) ? folder / "sweep.json" : folder;
    if (!std::filesystem::exists(file))
      fail_data(file.string(), "", "there is no sweep here",
                "'scanchor sweep --out DIR' makes one");
    add(file);
  }
  return plots;
}

}  // namespace scanchor
