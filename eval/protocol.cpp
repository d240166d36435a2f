#include "eval/protocol.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "scenes/classes.hpp"

namespace scanchor {
namespace {

constexpr const char* flag_words[] = {"mixed", "ghost", "behind_glass", "out_of_range"};

std::string place(const YAML::Node& node) { return fmt::format("line {}", node.Mark().line + 1); }

double number_of(const YAML::Node& node, const std::string& file, const std::string& key) {
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) {
    fail_data(file, place(node), fmt::format("{}: must be a number", key));
  }
  return value;
}

std::vector<double> thresholds_of(const YAML::Node& node, const std::string& file,
                                  const std::string& key, double low) {
  if (!node.IsSequence() || node.size() == 0 || node.size() > 30) {
    fail_data(file, place(node), fmt::format("{}: must be a list of 1 to 30 numbers", key));
  }
  std::vector<double> values;
  for (const auto& item : node) {
    const double value = number_of(item, file, key);
    if (!(value > low && value <= 1.0) || (!values.empty() && value <= values.back())) {
      fail_data(
          file, place(item),
          fmt::format("{}: must rise and lie above {} and at most at 1, is {}", key, low, value));
    }
    values.push_back(value);
  }
  return values;
}

std::string class_of(const YAML::Node& node, const std::string& file, const std::string& key) {
  std::string word;
  if (!node.IsScalar() || (word = node.Scalar()).empty()) {
    fail_data(file, place(node), fmt::format("{}: must be the name of a class", key));
  }
  if (!find_class(word)) {
    std::vector<std::string> names;
    for (const auto& info : class_list()) names.emplace_back(info.name);
    fail_data(file, place(node), fmt::format("{}: '{}' is no class", key, word),
              suggestion(word, names));
  }
  return word;
}

void read_flags(const YAML::Node& node, const std::string& file, Protocol& protocol) {
  if (!node.IsSequence()) fail_data(file, place(node), "ignore_flags: must be a list");
  protocol.ignore_flags.clear();
  for (const auto& item : node) {
    const std::string word = item.IsScalar() ? item.Scalar() : "";
    const std::vector<std::string> known(std::begin(flag_words), std::end(flag_words));
    if (std::find(known.begin(), known.end(), word) == known.end()) {
      fail_data(file, place(item), fmt::format("ignore_flags: '{}' is no flag", word),
                suggestion(word, known));
    }
    protocol.ignore_flags.push_back(word);
  }
}

Protocol builtin(const std::string& name) {
  Protocol p;
  if (name == "scanchor-1") return p;
  p.name = name;
  p.version = 1;
  p.merge = {};
  p.ignore_flags = {"ghost", "out_of_range"};
  p.min_visible = 0.0;
  if (name == "coco") {
    p.min_points = 0;
  } else if (name == "semantickitti") {
    p.absent_class = "zero";
    p.min_points = 50;
    p.small = "unpunished";
    p.void_points = "remove";
    p.merge_stuff = false;
    p.no_instance = "segment";
  } else {
    p.min_points = 100;
    p.average_precision = "scannet";
    p.ap_thresholds = {0.5, 0.55, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9};
  }
  return p;
}

template <class Range>
std::string list_text(const Range& values) {
  std::string text;
  for (const auto& value : values) text += fmt::format("{}{}", text.empty() ? "" : ", ", value);
  return "[" + text + "]";
}

}  // namespace

