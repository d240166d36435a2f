#include "eval/predictions.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "cloud/io.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "core/text.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;

void check_rows(const fs::path& path, std::size_t rows, std::size_t points) {
  if (rows == points) return;
  fail_data(
      path.string(), "",
      "has " + std::to_string(rows) + " rows, the scan has " + std::to_string(points) + " points",
      rows < points ? "every point needs a row, 0 where nothing is said"
                    : "is it the prediction of another scan?");
}

// Labels through the map, then held against the class list.
void map_labels(const fs::path& path, const PredictionOptions& options,
                std::vector<std::int32_t>& labels) {
  const std::map<std::int32_t, std::int32_t> map(options.label_map.begin(),
                                                 options.label_map.end());
  const auto classes = static_cast<std::int32_t>(class_list().size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::int32_t& label = labels[i];
    if (!map.empty()) {
      const auto found = map.find(label);
      if (found == map.end() && label > 0) {
        fail_data(path.string(), "point " + std::to_string(i),
                  "label " + std::to_string(label) + " is not in the label map");
      }
      label = found == map.end() ? unlabelled : found->second;
    } else if (label >= classes) {
      fail_data(path.string(), "point " + std::to_string(i),
                "label " + std::to_string(label) + " is not in the class list",
                "give the label map of the predictions with --label-map");
    }
    label = std::max(label, unlabelled);
  }
}

PointPrediction read_label_file(const fs::path& path, std::size_t points) {
  const std::string bytes = read_file(path);
  if (bytes.size() % 4 != 0) {
    fail_data(path.string(), "byte " + std::to_string(bytes.size()),
              "ends within a row: a .label file has 4 bytes a point");
  }
  check_rows(path, bytes.size() / 4, points);
  PointPrediction prediction;
  for (std::size_t i = 0; i < points; ++i) {
    std::uint32_t word = 0;
    for (std::size_t b = 0; b < 4; ++b)
      word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[4 * i + b])) << (8 * b);
    prediction.class_id.push_back(static_cast<std::int32_t>(word & 0xffffU));
    const auto instance = static_cast<std::int32_t>(word >> 16U);
    prediction.instance.push_back(instance == 0 ? -1 : instance);
  }
  return prediction;
}

std::vector<std::int32_t> whole_numbers(const fs::path& path, const Field& field) {
  std::vector<std::int32_t> values(field.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = field.at(i);
    if (!std::isfinite(value) || value != std::floor(value) || std::abs(value) > 2147483647.0) {
      // 4294967295 is how an unsigned field says -1.
      if (value == 4294967295.0) {
        values[i] = -1;
        continue;
      }
      fail_data(path.string(), "point " + std::to_string(i),
                "field '" + field.name + "' must hold whole numbers, is " + std::to_string(value));
    }
    values[i] = static_cast<std::int32_t>(value);
  }
  return values;
}

// Rows in another order cannot be told from labels; from positions they can. A file whose points
// are all zero carries none.
void check_positions(const fs::path& path, const PointCloud& cloud, const PointCloud& scan) {
  const bool carries = std::any_of(cloud.points.begin(), cloud.points.end(),
                                   [](const Eigen::Vector3d& p) { return p.norm() > 0.0; });
  for (std::size_t i = 0; carries && i < cloud.size(); ++i) {
    if (!scan.points[i].allFinite()) continue;
    // Formats keep floats or a few decimals.
    const double off = (cloud.points[i] - scan.points[i]).norm();
    if (off <= 1e-3 + 1e-5 * scan.points[i].norm()) continue;
    fail_data(path.string(), "point " + std::to_string(i),
              "lies " + std::to_string(off) + " m from the scan's",
              "is it another order of points, another scan or another frame?");
  }
}

PointPrediction read_cloud_fields(const fs::path& path, std::size_t points,
                                  const PredictionOptions& options, const PointCloud* scan) {
  const PointCloud cloud = read_cloud(path);
  check_rows(path, cloud.size(), points);
  if (scan) check_positions(path, cloud, *scan);
  std::vector<std::string> names;
  for (const auto& field : cloud.fields) names.push_back(field.name);
  const Field* label = cloud.find(options.label_field);
  if (!label)
    fail_data(path.string(), "header", "has no field '" + options.label_field + "'",
              suggestion(options.label_field, names));
  PointPrediction prediction;
  prediction.class_id = whole_numbers(path, *label);
  if (const Field* instance = cloud.find(options.instance_field))
    prediction.instance = whole_numbers(path, *instance);
  if (const Field* plane = cloud.find(options.plane_field))
    prediction.plane = whole_numbers(path, *plane);
  if (const Field* confidence = cloud.find(options.confidence_field)) {
    for (std::size_t i = 0; i < confidence->size(); ++i)
      prediction.confidence.push_back(static_cast<float>(confidence->at(i)));
  }
  return prediction;
}

