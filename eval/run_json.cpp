#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "eval/run.hpp"

namespace scanchor {
namespace {

Json times_out(const StageTimes& times) {
  Json json = Json::object();
  json["generate"] = times.generate;
  json["settle"] = times.settle;
  json["scan"] = times.scan;
  json["perceive"] = times.perceive;
  json["reason"] = times.reason;
  json["score"] = times.score;
  return json;
}

StageTimes times_in(const JsonReader& reader) {
  StageTimes times;
  times.generate = reader.at("generate").number();
  times.settle = reader.at("settle").number();
  times.scan = reader.at("scan").number();
  times.perceive = reader.at("perceive").number();
  times.reason = reader.at("reason").number();
  times.score = reader.at("score").number();
  return times;
}

}  // namespace

std::string data_stamp(const Suite& suite, const std::string& split) {
  Json json = suite_to_json(suite);
  json.erase("scenes");
  return suite.name + "/" + (split.empty() ? "all" : split) + " (" +
         sha256(json.dump()).substr(0, 16) + ")";
}

Json run_to_json(const RunResult& result, bool with_times) {
  Json json = Json::object();
  json["format"] = "scanchor-run";
  json["schema"] = 1;
  json["suite"] = result.suite;
  json["data"] = result.data;
  json["method"] = result.method;
  json["protocol_stamp"] = protocol_stamp(result.protocol);
  json["protocol"] = protocol_to_text(result.protocol);
  if (with_times) {
    Json timing = Json::object();
    timing["wall_seconds"] = result.wall_seconds;
    timing["peak_memory_mb"] = result.peak_memory_mb;
    timing["stages"] = times_out(result.times);
    json["timing"] = std::move(timing);
  }
  json["pooled"] = score_to_json(result.pooled, result.protocol);
  Json rows = Json::array();
  for (const auto& row : result.rows) {
    Json one = Json::object();
    one["index"] = row.index;
    one["name"] = row.name;
    one["split"] = row.split;
    one["family"] = row.family;
    one["seed"] = row.seed;
    one["problem"] = row.problem;
    if (!row.scan_hash.empty()) one["scan_hash"] = row.scan_hash;
    if (with_times) one["stages"] = times_out(row.times);
    one["score"] = score_to_json(row.score, result.protocol);
    one["score"].erase("metrics");
    rows.push_back(std::move(one));
  }
  json["scenes"] = std::move(rows);
  return json;
}

RunResult run_from_json(const Json& json, const std::string& file) {
  const JsonReader reader(json, file);
  if (!reader.has("format") || reader.at("format").text() != "scanchor-run") {
    reader.fail("is no run", "'scanchor check SUITE --json' writes one");
  }
  if (reader.at("schema").integer() != 1)
    reader.at("schema").fail("is of another version of the format");
  RunResult result;
  result.suite = reader.at("suite").text();
  result.data = reader.at("data").text();
  result.method = reader.at("method").text();
  result.protocol = protocol_from_text(reader.at("protocol").text(), file + ": protocol");
  if (protocol_stamp(result.protocol) != reader.at("protocol_stamp").text()) {
    reader.at("protocol_stamp")
        .fail("does not belong to the protocol in the file", "one of the two was edited");
  }
  if (reader.has("timing")) {
    const auto timing = reader.at("timing");
    result.wall_seconds = timing.at("wall_seconds").number();
    result.peak_memory_mb = timing.at("peak_memory_mb").number();
  }
  const auto rows = reader.at("scenes");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto one = rows.at(i);
    SceneRow row;
    row.index = static_cast<int>(one.at("index").integer());
    row.name = one.at("name").text();
    row.split = one.at("split").text();
    row.family = one.at("family").text();
    row.seed = one.at("seed").raw().get<std::uint64_t>();
    row.problem = one.at("problem").text();
    if (one.has("scan_hash")) row.scan_hash = one.at("scan_hash").text();
    if (one.has("stages")) row.times = times_in(one.at("stages"));
    row.score =
        score_from_json(one.at("score").raw(), file + ": scenes[" + std::to_string(i) + "]");
    result.times.add(row.times);
    if (row.score.data != result.data) one.fail("is of other data than the run");
    result.pooled.add(row.score);
    result.rows.push_back(std::move(row));
  }
  if (result.pooled != score_from_json(reader.at("pooled").raw(), file + ": pooled")) {
    reader.at("pooled").fail("is not the sum of the scenes", "the file was edited or cut");
  }
  return result;
}

}  // namespace scanchor
