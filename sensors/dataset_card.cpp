#include "sensors/dataset_card.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/version.hpp"

namespace scanchor {
namespace {

constexpr const char* flag_names[] = {"mixed", "ghost", "behind_glass", "out_of_range"};

Json file_json(const FileRecord& record) {
  return {{"bytes", record.bytes}, {"sha256", record.sha256}};
}

Json classes_json(const std::map<std::int32_t, ClassCount>& classes) {
  Json list = Json::array();
  for (const auto& [id, count] : classes) {
    list.push_back({{"id", id},
                    {"name", class_info(id).name},
                    {"points", count.points},
                    {"instances", count.instances},
                    {"scenes", count.scenes}});
  }
  return list;
}

Json formats_json(const DatasetFormats& formats) {
  Json list = {"semantic-kitti"};
  if (formats.truth) list.push_back("truth");
  if (formats.pcd) list.push_back("pcd");
  if (formats.ply) list.push_back("ply");
  if (formats.s3dis) list.push_back("s3dis");
  return list;
}

/// Sums over sequences.
SequenceCard total_of(const std::vector<SequenceCard>& cards) {
  SequenceCard total;
  for (const auto& card : cards) {
    for (const auto& [id, count] : card.classes) {
      auto& sum = total.classes[id];
      sum.points += count.points;
      sum.instances += count.instances;
      sum.scenes += count.scenes;
    }
    for (std::size_t k = 0; k < card.flagged.size(); ++k) total.flagged[k] += card.flagged[k];
    total.scan_points.insert(total.scan_points.end(), card.scan_points.begin(),
                             card.scan_points.end());
    total.files.insert(card.files.begin(), card.files.end());
  }
  return total;
}

std::uint64_t sum(const std::vector<std::uint64_t>& values) {
  std::uint64_t total = 0;
  for (const auto value : values) total += value;
  return total;
}

}  // namespace

void write_sequence_card(const std::filesystem::path& path, const SequenceCard& card) {
  Json scans = Json::array();
  for (std::size_t k = 0; k < card.scan_seeds.size(); ++k) {
    scans.push_back({{"seed", card.scan_seeds[k]},
                     {"points", card.scan_points[k]},
                     {"beams", card.scan_beams[k]}});
  }
  Json flagged = Json::object();
  for (std::size_t k = 0; k < card.flagged.size(); ++k) flagged[flag_names[k]] = card.flagged[k];
  Json files = Json::object();
  for (const auto& [name, record] : card.files) files[name] = file_json(record);
  write_json(path, {{"name", card.name},
                    {"split", card.split},
                    {"family", card.family},
                    {"seed", card.seed},
                    {"tries", card.tries},
                    {"complete", card.complete},
                    {"settled", card.settled},
                    {"problems", card.problems},
                    {"scans", scans},
                    {"classes", classes_json(card.classes)},
                    {"flagged_points", flagged},
                    {"files", files}});
}

SequenceCard read_sequence_card(const std::filesystem::path& path) {
  const Json json = read_json(path);
  const JsonReader reader(json, path.string());
  SequenceCard card;
  card.name = reader.at("name").text();
  card.split = reader.at("split").text();
  card.family = reader.at("family").text();
  card.seed = reader.at("seed").natural();
  card.tries = reader.at("tries").natural();
  card.complete = reader.at("complete").boolean();
  card.settled = reader.at("settled").boolean();
  const JsonReader problems = reader.at("problems");
  for (std::size_t i = 0; i < problems.size(); ++i) card.problems.push_back(problems.at(i).text());
  const JsonReader scans = reader.at("scans");
  for (std::size_t i = 0; i < scans.size(); ++i) {
    card.scan_seeds.push_back(scans.at(i).at("seed").natural());
    card.scan_points.push_back(scans.at(i).at("points").natural());
    card.scan_beams.push_back(scans.at(i).at("beams").natural());
  }
  const JsonReader classes = reader.at("classes");
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const JsonReader entry = classes.at(i);
    card.classes[static_cast<std::int32_t>(entry.at("id").integer())] = {
        entry.at("points").natural(), entry.at("instances").natural(),
        entry.at("scenes").natural()};
  }
  for (std::size_t k = 0; k < card.flagged.size(); ++k) {
    card.flagged[k] = reader.at("flagged_points").at(flag_names[k]).natural();
  }
  const JsonReader files = reader.at("files");
  for (const auto& name : files.keys()) {
    card.files[name] = {files.at(name).at("bytes").natural(), files.at(name).at("sha256").text()};
  }
  return card;
}

