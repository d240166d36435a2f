#include "sensors/dataset.hpp"

#include <fmt/format.h>

#include <mutex>
#include <optional>
#include <set>
#include <system_error>

#include "cloud/io.hpp"
#include "cloud/kitti.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "sensors/dataset_card.hpp"
#include "sensors/dataset_files.hpp"
#include "sensors/dataset_truth.hpp"
#include "sensors/made_room.hpp"

namespace scanchor {
namespace fs = std::filesystem;
namespace {

/// Writes files below the root and keeps what the card needs to know of them.
class SequenceWriter {
 public:
  SequenceWriter(const fs::path& root, SequenceCard& card) : root_(root), card_(card) {}

  void write(const std::string& name, const std::string& bytes) {
    const fs::path path = root_ / name;
    if (made_.insert(path.parent_path()).second) make_folder(path.parent_path());
    write_file(path, bytes);
    card_.files[name] = {bytes.size(), sha256(bytes)};
  }

  /// For what another room writes to a path of its own.
  void write_with(const std::string& name, const std::function<void(const fs::path&)>& writer) {
    const fs::path path = root_ / name;
    if (made_.insert(path.parent_path()).second) make_folder(path.parent_path());
    writer(path);
    const std::string bytes = read_file(path);
    card_.files[name] = {bytes.size(), sha256(bytes)};
  }

 private:
  const fs::path& root_;
  SequenceCard& card_;
  std::set<fs::path> made_;
};

/// The nearest float. Through memory: GCC 12 takes a conversion there and back for nothing where it
/// makes vectors of it, and leaves the double as it was.
double as_float(double value) {
  const volatile float narrow = static_cast<float>(value);
  return narrow;
}

/// "storage aisle" -> "storageAisle", as S3DIS spells its rooms.
std::string room_name(const std::string& family, int index) {
  std::string name;
  bool upper = false;
  for (const char c : family) {
    if (c == ' ') {
      upper = true;
      continue;
    }
    name += upper && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    upper = false;
  }
  return fmt::format("{}_{}", name, index);
}

void count_classes(const PointTruth& truth, SequenceCard& card,
                   std::set<std::int32_t>& instances_seen) {
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ClassCount& count = card.classes[std::max(0, truth.class_id[i])];
    ++count.points;
    count.scenes = 1;
    for (std::size_t bit = 0; bit < card.flagged.size(); ++bit) {
      card.flagged[bit] += truth.flags[i] >> bit & 1;
    }
    if (truth.instance[i] >= 0 && instances_seen.insert(truth.instance[i]).second)
      ++count.instances;
  }
}

class Generator {
 public:
  Generator(const Suite& suite, const fs::path& root, const DatasetOptions& options)
      : suite_(suite), root_(root), options_(options), tasks_(scene_tasks(suite)) {}