std::vector<std::int32_t> column_of(const JsonReader& reader, const std::string& key) {
  std::vector<std::int32_t> values;
  if (!reader.has(key)) return values;
  const auto list = reader.at(key);
  const std::size_t count = list.size();
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(static_cast<std::int32_t>(list.at(i).integer()));
  return values;
}

void read_objects(const JsonReader& objects, PointPrediction& prediction) {
  const std::size_t points = prediction.class_id.size();
  std::set<std::int64_t> ids;
  std::vector<std::string> names;
  for (const auto& info : class_list()) names.emplace_back(info.name);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const auto object = objects.at(k);
    const std::int64_t id =
        object.has("id") ? object.at("id").integer() : static_cast<std::int64_t>(k);
    if (!ids.insert(id).second) object.at("id").fail("is the id of two objects");
    const std::string word = object.at("class").text();
    const auto class_id = class_of_label(word);
    if (!class_id && word != "unknown" && word != "ambiguous")
      object.at("class").fail("'" + word + "' is no class", suggestion(word, names));
    const double probability =
        object.has("probability") ? object.at("probability").number_in(0.0, 1.0) : 1.0;
    const auto rows = object.at("points");
    if (!rows.raw().is_array())
      rows.fail("must be a list of point indices", "a number of points cannot be scored");
    const std::size_t count = rows.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t row = rows.at(i).integer();
      if (row < 0 || row >= static_cast<std::int64_t>(points)) {
        rows.at(i).fail("names point " + std::to_string(row) + ", the scan has " +
                        std::to_string(points));
      }
      const auto p = static_cast<std::size_t>(row);
      if (prediction.instance[p] >= 0)
        rows.at(i).fail("point " + std::to_string(row) + " belongs to two objects");
      prediction.class_id[p] = class_id.value_or(unlabelled);
      prediction.instance[p] = static_cast<std::int32_t>(id);
      prediction.confidence[p] = static_cast<float>(probability);
    }
  }
}

PointPrediction read_json_prediction(const fs::path& path, std::size_t points) {
  const Json json = read_json(path);
  const JsonReader reader(json, path.string());
  PointPrediction prediction;
  if (reader.has("objects")) {
    prediction.class_id.assign(points, unlabelled);
    prediction.instance.assign(points, -1);
    prediction.confidence.assign(points, 0.0F);
    read_objects(reader.at("objects"), prediction);
    return prediction;
  }
  prediction.class_id = column_of(reader, "label");
  if (!reader.has("label")) reader.fail("has neither 'objects' nor 'label'");
  prediction.instance = column_of(reader, "instance");
  prediction.plane = column_of(reader, "plane");
  if (reader.has("confidence")) {
    const auto list = reader.at("confidence");
    const std::size_t count = list.size();
    for (std::size_t i = 0; i < count; ++i)
      prediction.confidence.push_back(static_cast<float>(list.at(i).number()));
  }
  check_rows(path, prediction.class_id.size(), points);
  return prediction;
}

bool is_prediction(const fs::path& path) {
  const auto ending = path.extension();
  return ending == ".label" || ending == ".ply" || ending == ".pcd" || ending == ".json";
}

// Regular files that look like predictions in one folder, in order of their names.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file() && is_prediction(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::pair<std::int32_t, std::int32_t>> read_label_map(const fs::path& path) {
  YAML::Node root;
  try {
    root = YAML::Load(read_file(path));
  } catch (const YAML::Exception& error) {
    fail_data(path.string(), "line " + std::to_string(error.mark.line + 1), error.msg);
  }
  if (root.IsMap() && root["labels"]) root.reset(root["labels"]);
  if (!root.IsMap())
    fail_data(path.string(), "", "is no label map", "write '52: desk', one line a label");
  std::vector<std::string> names;
  for (const auto& info : class_list()) names.emplace_back(info.name);
  std::map<std::int32_t, std::int32_t> map;
  for (const auto& entry : root) {
    const std::string place = "line " + std::to_string(entry.first.Mark().line + 1);
    std::int32_t number = 0;
    if (!entry.first.IsScalar() || !YAML::convert<std::int32_t>::decode(entry.first, number) ||
        number < 0) {
      fail_data(path.string(), place, "a label must be a whole number of at least 0");
    }
    const std::string word = entry.second.IsScalar() ? entry.second.Scalar() : "";
    const auto id = word == "unlabelled" || word == "unlabeled" ? std::optional<ClassId>(unlabelled)
                                                                : class_of_label(word);
    if (!id) fail_data(path.string(), place, "'" + word + "' is no class", suggestion(word, names));
    if (!map.emplace(number, *id).second)
      fail_data(path.string(), place, "label " + std::to_string(number) + " is there twice");
  }
  return {map.begin(), map.end()};
}