std::string suite_card(const Suite& suite, const DatasetFormats& formats) {
  Json json = {{"format", "scanchor data set 1"},
               {"version", scanchor_version},
               {"formats", formats_json(formats)},
               {"suite", suite_to_json(suite)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string label_map_yaml(const std::vector<SequenceCard>& cards, const std::string& name) {
  const SequenceCard total = total_of(cards);
  std::string title = name;  // stands in a comment: one line
  for (char& c : title) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  const double points = std::max<double>(1.0, static_cast<double>(sum(total.scan_points)));
  std::string yaml = fmt::format(
      "# Label map of the data set \"{}\", as semantic-kitti-api reads it. Colours are B, G, R.\n"
      "name: \"scanchor\"\nlabels:\n",
      title);
  for (const auto& info : class_list()) yaml += fmt::format("  {}: \"{}\"\n", info.id, info.name);
  yaml += "color_map:\n";
  for (const auto& info : class_list()) {
    yaml +=
        fmt::format("  {}: [{}, {}, {}]\n", info.id, info.color[2], info.color[1], info.color[0]);
  }
  yaml += "content:\n";
  for (const auto& info : class_list()) {
    const auto found = total.classes.find(info.id);
    const double count =
        found == total.classes.end() ? 0.0 : static_cast<double>(found->second.points);
    yaml += fmt::format("  {}: {}\n", info.id, count / points);
  }
  for (const char* map : {"learning_map", "learning_map_inv"}) {
    yaml += fmt::format("{}:\n", map);
    for (const auto& info : class_list()) yaml += fmt::format("  {}: {}\n", info.id, info.id);
  }
  yaml += "learning_ignore:\n";
  for (const auto& info : class_list())
    yaml += fmt::format("  {}: {}\n", info.id, info.id == unlabelled ? "True" : "False");
  yaml += "split:\n";
  for (const char* split : {"train", "valid", "test"}) {
    std::string list;
    for (const auto& card : cards) {
      // A number without leading zeros: YAML 1.1 would read 010 as eight.
      if (card.split == split)
        list += fmt::format("{}{}", list.empty() ? "" : ", ", std::stoul(card.name));
    }
    yaml += fmt::format("  {}: [{}]\n", split, list);
  }
  return yaml;
}

void write_dataset_card(const std::filesystem::path& root, const Suite& suite,
                        const DatasetFormats& formats, const std::vector<SequenceCard>& cards) {
  const std::string map = label_map_yaml(cards, suite.name);
  write_file(root / "label_map.yaml", map);
  SequenceCard total = total_of(cards);
  const std::string suite_text = suite_card(suite, formats);
  total.files["label_map.yaml"] = {map.size(), sha256(map)};
  total.files["suite.json"] = {suite_text.size(), sha256(suite_text)};
  Json splits = Json::object(), families = Json::object(), files = Json::object(),
       flagged = Json::object();
  for (const char* split : {"train", "valid", "test"}) splits[split] = Json::array();
  Json not_at_rest = Json::array(), not_complete = Json::array(), made_anew = Json::object();
  for (const auto& card : cards) {
    splits[card.split].push_back(card.name);
    families[card.family] = families.value(card.family, 0) + 1;
    if (!card.settled) not_at_rest.push_back(card.name);
    if (!card.complete) not_complete.push_back(card.name);
    if (card.tries > 1) made_anew[card.name] = card.tries;
  }
  for (std::size_t k = 0; k < total.flagged.size(); ++k) flagged[flag_names[k]] = total.flagged[k];
  for (const auto& [name, record] : total.files) files[name] = file_json(record);
  Json json = Json::parse(suite_text);
  json.update({{"scenes", cards.size()},
               {"scans", total.scan_points.size()},
               {"points", sum(total.scan_points)},
               {"split", splits},
               {"families", families},
               {"scenes_made_anew", made_anew},
               {"scenes_not_complete", not_complete},
               {"scenes_not_at_rest", not_at_rest},
               {"classes", classes_json(total.classes)},
               {"flagged_points", flagged},
               {"files", files}});
  write_json(root / "dataset.json", json);
}

}  // namespace scanchor
