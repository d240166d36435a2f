#include "eval/baseline.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"

namespace scanchor {
namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

int words_in(const std::string& text) {
  int words = 0;
  bool inside = false;
  for (const char c : text) {
    const bool letter = c != ' ' && c != '\t' && c != '\n';
    words += letter && !inside ? 1 : 0;
    inside = letter;
  }
  return words;
}

// One line a scene: small enough for a repository, and a difference shows which scenes moved.
std::string lines_of(const Json& run) {
  std::string text = "{";
  for (const auto& [key, value] : run.items()) {
    text += (text.size() > 1 ? ",\n  " : "\n  ") + Json(key).dump() + ": ";
    if (key != "scenes") {
      text += value.dump();
      continue;
    }
    text += "[";
    for (std::size_t i = 0; i < value.size(); ++i)
      text += (i == 0 ? "\n    " : ",\n    ") + value[i].dump();
    text += "\n  ]";
  }
  return text + "\n}";
}

}  // namespace

std::vector<std::string> describe_change(const RunResult& before, const RunResult& after) {
  std::vector<std::string> lines;
  if (before.data != after.data) lines.push_back("data: " + before.data + " -> " + after.data);
  if (protocol_stamp(before.protocol) != protocol_stamp(after.protocol)) {
    lines.push_back("protocol: " + protocol_stamp(before.protocol) + " -> " +
                    protocol_stamp(after.protocol));
  }
  if (before.method != after.method)
    lines.push_back("method: " + before.method + " -> " + after.method);
  std::set<int> old_scenes, new_scenes;
  for (const auto& row : before.rows) old_scenes.insert(row.index);
  for (const auto& row : after.rows) new_scenes.insert(row.index);
  if (old_scenes != new_scenes)
    lines.push_back("scenes: " + std::to_string(old_scenes.size()) + " -> " +
                    std::to_string(new_scenes.size()));
  std::map<std::string, double> old;
  for (const auto& [name, value] : metrics(before.pooled, before.protocol)) old[name] = value;
  for (const auto& [name, value] : metrics(after.pooled, after.protocol)) {
    const auto found = old.find(name);
    if (found == old.end()) {
      lines.push_back(name + ": new, " + number(value));
    } else if (number(found->second) != number(value)) {
      lines.push_back(name + ": " + number(found->second) + " -> " + number(value));
    }
    if (found != old.end()) old.erase(found);
  }
  for (const auto& [name, value] : old) lines.push_back(name + ": gone, was " + number(value));
  return lines;
}

Baseline update_baseline(const Baseline& old, RunResult run, const std::string& reason,
                         const std::string& date) {
  if (words_in(reason) < 3)
    fail_usage("a baseline changes for a reason",
               "say it in at least three words: --reason \"...\"");
  Baseline next = old;
  BaselineChange change{date, reason, {}};
  if (!old.run.rows.empty()) {
    change.changes = describe_change(old.run, run);
    if (change.changes.empty()) fail_usage("nothing changed: the baseline stays as it is");
  }
  next.history.push_back(std::move(change));
  next.run = std::move(run);
  return next;
}

void write_baseline(const std::filesystem::path& path, const Baseline& baseline) {
  Json json = Json::object();
  json["format"] = "scanchor-baseline";
  json["schema"] = 1;
  Json history = Json::array();
  for (const auto& change : baseline.history) {
    Json one = Json::object();
    one["date"] = change.date;
    one["reason"] = change.reason;
    one["changes"] = change.changes;
    history.push_back(std::move(one));
  }
  json["history"] = std::move(history);
  if (path.has_parent_path()) make_folder(path.parent_path());
  write_file(path, "{\n\"format\": " + json["format"].dump() + ",\n\"schema\": " +
                       json["schema"].dump() + ",\n\"history\": " + json["history"].dump(1) +
                       ",\n\"run\": " + lines_of(run_to_json(baseline.run, false)) + "\n}\n");
}

Baseline read_baseline(const std::filesystem::path& path) {
  const Json json = read_json(path);
  const JsonReader reader(json, path.string());
  if (!reader.has("format") || reader.at("format").text() != "scanchor-baseline") {
    reader.fail("is no baseline", "'scanchor baseline update' writes one");
  }
  Baseline baseline;
  const auto history = reader.at("history");
  for (std::size_t i = 0; i < history.size(); ++i) {
    const auto one = history.at(i);
    BaselineChange change{one.at("date").text(), one.at("reason").text(), {}};
    const auto lines = one.at("changes");
    for (std::size_t k = 0; k < lines.size(); ++k) change.changes.push_back(lines.at(k).text());
    baseline.history.push_back(std::move(change));
  }
  baseline.run = run_from_json(reader.at("run").raw(), path.string() + ": run");
  return baseline;
}

}  // namespace scanchor
