// The numbers of the report, from summary.json to what the page's script reads.
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "eval/score.hpp"
#include "results/color.hpp"
#include "results/report.hpp"
#include "results/score_plots.hpp"

namespace scanchor {
namespace {

Json class_rows(const Score& score) {
  Json rows = Json::array();
  for (std::size_t id = 0; id < score.objects.classes.size(); ++id) {
    const ObjectCounts& counts = score.objects.classes[id];
    if (counts.truths + counts.claims() == 0) continue;
    Json row = Json::object();
    row["class"] = id;
    row["there"] = counts.truths;
    row["found"] = counts.found;
    row["wrong"] = counts.wrong;
    row["repeated"] = counts.repeated;
    if (counts.claims() > 0) row["precision"] = counts.precision();
    if (counts.truths > 0) row["recall"] = counts.recall();
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Rows and columns of the classes that are there; counts of points.
Json confusion(const PointScore& points) {
  Json json = Json::object();
  std::vector<std::size_t> used;
  for (std::size_t c = 0; c < points.classes; ++c) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < points.classes; ++k) sum += points.at(c, k) + points.at(k, c);
    if (sum > 0) used.push_back(c);
  }
  Json rows = Json::array();
  for (const std::size_t t : used) {
    Json row = Json::array();
    for (const std::size_t p : used) row.push_back(points.at(t, p));
    rows.push_back(std::move(row));
  }
  json["classes"] = used;
  json["counts"] = std::move(rows);
  return json;
}

Json reliability(const LabelScore& labels) {
  Json rows = Json::array();
  for (const ReliabilityPoint& point : reliability_points(labels)) {
    Json row = Json::object();
    row["stated"] = point.stated;
    row["right"] = point.right;
    row["low"] = point.low;
    row["high"] = point.high;
    row["count"] = std::int64_t(point.count);
    rows.push_back(std::move(row));
  }
  return rows;
}

Json metric_rows(const Json& score, const Json* baseline) {
  Json rows = Json::array();
  if (!score.contains("metrics")) return rows;
  for (const auto& [name, value] : score.at("metrics").items()) {
    if (!value.is_number()) continue;
    Json row = Json::object();
    row["name"] = name;
    row["value"] = value;
    if (baseline != nullptr && baseline->contains("metrics") &&
        baseline->at("metrics").contains(name) && baseline->at("metrics").at(name).is_number()) {
      row["before"] = baseline->at("metrics").at(name);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Json report_data(const Json& summary, const Json* baseline, const std::string& file) {
  const JsonReader reader(summary, file);
  const Score score = score_from_json(reader.at("score").raw(), file);
  Json data = Json::object();
  const auto suite = reader.at("suite");
  data["suite"] = suite.has("name") ? suite.at("name").text() : "run";
  data["protocol"] = score.protocol;
  Json classes = Json::array();
  for (const ClassInfo& info : class_list()) {
    classes.push_back(Json::array({info.name, hex(color_of_class(info.id)), info.thing}));
  }
  data["classes"] = std::move(classes);
  const Json* before = nullptr;
  if (baseline != nullptr) {
    const JsonReader other(*baseline, "baseline");
    before = &other.at("score").raw();
    require_comparable(score, score_from_json(*before, "baseline"));
  }
  data["metrics"] = metric_rows(reader.at("score").raw(), before);
  data["by_class"] = class_rows(score);
  data["confusion"] = confusion(score.points);
  data["reliability"] = reliability(score.labels);
  const ObjectCounts total = score.objects.total();
  data["there"] = total.truths;
  data["found"] = total.found;
  data["claims"] = total.claims();
  data["ignored"] = score.objects.ignored;
  data["not_described"] = score.objects.not_described;
  const auto rooms = reader.at("rooms");
  Json scenes = Json::array();
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const auto room = rooms.at(i);
    Json scene = Json::object();
    for (const char* key :
         {"name", "family", "seed", "points", "surfaces", "found", "there", "seconds"}) {
      if (room.has(key)) scene[key] = room.at(key).raw();
    }
    // A seed has 64 bits, a number in a browser 53: as text it stays the one that makes the room.
    if (scene.contains("seed") && scene["seed"].is_number_integer())
      scene["seed"] = scene["seed"].dump();
    scenes.push_back(std::move(scene));
  }
  data["scenes"] = std::move(scenes);
  return data;
}

std::string report_sentence(const Json& data) {
  const auto number = [&](const char* key) { return data.at(key).get<std::int64_t>(); };
  const std::size_t rooms = data.at("scenes").size();
  const auto share = [](std::int64_t part, std::int64_t whole) {
    return whole > 0 ? fmt::format(" ({:.0f} %)", 100.0 * double(part) / double(whole)) : "";
  };
  return fmt::format("Of {} things in {} {}, {} were found{}; of {} claims, {} were right{}.",
                     number("there"), rooms, rooms == 1 ? "room" : "rooms", number("found"),
                     share(number("found"), number("there")), number("claims"), number("found"),
                     share(number("found"), number("claims")));
}

}  // namespace scanchor