PointPrediction read_prediction(const fs::path& path, std::size_t points,
                                const PredictionOptions& options, const PointCloud* scan) {
  const auto ending = path.extension();
  PointPrediction prediction;
  if (ending == ".label")
    prediction = read_label_file(path, points);
  else if (ending == ".json")
    prediction = read_json_prediction(path, points);
  else if (ending == ".ply" || ending == ".pcd")
    prediction = read_cloud_fields(path, points, options, scan);
  else
    fail_data(path.string(), "", "is no prediction",
              "predictions end in .label, .ply, .pcd or .json");
  if (ending != ".json" || !options.label_map.empty())
    map_labels(path, options, prediction.class_id);
  for (const auto* column : {&prediction.instance, &prediction.plane}) {
    if (!column->empty()) check_rows(path, column->size(), points);
  }
  if (!prediction.confidence.empty()) check_rows(path, prediction.confidence.size(), points);
  for (std::size_t i = 0; i < prediction.confidence.size(); ++i) {
    const float value = prediction.confidence[i];
    if (std::isfinite(value) && value >= 0.0F && value <= 1.0F) continue;
    fail_data(path.string(), "point " + std::to_string(i),
              "confidence must lie in 0 .. 1, is " + std::to_string(value));
  }
  return prediction;
}

PointPrediction read_prediction(const fs::path& path, const PointCloud& scan,
                                const PredictionOptions& options) {
  return read_prediction(path, scan.size(), options, &scan);
}

PredictionFolder find_predictions(const fs::path& folder, const Dataset& dataset,
                                  const std::string& split) {
  if (!fs::is_directory(folder)) fail_data(folder.string(), "", "is no folder with predictions");
  PredictionFolder found;
  std::vector<std::string> strangers;
  bool truth_there = fs::exists(folder / "dataset.json");
  for (std::size_t s = 0; s < dataset.sequences.size(); ++s) {
    const auto& sequence = dataset.sequences[s];
    truth_there = truth_there || fs::is_directory(folder / "sequences" / sequence.name / "labels");
    std::map<std::string, fs::path> of_scan;
    std::vector<fs::path> places = {folder / "sequences" / sequence.name / "predictions",
                                    folder / sequence.name};
    if (dataset.sequences.size() == 1) places.push_back(folder);
    for (const auto& place : places) {
      for (const auto& path : files_in(place)) {
        const std::string scan = path.stem().string();
        if (std::find(sequence.scans.begin(), sequence.scans.end(), scan) == sequence.scans.end()) {
          strangers.push_back(path.string());
        } else if (!of_scan.emplace(scan, path).second) {
          fail_data(path.string(), "",
                    "is a second prediction for scan " + sequence.name + "/" + scan,
                    "the other is " + of_scan[scan].string());
        }
      }
    }
    if (!split.empty() && sequence.split != split) continue;
    for (std::size_t k = 0; k < sequence.scans.size(); ++k) {
      const auto at = of_scan.find(sequence.scans[k]);
      if (at == of_scan.end())
        found.missing.push_back(sequence.name + "/" + sequence.scans[k]);
      else
        found.files.push_back({sequence.name, sequence.scans[k], s, k, at->second});
    }
  }
  if (found.files.empty() && truth_there) {
    fail_data(folder.string(), "", "holds a data set, not predictions",
              "were --truth and --predictions swapped?");
  }
  if (!strangers.empty()) {
    fail_data(strangers.front(), "",
              "is for a scan that the data set does not have" +
                  (strangers.size() > 1 ? " (and " + std::to_string(strangers.size() - 1) + " more)"
                                        : std::string()),
              "is it another data set?");
  }
  if (found.files.empty()) {
    throw Error(ExitCode::nothing_measured,
                folder.string() + ": no prediction for any scan of the data set; expected " +
                    "sequences/NN/predictions/NNNNNN.label");
  }
  return found;
}

void write_prediction_label(const fs::path& path, const PointPrediction& prediction) {
  std::map<std::int32_t, std::uint32_t> numbers;
  std::string bytes;
  for (std::size_t i = 0; i < prediction.class_id.size(); ++i) {
    std::uint32_t word = static_cast<std::uint32_t>(std::max(prediction.class_id[i], 0)) & 0xffffU;
    if (i < prediction.instance.size() && prediction.instance[i] >= 0) {
      const auto next = static_cast<std::uint32_t>(numbers.size() + 1);
      const std::uint32_t number = numbers.emplace(prediction.instance[i], next).first->second;
      if (number > 0xffffU)
        fail_data(path.string(), "", "more than 65535 instances do not fit into a .label file",
                  "write PLY instead");
      word |= number << 16U;
    }
    for (unsigned b = 0; b < 4; ++b) bytes += static_cast<char>(word >> (8 * b) & 0xffU);
  }
  write_file(path, bytes);
}

}  // namespace scanchor