void Protocol::describe(OptionList& list) {
  list.add("version", version, "", "raised when a rule changes", 1, 1000000);
  list.add("absent_class", absent_class, "class in neither truth nor prediction", {"skip", "zero"});
  list.add("min_points", min_points, "points", "a thing with fewer points of truth is small", 0,
           1e9);
  list.add("min_visible", min_visible, "1", "a thing less of whose faces was seen is ignored", 0,
           1);
  list.add("large_face", large_face, "1", "share of a thing's largest face that makes a large face",
           0, 1);
  list.add("min_face_points", min_face_points, "points", "a large face with fewer is not seen", 0,
           1e9);
  list.add("small", small, "what becomes of small things", {"ignore", "unpunished"});
  list.add("match_iou", match_iou, "1", "a match has a larger intersection over union", 0.5, 1);
  list.add("void_points", void_points, "predicted points without truth", {"subtract", "remove"});
  list.add("merge_stuff", merge_stuff, "all predicted points of a stuff class are one segment");
  list.add("no_instance", no_instance, "points of things without an instance", {"drop", "segment"});
  list.add("average_precision", average_precision, "matching and area", {"coco", "scannet"});
  list.add("plane_min_points", plane_min_points, "points", "smaller planes are ignored", 0, 1e9);
  list.add("plane_min_visible", plane_min_visible, "1", "planes seen less are ignored", 0, 1);
  list.add("plane_merge_angle_deg", plane_merge_angle_deg, "deg",
           "faces nearer than that in angle,", 0, 10);
  list.add("plane_merge_offset", plane_merge_offset, "m", "in step, and", 0, 1);
  list.add("plane_merge_gap", plane_merge_gap, "m", "in gap are one plane", 0, 10);
  list.add("small_plane_share", small_plane_share, "1",
           "share of the scan below which a plane is small", 0, 1);
  list.add("geometry_tolerance", geometry_tolerance, "1", "Hoover's T for geometry", 0.5, 1);
  list.add("full_view", full_view, "1", "visible fraction from which sizes are compared", 0, 1);
  list.add("object_purity", object_purity, "1",
           "share of a claim that lies on the thing, more than", 0.5, 1);
  list.add("object_coverage", object_coverage, "1", "share of the thing in the claim, at least", 0,
           1);
  list.add("calibration_bins", calibration_bins, "", "of the expected calibration error", 1, 1000);
}

const std::vector<std::string>& builtin_protocols() {
  static const std::vector<std::string> names = {"scanchor-1", "coco", "semantickitti", "scannet"};
  return names;
}

Protocol find_protocol(const std::string& name_or_path) {
  const auto& names = builtin_protocols();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end())
    return builtin(name_or_path);
  const auto ending = std::filesystem::path(name_or_path).extension();
  if (ending == ".yaml" || ending == ".yml" || ending == ".json")
    return read_protocol(name_or_path);
  fail_usage(fmt::format("unknown protocol '{}'", name_or_path),
             suggestion(name_or_path, names) + ", or a file that ends in .yaml");
}

Protocol read_protocol(const std::filesystem::path& path) {
  return protocol_from_text(read_file(path), path.string());
}

Protocol protocol_from_text(const std::string& text, const std::string& file) {
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    fail_data(file, fmt::format("line {}", error.mark.line + 1), error.msg);
  }
  if (!root.IsMap())
    fail_data(file, "", "is no protocol", "write 'name: ...' and the rules below it");
  Protocol protocol;
  if (const YAML::Node base = root["base"]) {
    const auto& names = builtin_protocols();
    const std::string word = base.IsScalar() ? base.Scalar() : "";
    if (std::find(names.begin(), names.end(), word) == names.end()) {
      fail_data(file, place(base), fmt::format("base: '{}' is no built-in protocol", word),
                suggestion(word, names));
    }
    protocol = builtin(word);
  }
  if (!root["name"] || !root["name"].IsScalar() || root["name"].Scalar().empty()) {
    fail_data(file, "", "'name' is missing",
              "a protocol needs a name that results are stamped with");
  }
  OptionList list;
  protocol.describe(list);
  std::vector<std::string> known = {"base",         "name",          "classes",         "merge",
                                    "ignore_flags", "ap_thresholds", "plane_tolerances"};
  for (const auto& option : list.options()) known.push_back(option.name);
  for (const auto& entry : root) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const YAML::Node& value = entry.second;
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      fail_data(file, place(entry.first), fmt::format("unknown key '{}'", key),
                suggestion(key, known));
    }
    if (key == "base") continue;
    if (key == "name") {
      protocol.name = value.Scalar();
    } else if (key == "classes") {
      if (!value.IsSequence()) fail_data(file, place(value), "classes: must be a list of names");
      protocol.classes.clear();
      for (const auto& item : value) protocol.classes.push_back(class_of(item, file, key));
    } else if (key == "merge") {
      if (!value.IsMap())
        fail_data(file, place(value), "merge: must be 'class: class it counts as'");
      protocol.merge.clear();
      for (const auto& pair : value) {
        protocol.merge.emplace_back(class_of(pair.first, file, key),
                                    class_of(pair.second, file, key));
      }
    } else if (key == "ignore_flags") {
      read_flags(value, file, protocol);
    } else if (key == "ap_thresholds") {
      protocol.ap_thresholds = thresholds_of(value, file, key, 0.0);
    } else if (key == "plane_tolerances") {
      protocol.plane_tolerances = thresholds_of(value, file, key, 0.5);
    } else {
      if (!value.IsScalar())
        fail_data(file, place(value), fmt::format("{}: must be one value", key));
      try {
        list.set(key, value.Scalar());
      } catch (const Error& error) {
        fail_data(file, place(value), error.what());
      }
    }
  }
  return protocol;
}

