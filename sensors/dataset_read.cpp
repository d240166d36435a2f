#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "cloud/io.hpp"
#include "cloud/kitti.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "sensors/dataset.hpp"
#include "sensors/dataset_card.hpp"
#include "sensors/dataset_files.hpp"
#include "sensors/dataset_truth.hpp"

namespace scanchor {
namespace fs = std::filesystem;
namespace {

/// Entries of a folder by name; numbers by their value, so that "100" comes after "20".
std::vector<fs::path> sorted(const fs::path& folder) {
  std::vector<fs::path> list;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) list.push_back(entry.path());
  std::sort(list.begin(), list.end(), [](const fs::path& a, const fs::path& b) {
    const std::string x = a.stem().string(), y = b.stem().string();
    return x.size() != y.size() ? x.size() < y.size() : x < y;
  });
  return list;
}

std::string read_if_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) ? read_file(path) : std::string();
}

void read_labels(const DatasetSequence& sequence, const std::string& name, Scan& scan) {
  const fs::path path = sequence.folder / "labels" / (name + ".label");
  std::error_code error;
  scan.truth.resize(scan.cloud.size());
  if (!fs::exists(path, error)) return;
  add_kitti_labels(scan.cloud, read_file(path), path.string());
  const auto& label = std::get<std::vector<std::uint16_t>>(scan.cloud.find("label")->values);
  const auto& instance = std::get<std::vector<std::uint16_t>>(scan.cloud.find("instance")->values);
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    scan.truth.class_id[i] = label[i];
    scan.truth.instance[i] = instance[i] == 0 ? -1 : instance[i];
  }
  std::erase_if(scan.cloud.fields,
                [](const Field& f) { return f.name == "label" || f.name == "instance"; });
}

void read_pose(const DatasetSequence& sequence, std::size_t index, Scan& scan) {
  const fs::path poses_path = sequence.folder / "poses.txt";
  const fs::path calib_path = sequence.folder / "calib.txt";
  const std::string poses = read_if_there(poses_path);
  if (poses.empty()) return;
  const auto list =
      parse_poses(poses, read_if_there(calib_path), poses_path.string(), calib_path.string());
  if (index >= list.size()) {
    fail_data(poses_path.string(), "",
              fmt::format("has {} poses, scan {} needs more", list.size(), index));
  }
  scan.T_world_sensor = list[index];
}

}  // namespace

Dataset read_dataset(const fs::path& root) {
  Dataset dataset;
  dataset.root = root;
  std::error_code error;
  const fs::path folder = root / "sequences";
  if (!fs::is_directory(folder, error)) {
    fail_data(root.string(), "", "holds no data set", "a folder 'sequences' was expected");
  }
  if (fs::exists(root / "suite.json", error)) {
    const Json json = read_json(root / "suite.json");
    dataset.name = JsonReader(json, (root / "suite.json").string()).at("suite").at("name").text();
  }
  for (const auto& path : sorted(folder)) {
    if (!fs::is_directory(path / "velodyne", error)) continue;
    DatasetSequence sequence;
    sequence.name = path.filename().string();
    sequence.folder = path;
    const fs::path card = path / "sequence.json";
    if (fs::exists(card, error)) {
      sequence.split = read_sequence_card(card).split;
    } else if (!dataset.name.empty()) {
      continue;  // one of ours that is not complete
    }
    for (const auto& file : sorted(path / "velodyne")) {
      if (file.extension() == ".bin") sequence.scans.push_back(file.stem().string());
    }
    dataset.sequences.push_back(std::move(sequence));
  }
  if (dataset.sequences.empty()) fail_data(folder.string(), "", "holds no complete sequence");
  return dataset;
}

Scene read_dataset_scene(const DatasetSequence& sequence) {
  return read_scene(sequence.folder / "scene.json");
}

Scan read_dataset_scan(const DatasetSequence& sequence, std::size_t index) {
  if (index >= sequence.scans.size()) {
    fail_data(sequence.folder.string(), "",
              fmt::format("has {} scans, no scan {}", sequence.scans.size(), index));
  }
  const std::string& name = sequence.scans[index];
  Scan scan;
  const fs::path bin = sequence.folder / "velodyne" / (name + ".bin");
  scan.cloud = parse_kitti(read_file(bin), bin.string());
  read_labels(sequence, name, scan);
  read_pose(sequence, index, scan);
  scan.beams_fired = scan.cloud.size();
  std::error_code error;
  const fs::path truth = sequence.folder / "truth" / (name + ".npy");
  if (fs::exists(truth, error)) read_truth_npy(read_file(truth), scan, truth.string());
  if (fs::exists(sequence.folder / "faces.json", error)) {
    scan.visibility = read_face_visibility(sequence.folder / "faces.json", index);
  }
  if (fs::exists(sequence.folder / "sequence.json", error)) {
    const SequenceCard card = read_sequence_card(sequence.folder / "sequence.json");
    if (index < card.scan_seeds.size()) {
      scan.seed = card.scan_seeds[index];
      scan.beams_fired = static_cast<std::size_t>(card.scan_beams[index]);
    }
  }
  return scan;
}

std::vector<std::string> verify_dataset(const fs::path& root) {
  const fs::path path = root / "dataset.json";
  const Json json = read_json(path);
  const JsonReader files = JsonReader(json, path.string()).at("files");
  std::vector<std::string> problems;
  std::set<std::string> known = {"dataset.json"};
  std::error_code error;
  for (const auto& name : files.keys()) {
    known.insert(name);
    if (!fs::exists(root / name, error)) {
      problems.push_back(name + ": is missing");
    } else if (sha256(read_file(root / name)) != files.at(name).at("sha256").text()) {
      problems.push_back(name + ": is not what the data-set card says");
    }
  }
  std::vector<std::string> strange;
  for (const auto& entry : fs::recursive_directory_iterator(root, error)) {
    if (!entry.is_regular_file(error)) continue;
    const std::string name = fs::relative(entry.path(), root, error).generic_string();
    if (!known.contains(name) && !name.ends_with("/sequence.json"))
      strange.push_back(name + ": is not in the data-set card");
  }
  std::sort(strange.begin(), strange.end());
  problems.insert(problems.end(), strange.begin(), strange.end());
  return problems;
}

}  // namespace scanchor