  DatasetResult run() {
    open_folder();
    std::vector<const SceneTask*> missing;
    for (const auto& task : tasks_) {
      if (!options_.shard.has(task.index)) continue;
      if (complete_card(task))
        ++result_.scenes_found;
      else
        missing.push_back(&task);
    }
    total_ = (missing.size() + static_cast<std::size_t>(result_.scenes_found)) *
             static_cast<std::size_t>(suite_.scans);
    done_ = static_cast<std::size_t>(result_.scenes_found) * static_cast<std::size_t>(suite_.scans);
    if (options_.progress) options_.progress(done_, total_);
    {
      const ThreadLimit limit(options_.threads);
      parallel_blocks(missing.size(), 1, [&](std::size_t begin, std::size_t) {
        if (!stopped()) generate(*missing[begin]);
      });
    }
    result_.interrupted = stopped();
    finish();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  /// An empty folder, or one that holds a part of this very data set.
  void open_folder() {
    make_folder(root_);
    const std::string card = suite_card(suite_, options_.formats);
    const fs::path path = root_ / "suite.json";
    if (!fs::exists(path)) {
      if (fs::exists(root_ / "sequences")) {
        fail_data(root_.string(), "", "holds a data set without suite.json",
                  "choose another folder");
      }
      write_file(path, card);
    } else if (read_file(path) != card) {
      fail_data(root_.string(), "",
                "holds another data set: its suite.json has other options, formats or version",
                "choose another folder or remove it");
    }
  }

  [[nodiscard]] fs::path card_path(const SceneTask& task) const {
    return root_ / "sequences" / task.name / "sequence.json";
  }

  /// The card of a sequence whose files are all there with their sizes; nothing if the work is
  /// still to be done.
  [[nodiscard]] std::optional<SequenceCard> complete_card(const SceneTask& task) const {
    std::error_code error;
    if (!fs::exists(card_path(task), error)) return std::nullopt;
    try {
      SequenceCard card = read_sequence_card(card_path(task));
      if (card.seed != task.seed) return std::nullopt;
      for (const auto& [name, record] : card.files) {
        if (fs::file_size(root_ / name, error) != record.bytes || error) return std::nullopt;
      }
      return card;
    } catch (const Error&) {
      return std::nullopt;  // damaged: made again
    }
  }

  void generate(const SceneTask& task) {
    // What a killed run left of this sequence, temporary files among it.
    std::error_code ignored;
    fs::remove_all(root_ / "sequences" / task.name, ignored);
    SequenceCard card;
    card.name = task.name;
    card.split = task.split;
    card.family = task.room.family;
    card.seed = task.seed;
    const MadeRoom room = make_room(task);
    const Scene& scene = room.scene;
    card.tries = static_cast<std::uint64_t>(room.tries);
    card.complete = room.complete;
    card.settled = room.settled;
    card.problems = room.problems;
    SequenceWriter writer(root_, card);
    const std::string folder = "sequences/" + task.name + "/";
    std::vector<Eigen::Isometry3d> poses;
    std::vector<std::vector<FaceVisibility>> visibility;
    std::vector<Scan> kept;
    {
      const World world(scene, options_.world);
      std::set<std::int32_t> instances_seen;
      Scan scan;
      for (int k = 0; k < suite_.scans; ++k) {
        if (stopped()) return;
        const std::uint64_t seed = scan_seed(task, k);
        scan_room_into(world, scan_pose(scene, k), task.lidar, seed, scan);
        write_scan(writer, folder, k, scan);
        count_classes(scan.truth, card, instances_seen);
        card.scan_seeds.push_back(seed);
        card.scan_points.push_back(scan.cloud.size());
        card.scan_beams.push_back(scan.beams_fired);
        poses.push_back(scan.T_world_sensor);
        visibility.push_back(scan.visibility);
        if (options_.formats.s3dis) kept.push_back(scan);
        report_scan(scan.cloud.size());
      }
    }
    writer.write(folder + "poses.txt", poses_text(poses));
    writer.write(folder + "calib.txt", calib_text());
    writer.write(folder + "times.txt", times_text(poses.size(), task.lidar));
    writer.write_with(folder + "scene.json",
                      [&](const fs::path& path) { write_scene(path, scene); });
    writer.write(folder + "faces.json", faces_json(scene, visibility));
    writer.write(folder + "relations.json", relations_json(scene));
    if (options_.formats.s3dis) {
      const char* area = task.split == "train"   ? "Area_1/"
                         : task.split == "valid" ? "Area_2/"
                                                 : "Area_5/";
      for (const auto& [name, text] :
           s3dis_files(scene, kept, room_name(task.room.family, task.index))) {
        writer.write(area + name, text);
      }
    }
    write_sequence_card(card_path(task), card);  // last: it says that all others are there
    const std::lock_guard lock(mutex_);
    ++result_.scenes_written;
  }

  void write_scan(SequenceWriter& writer, const std::string& folder, int k,
                  const Scan& scan) const {
    const std::string number = fmt::format("{:06}", k);
    writer.write(folder + "velodyne/" + number + ".bin", format_kitti(scan.cloud));
    const std::string labels = folder + "labels/" + number + ".label";
    writer.write(labels, label_bytes(scan.truth, labels));
    if (options_.formats.truth) writer.write(folder + "truth/" + number + ".npy", truth_npy(scan));
    if (!options_.formats.pcd && !options_.formats.ply) return;
    PointCloud cloud = cloud_with_truth(scan);
    for (auto& p : cloud.points) {
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = as_float(p[axis]);  // the same positions as in the .bin
    }
    cloud.sensor_poses = {Eigen::Isometry3d::Identity()};
    const auto write = [&](const char* kind) {
      writer.write_with(fmt::format("{}{}/{}.{}", folder, kind, number, kind),
                        [&](const fs::path& path) { write_cloud(path, cloud); });
    };
    if (options_.formats.pcd) write("pcd");
    if (options_.formats.ply) write("ply");
  }

  void report_scan(std::size_t points) {
    const std::lock_guard lock(mutex_);
    ++result_.scans_written;
    result_.points_written += points;
    ++done_;
    if (options_.progress) options_.progress(done_, total_);
  }

  /// Problems in the order of the scenes, and the card of the whole once nothing is missing.
  void finish() {
    std::vector<SequenceCard> cards;
    for (const auto& task : tasks_) {
      auto card = complete_card(task);
      if (!card) continue;
      if (options_.shard.has(task.index)) {
        result_.rooms_made_anew += card->tries > 1 ? 1 : 0;
        for (const auto& problem : card->problems)
          result_.problems.push_back(fmt::format("scene {}: {}", task.name, problem));
      }
      cards.push_back(*std::move(card));
    }
    result_.complete = cards.size() == tasks_.size();
    if (result_.complete) write_dataset_card(root_, suite_, options_.formats, cards);
  }

  const Suite& suite_;
  const fs::path& root_;
  const DatasetOptions& options_;
  std::vector<SceneTask> tasks_;
  std::mutex mutex_;
  DatasetResult result_;
  std::size_t done_ = 0, total_ = 0;
};

}  // namespace

DatasetResult generate_dataset(const Suite& suite, const fs::path& out,
                               const DatasetOptions& options) {
  return Generator(suite, out, options).run();
}

}  // namespace scanchor
