#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/text.hpp"
#include "sensors/suite.hpp"

namespace scanchor {
namespace {

const std::vector<std::string> known_keys = {"name",     "text", "seed", "scenes", "scans", "split",
                                             "families", "vary", "room", "settle", "lidar"};

class SuiteReader {
 public:
  SuiteReader(std::string file) : file_(std::move(file)) {}

  Suite read(const std::string& yaml) {
    YAML::Node root;
    try {
      root = YAML::Load(yaml);
    } catch (const YAML::Exception& error) {
      fail_data(file_, fmt::format("line {}", error.mark.line + 1),
                "is no valid YAML: " + error.msg);
    }
    if (!root.IsMap()) fail(root, "a suite is a map of keys to values");
    suite_.describe(options_);
    for (const auto& [key, value] : entries(root)) take(key, value);
    for (const auto& item : late_) set_option(item.first, item.second);
    for (const auto& [node, variation] : variations_) check(node, variation);
    try {
      check_lidar_options(suite_.lidar);
    } catch (const Error& error) {
      fail_data(file_, "lidar", error.what());
    }
    return suite_;
  }

 private:
  using Entries = std::vector<std::pair<YAML::Node, YAML::Node>>;

  [[noreturn]] void fail(const YAML::Node& node, const std::string& cause,
                         const std::string& remedy = "") const {
    const int line = node.Mark().line;
    fail_data(file_, line >= 0 ? fmt::format("line {}", line + 1) : "", cause, remedy);
  }

  /// The entries of a map; no key may come twice.
  Entries entries(const YAML::Node& map) const {
    Entries list;
    std::set<std::string> seen;
    for (const auto& entry : map) {
      if (!entry.first.IsScalar()) fail(entry.first, "a key must be a word");
      if (!seen.insert(entry.first.Scalar()).second)
        fail(entry.first, fmt::format("the key '{}' comes twice", entry.first.Scalar()));
      list.emplace_back(entry.first, entry.second);
    }
    return list;
  }

  std::string word(const YAML::Node& node, const std::string& key) const {
    if (!node.IsScalar()) fail(node, fmt::format("{} must be a single value", key));
    return node.Scalar();
  }

  double number(const YAML::Node& node, const std::string& key, double minimum,
                double maximum) const {
    double value = 0.0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) ||
        !(value >= minimum && value <= maximum)) {
      fail(node, fmt::format("{} must be a number from {} to {}", key, minimum, maximum));
    }
    return value;
  }

  int whole(const YAML::Node& node, const std::string& key, int minimum, int maximum) const {
    const double value = number(node, key, minimum, maximum);
    if (value != std::floor(value)) fail(node, fmt::format("{} must be a whole number", key));
    return static_cast<int>(value);
  }

