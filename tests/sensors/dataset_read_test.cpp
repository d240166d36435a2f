#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <optional>

#include "core/error.hpp"
#include "core/random.hpp"
#include "sensors/dataset.hpp"
#include "tests/sensors/support/temporary_folder.hpp"

namespace scanchor {
namespace {
namespace fs = std::filesystem;
using testing::TemporaryFolder;

Suite small_suite() {
  Suite suite;
  suite.name = "small";
  suite.scenes = 2;
  suite.scans = 2;
  suite.settle.maximum_time = 1.0;
  suite.lidar.lines = 30;
  suite.lidar.beams_per_line = 60;
  return suite;
}

TEST(DatasetRead, GivesBackWhatTheSensorGave) {
  const TemporaryFolder folder;
  const Suite suite = small_suite();
  generate_dataset(suite, folder / "a");
  const Dataset dataset = read_dataset(folder / "a");
  EXPECT_EQ(dataset.name, "small");
  ASSERT_EQ(dataset.sequences.size(), 2U);
  ASSERT_EQ(dataset.sequences[1].scans.size(), 2U);
  const SceneTask task = scene_tasks(suite)[1];
  Scene scene = generate_room(task.room, task.seed);
  settle(scene, task.settle);
  EXPECT_EQ(read_dataset_scene(dataset.sequences[1]).instances.size(), scene.instances.size());
  EXPECT_EQ(dataset.sequences[1].split, task.split);
  const World world(scene);
  for (std::size_t k = 0; k < 2; ++k) {
    const Scan scan = scan_room(world, scene.sensor_poses[k % scene.sensor_poses.size()],
                                task.lidar, stream_seed(task.seed, "scan", k));
    const Scan back = read_dataset_scan(dataset.sequences[1], k);
    ASSERT_EQ(back.cloud.size(), scan.cloud.size());
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
      EXPECT_EQ(back.cloud.points[i], scan.cloud.points[i].cast<float>().cast<double>());
      EXPECT_EQ(back.truth.class_id[i], std::max(0, scan.truth.class_id[i]));
    }
    EXPECT_EQ(back.truth.instance, scan.truth.instance);
    EXPECT_EQ(back.truth.part, scan.truth.part);
    EXPECT_EQ(back.truth.face, scan.truth.face);
    EXPECT_EQ(back.truth.runner_up, scan.truth.runner_up);
    EXPECT_EQ(back.truth.flags, scan.truth.flags);
    EXPECT_EQ(back.truth.true_range, scan.truth.true_range);
    EXPECT_EQ(back.truth.incidence, scan.truth.incidence);
    EXPECT_EQ(back.line, scan.line);
    EXPECT_EQ(back.beam, scan.beam);
    EXPECT_EQ(back.seed, scan.seed);
    EXPECT_EQ(back.beams_fired, scan.beams_fired);
    EXPECT_EQ(back.T_world_sensor.matrix(), scan.T_world_sensor.matrix());
    ASSERT_EQ(back.visibility.size(), scan.visibility.size());
    for (std::size_t v = 0; v < scan.visibility.size(); ++v) {
      EXPECT_EQ(back.visibility[v].face, scan.visibility[v].face);
      EXPECT_EQ(back.visibility[v].points, scan.visibility[v].points);
      EXPECT_EQ(back.visibility[v].visible_fraction, scan.visibility[v].visible_fraction);
    }
    ASSERT_NE(back.cloud.find("intensity"), nullptr);
    EXPECT_EQ(back.cloud.find("intensity")->at(5), scan.cloud.find("intensity")->at(5));
  }
}

TEST(DatasetRead, SomebodyElsesSemanticKitti) {
  const TemporaryFolder folder;
  for (const char* name : {"00", "08", "11"})
    fs::create_directories(folder / "sequences" / name / "velodyne");
  fs::create_directories(folder / "sequences/00/labels");
  write_file(folder / "sequences/00/velodyne/000000.bin",
             std::string("\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40\0\0\0\x3f", 16));
  write_file(folder / "sequences/00/velodyne/000001.bin", std::string(32, '\0'));
  write_file(folder / "sequences/00/labels/000000.label", std::string("\x28\0\x05\0", 4));
  write_file(folder / "sequences/00/poses.txt",
             "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 2\n");
  write_file(folder / "sequences/08/velodyne/000000.bin", std::string(16, '\0'));
  const Dataset dataset = read_dataset(folder / "");
  EXPECT_EQ(dataset.name, "");
  ASSERT_EQ(dataset.sequences.size(), 3U);
  const Scan scan = read_dataset_scan(dataset.sequences[0], 0);
  EXPECT_EQ(scan.cloud.points[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(scan.truth.class_id[0], 40);
  EXPECT_EQ(scan.truth.instance[0], 5);
  EXPECT_EQ(scan.truth.face[0], -1);
  const Scan second = read_dataset_scan(dataset.sequences[0], 1);
  EXPECT_EQ(second.T_world_sensor.translation(), Eigen::Vector3d(2, 0, 0)) << "2 m forward";
  EXPECT_EQ(second.truth.class_id[1], 0) << "no labels: unlabelled";
  EXPECT_EQ(read_dataset_scan(dataset.sequences[1], 0).cloud.size(), 1U);
  EXPECT_THROW((void)read_dataset_scene(dataset.sequences[0]), Error);
  EXPECT_THROW((void)read_dataset_scan(dataset.sequences[1], 1), Error);
  write_file(folder / "sequences/00/labels/000000.label", "12");
  EXPECT_THROW((void)read_dataset_scan(dataset.sequences[0], 0), Error);
}

TEST(DatasetRead, AFolderWithoutSequencesIsNone) {
  const TemporaryFolder folder;
  EXPECT_THROW((void)read_dataset(folder / ""), Error);
  fs::create_directories(folder / "sequences");
  EXPECT_THROW((void)read_dataset(folder / ""), Error);
}

TEST(DatasetRead, VerifySeesEveryChange) {
  const TemporaryFolder folder;
  Suite suite = small_suite();
  suite.scenes = 1;
  suite.scans = 1;
  generate_dataset(suite, folder / "a");
  EXPECT_TRUE(verify_dataset(folder / "a").empty());
  std::string labels = read_file(folder / "a/sequences/00/labels/000000.label");
  labels[4] ^= 1;
  write_file(folder / "a/sequences/00/labels/000000.label", labels);
  fs::remove(folder / "a/sequences/00/times.txt");
  write_file(folder / "a/notes.txt", "");
  EXPECT_EQ(verify_dataset(folder / "a"),
            (std::vector<std::string>{
                "sequences/00/labels/000000.label: is not what the data-set card says",
                "sequences/00/times.txt: is missing", "notes.txt: is not in the data-set card"}));
}

std::optional<std::string> output_of(const std::string& command) {
  std::FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), n);
  if (::pclose(pipe) != 0) return std::nullopt;
  return text;
}

/// What support/read_dataset.py prints, computed here with reads that share no code with the
/// project.
std::string summary(const fs::path& root, const Suite& suite) {
  std::string text;
  for (const auto& task : scene_tasks(suite)) {
    const fs::path folder = root / "sequences" / task.name;
    std::ifstream poses(folder / "poses.txt");
    for (int k = 0; k < suite.scans; ++k) {
      char number[16];
      std::snprintf(number, sizeof number, "%06d", k);
      const auto bytes = [&](const std::string& sub, const std::string& ending) {
        std::ifstream in(folder / sub / (number + ending), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
      };
      const std::string bin = bytes("velodyne", ".bin"), label = bytes("labels", ".label"),
                        npy = bytes("truth", ".npy");
      EXPECT_EQ(bin.size(), 4 * label.size());
      const auto byte = [](const std::string& s, std::size_t i) {
        return static_cast<unsigned long>(static_cast<unsigned char>(s[i]));
      };
      unsigned long labels = 0, instances = 0;
      long faces = 0;
      const std::size_t start = 10 + byte(npy, 8) + 256 * byte(npy, 9);
      for (std::size_t i = 0; i < label.size() / 4; ++i) {
        labels += byte(label, 4 * i) + 256 * byte(label, 4 * i + 1);
        instances += byte(label, 4 * i + 2) + 256 * byte(label, 4 * i + 3);
        const std::size_t at = start + 23 * i;
        faces += static_cast<std::int32_t>(byte(npy, at) | byte(npy, at + 1) << 8 |
                                           byte(npy, at + 2) << 16 | byte(npy, at + 3) << 24);
      }
      double m[12];
      for (double& v : m) poses >> v;
      // Camera to sensor: x = z_c, y = -x_c, z = -y_c.
      char line[256];
      std::snprintf(line, sizeof line, "%s %d %zu %lu %lu %ld %.9f %.9f %.9f\n", task.name.c_str(),
                    k, label.size() / 4, labels, instances, faces, m[11], 0.0 - m[3], 0.0 - m[7]);
      text += line;
    }
  }
  return text;
}

/// A Python that has numpy; empty: there is none.
std::string python_with_numpy() {
  for (const char* name : {"/usr/bin/python3", "python3"}) {
    if (output_of(std::string(name) + " -c 'import numpy'")) return name;
  }
  return "";
}

TEST(DatasetRead, IndependentReadersReadTheSame) {
  const TemporaryFolder folder;
  const Suite suite = small_suite();
  generate_dataset(suite, folder / "a");
  const std::string expected = summary(folder / "a", suite);
  const Dataset dataset = read_dataset(folder / "a");
  std::size_t points = 0;
  for (const auto& sequence : dataset.sequences)
    points += read_dataset_scan(sequence, 0).cloud.size();
  EXPECT_GT(points, 1000U);
  const std::string python = python_with_numpy();
  RecordProperty("independent_reader", python.empty() ? "C++ only" : "numpy");
  if (python.empty()) {
    std::printf("no Python with numpy here: the reads above are the independent reader\n");
    return;
  }
  EXPECT_EQ(output_of(python + " '" + SCANCHOR_SOURCE_DIR +
                      "/tests/sensors/support/read_dataset.py' '" + (folder / "a").string() + "'"),
            expected);
}

// PCD, PLY, KITTI and NPY by a reader that knows only the formats' own documents: the same points,
// labels and instances in all of them, and every SHA-256 of the card.
TEST(DatasetRead, IndependentReadersFindTheSameInEveryForm) {
  const TemporaryFolder folder;
  Suite suite = small_suite();
  DatasetOptions options;
  options.formats = {.truth = true, .pcd = true, .ply = true, .s3dis = true};
  const DatasetResult result = generate_dataset(suite, folder / "a", options);
  EXPECT_TRUE(verify_dataset(folder / "a").empty());
  const std::string python = python_with_numpy();
  RecordProperty("independent_reader", python.empty() ? "C++ only" : "numpy");
  if (python.empty()) return;
  const auto said =
      output_of(python + " '" + SCANCHOR_SOURCE_DIR + "/tests/sensors/support/read_clouds.py' '" +
                (folder / "a").string() + "'");
  ASSERT_TRUE(said.has_value()) << "the reader found a difference";
  EXPECT_EQ(said->substr(0, said->find(',')), std::to_string(result.scans_written) + " scans");
}

}  // namespace
}  // namespace scanchor
