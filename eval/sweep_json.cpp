#include "core/file.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "eval/gate.hpp"
#include "eval/sweep.hpp"

namespace scanchor {
PointRunner kept_runs(const Method& method, const SweepOptions& options) {
  if (!options.folder.empty()) make_folder(options.folder);
  return [=](const Suite& point) {
    const std::string key =
        data_stamp(point, options.run.split) + method.name + protocol_stamp(options.run.protocol) +
        std::to_string(options.run.scenes) + "/" + std::to_string(options.run.first_scene) + "/" +
        std::to_string(options.run.shard.index) + "/" + std::to_string(options.run.shard.count) +
        "/" + std::to_string(point.scenes) + "/" + options.stamp;
    const auto file = options.folder / ("point-" + sha256(key).substr(0, 16) + ".json");
    if (!options.folder.empty() && std::filesystem::exists(file))
      return run_from_json(read_json(file), file.string());
    RunResult run = run_suite(point, method, options.run);
    if (!options.folder.empty() && !run.interrupted) write_json(file, run_to_json(run));
    return run;
  };
}

SweepResult sweep(const Suite& suite, const std::vector<Axis>& axes, const Method& method,
                  const SweepOptions& options) {
  SweepResult result = sweep(suite, axes, options, kept_runs(method, options));
  result.method = method.name;
  return result;
}

Json sweep_to_json(const SweepResult& result) {
  Json json = Json::object();
  json["format"] = "scanchor-sweep";
  json["schema"] = 1;
  if (!result.method.empty()) json["method"] = result.method;
  Json axes = Json::array();
  for (const auto& axis : result.axes) {
    Json one = Json::object();
    one["option"] = axis.option;
    one["values"] = axis.values;
    axes.push_back(std::move(one));
  }
  json["axes"] = std::move(axes);
  json["interrupted"] = result.interrupted;
  Json points = Json::array();
  for (const auto& point : result.points) {
    Json one = Json::object();
    one["values"] = point.values;
    one["scenes"] = point.run.rows.size();
    Json all = Json::object();
    for (const auto& [name, value] : metrics(point.run.pooled, point.run.protocol))
      all[name] = value;
    one["metrics"] = std::move(all);
    Json intervals = Json::object(), gated = Json::object();
    for (const auto& [name, interval] : point.intervals) {
      Json bounds = Json::array();
      bounds.push_back(interval.low);
      bounds.push_back(interval.high);
      intervals[name] = std::move(bounds);
      gated[name] = value_of(point.run, name);
    }
    one["gated"] = std::move(gated);
    one["intervals"] = std::move(intervals);
    points.push_back(std::move(one));
  }
  json["points"] = std::move(points);
  return json;
}

Json sweeps_to_json(const std::vector<SweepResult>& results) {
  Json json = sweep_to_json(results.front());
  Json methods = Json::array();
  for (const auto& result : results) {
    Json one = Json::object();
    const Json whole = sweep_to_json(result);
    one["method"] = result.method;
    one["points"] = whole.at("points");
    methods.push_back(std::move(one));
  }
  json["methods"] = std::move(methods);
  return json;
}

std::string sweep_to_csv(const SweepResult& result) {
  std::string text;
  for (const auto& axis : result.axes) text += axis.option + ",";
  text += "scenes";
  if (!result.points.empty()) {
    for (const auto& [name, interval] : result.points.front().intervals)
      text += "," + name + "," + name + ".low," + name + ".high";
  }
  text += "\n";
  for (const auto& point : result.points) {
    for (const double value : point.values) text += shortest_text(value) + ",";
    text += std::to_string(point.run.rows.size());
    for (const auto& [name, interval] : point.intervals) {
      text += "," + shortest_text(value_of(point.run, name)) + "," + shortest_text(interval.low) +
              "," + shortest_text(interval.high);
    }
    text += "\n";
  }
  return text;
}

}  // namespace scanchor