  void take(const YAML::Node& key_node, const YAML::Node& value) {
    const std::string key = key_node.Scalar();
    if (key == "name") {
      suite_.name = word(value, key);
    } else if (key == "text") {
      suite_.text = word(value, key);
    } else if (key == "seed") {
      std::uint64_t seed = 0;
      if (!value.IsScalar() || value.Scalar().find('-') != std::string::npos ||
          !YAML::convert<std::uint64_t>::decode(value, seed)) {
        fail(value, "seed must be a whole number from 0 to 2^64 - 1");
      }
      suite_.seed = seed;
    } else if (key == "scenes") {
      suite_.scenes = whole(value, key, 1, 10'000'000);
    } else if (key == "scans") {
      suite_.scans = whole(value, key, 1, 10'000);
    } else if (key == "split") {
      take_split(value);
    } else if (key == "families") {
      take_families(value);
    } else if (key == "vary") {
      take_variations(value);
    } else if (key == "room" || key == "settle" || key == "lidar" || key.starts_with("room.") ||
               key.starts_with("settle.") || key.starts_with("lidar.")) {
      flatten(key, key_node, value);
    } else {
      fail(key_node, fmt::format("unknown key '{}'", key), suggestion(key, known_keys));
    }
  }

  void take_split(const YAML::Node& map) {
    if (!map.IsMap()) fail(map, "split must be a map of train, valid and test to shares");
    suite_.split = {0.0, 0.0, 0.0};
    for (const auto& [key, value] : entries(map)) {
      const std::string part = key.Scalar();
      double* share = part == "train"   ? &suite_.split.train
                      : part == "valid" ? &suite_.split.valid
                      : part == "test"  ? &suite_.split.test
                                        : nullptr;
      if (share == nullptr)
        fail(key, fmt::format("unknown part '{}'", part),
             suggestion(part, {"train", "valid", "test"}));
      *share = number(value, part, 0.0, 1e9);
    }
    if (suite_.split.train + suite_.split.valid + suite_.split.test <= 0.0)
      fail(map, "split has no share above 0");
  }

  void take_families(const YAML::Node& map) {
    if (!map.IsMap() || map.size() == 0) fail(map, "families must be a map of names to weights");
    suite_.families.clear();
    double sum = 0.0;
    for (const auto& [key, value] : entries(map)) {
      const auto& known = room_families();
      if (std::find(known.begin(), known.end(), key.Scalar()) == known.end()) {
        fail(key, fmt::format("unknown family '{}'", key.Scalar()),
             suggestion(key.Scalar(), known));
      }
      suite_.families.emplace_back(key.Scalar(), number(value, key.Scalar(), 0.0, 1e9));
      sum += suite_.families.back().second;
    }
    if (sum <= 0.0) fail(map, "no family has a weight above 0");
  }

  void take_variations(const YAML::Node& map) {
    if (!map.IsMap()) fail(map, "vary must be a map of options to [minimum, maximum]");
    for (const auto& [key, value] : entries(map)) {
      if (!value.IsSequence() || value.size() != 2)
        fail(value, fmt::format("{} must be [minimum, maximum]", key.Scalar()));
      Variation variation{key.Scalar(), number(value[0], key.Scalar(), -1e300, 1e300),
                          number(value[1], key.Scalar(), -1e300, 1e300)};
      if (variation.minimum > variation.maximum)
        fail(value, fmt::format("{}: the minimum is above the maximum", key.Scalar()));
      suite_.vary.push_back(variation);
      variations_.emplace_back(key, variation);
    }
  }

  /// `lidar: {a: {b: 1}}` and `lidar.a.b: 1` are the same.
  void flatten(const std::string& name, const YAML::Node& key, const YAML::Node& value) {
    if (value.IsMap()) {
      for (const auto& [inner, inner_value] : entries(value)) {
        flatten(name + "." + inner.Scalar(), inner, inner_value);
      }
      return;
    }
    if (name.find('.') == std::string::npos)
      fail(value, fmt::format("{} must be a map of options to values", name));
    if (!value.IsScalar()) fail(value, fmt::format("{} must be a single value", name));
    if (name == "room.family")
      fail(key, "the family of a room comes from the suite's families",
           "write families: {office: 1}");
    if (name == "lidar.preset") {  // the base that all other options of the sensor change
      guard(value, [&] { suite_.lidar = lidar_preset(value.Scalar()); });
      return;
    }
    late_.emplace_back(name, value);
  }

  void set_option(const std::string& name, const YAML::Node& value) {
    guard(value, [&] { options_.set(name, value.Scalar()); });
  }

  /// Both ends of a variation must be values that the option takes.
  void check(const YAML::Node& node, const Variation& variation) {
    guard(node, [&] {
      Suite copy = suite_;
      OptionList list;
      copy.describe(list);
      const std::string before = list.get(variation.option);
      const auto option = std::find_if(list.options().begin(), list.options().end(),
                                       [&](const Option& o) { return o.name == variation.option; });
      if (!std::holds_alternative<double*>(option->value) &&
          !std::holds_alternative<int*>(option->value)) {
        fail(node, fmt::format("{} is no number and cannot be varied", variation.option));
      }
      list.set(variation.option, fmt::format("{}", variation.minimum));
      list.set(variation.option, fmt::format("{}", variation.maximum));
    });
  }

  /// Wrong usage inside a suite is bad data of the suite's file.
  template <class Body>
  void guard(const YAML::Node& node, Body&& body) {
    try {
      body();
    } catch (const Error& error) {
      if (error.code() == ExitCode::bad_data) throw;
      fail(node, error.what());
    }
  }

  std::string file_;
  Suite suite_;
  OptionList options_;
  std::vector<std::pair<std::string, YAML::Node>> late_;  ///< options, set once the preset is known
  std::vector<std::pair<YAML::Node, Variation>> variations_;
};

}  // namespace

Suite parse_suite(const std::string& yaml, const std::string& file) {
  return SuiteReader(file).read(yaml);
}

Suite read_suite(const std::filesystem::path& path) {
  const std::string yaml = read_file(path);
  if (yaml.empty()) fail_data(path.string(), "", "is empty, a suite was expected");
  return parse_suite(yaml, path.string());
}

nlohmann::ordered_json suite_to_json(const Suite& suite) {
  Suite copy = suite;
  OptionList list;
  copy.describe(list);
  Json options = list.to_json();
  options["room"].erase("family");
  Json families = Json::object();
  for (const auto& [name, weight] : suite.families) families[name] = weight;
  Json vary = Json::object();
  for (const auto& v : suite.vary) vary[v.option] = {v.minimum, v.maximum};
  Json json = {
      {"name", suite.name},
      {"text", suite.text},
      {"seed", suite.seed},
      {"scenes", suite.scenes},
      {"scans", suite.scans},
      {"split",
       {{"train", suite.split.train}, {"valid", suite.split.valid}, {"test", suite.split.test}}},
      {"families", families},
      {"vary", vary}};
  json.update(options);
  return json;
}

}  // namespace scanchor