namespace {

/// `newer`: also keys that came after the first stored runs and are as if they had not.
std::string protocol_text(const Protocol& protocol, bool newer) {
  Protocol copy = protocol;
  OptionList list;
  copy.describe(list);
  const Protocol plain;
  const auto as_before = [&](const std::string& key) {
    return (key == "large_face" && protocol.large_face == plain.large_face) ||
           (key == "min_face_points" && protocol.min_face_points == plain.min_face_points);
  };
  std::string text = fmt::format("name: \"{}\"\n", protocol.name);
  text += fmt::format("classes: {}  # empty: all\n", list_text(protocol.classes));
  text += "merge: {";
  for (std::size_t i = 0; i < protocol.merge.size(); ++i) {
    text +=
        fmt::format("{}{}: {}", i ? ", " : "", protocol.merge[i].first, protocol.merge[i].second);
  }
  text += "}\n";
  text += fmt::format("ignore_flags: {}  # points with such a flag have no truth\n",
                      list_text(protocol.ignore_flags));
  text += fmt::format("ap_thresholds: {}\n", list_text(protocol.ap_thresholds));
  text += fmt::format("plane_tolerances: {}\n", list_text(protocol.plane_tolerances));
  for (const auto& option : list.options()) {
    if (!newer && as_before(option.name)) continue;
    text += fmt::format("{}: {}  # {}{}\n", option.name, list.get(option.name),
                        option.unit.empty() || option.unit == "1" ? "" : "[" + option.unit + "] ",
                        option.text);
  }
  return text;
}

}  // namespace

std::string protocol_to_text(const Protocol& protocol) { return protocol_text(protocol, true); }

void write_protocol(const std::filesystem::path& path, const Protocol& protocol) {
  write_file(path, protocol_to_text(protocol));
}

std::string protocol_hash(const Protocol& protocol) {
  return sha256(protocol_text(protocol, false)).substr(0, 16);
}

std::string protocol_stamp(const Protocol& protocol) {
  return fmt::format("{} v{} ({})", protocol.name, protocol.version, protocol_hash(protocol));
}

std::int32_t ClassRules::of(std::int32_t id) const {
  if (id < 0 || id >= static_cast<std::int32_t>(size())) return -1;
  const std::int32_t into = counted_as[static_cast<std::size_t>(id)];
  return scored[static_cast<std::size_t>(into)] ? into : -1;
}

ClassRules class_rules(const Protocol& protocol) {
  ClassRules rules;
  for (const auto& info : class_list()) {
    rules.names.emplace_back(info.name);
    rules.thing.push_back(info.thing ? 1 : 0);
    rules.counted_as.push_back(info.id);
    const bool named = std::find(protocol.classes.begin(), protocol.classes.end(), info.name) !=
                       protocol.classes.end();
    rules.scored.push_back(info.id != unlabelled && (protocol.classes.empty() || named) ? 1 : 0);
  }
  for (const auto& [from, into] : protocol.merge) {
    const auto source = find_class(from);
    const auto target = find_class(into);
    if (!source || !target)
      fail_data("protocol " + protocol.name, "merge",
                fmt::format("'{}: {}' names no class", from, into));
    rules.counted_as[static_cast<std::size_t>(*source)] = *target;
    rules.scored[static_cast<std::size_t>(*source)] = 0;
  }
  return rules;
}

}  // namespace scanchor
