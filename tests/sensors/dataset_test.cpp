#include "sensors/dataset.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "core/error.hpp"
#include "core/json.hpp"
#include "core/random.hpp"
#include "tests/sensors/support/temporary_folder.hpp"

namespace scanchor {
namespace {
namespace fs = std::filesystem;
using testing::hashes;
using testing::TemporaryFolder;

Suite four_scene_suite() {
  Suite suite;
  suite.name = "small";
  suite.scenes = 4;
  suite.scans = 2;
  suite.split = {0.5, 0.25, 0.25};
  suite.room.clutter = 0.2;
  suite.settle.maximum_time = 1.0;
  suite.lidar.lines = 24;
  suite.lidar.beams_per_line = 40;
  suite.vary = {{"lidar.range_sigma", 0.001, 0.01}};
  return suite;
}

std::string data_error(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Dataset, TheBytesDoNotDependOnThreadsShardsOrInterruptions) {
  const TemporaryFolder folder;
  const Suite suite = four_scene_suite();
  DatasetOptions options;
  options.threads = 1;
  options.formats = {.truth = true, .pcd = true, .ply = true, .s3dis = true};
  const DatasetResult whole = generate_dataset(suite, folder / "one", options);
  EXPECT_TRUE(whole.complete);
  EXPECT_EQ(whole.scenes_written, 4);
  EXPECT_EQ(whole.scans_written, 8U);
  const auto expected = hashes(folder / "one");
  EXPECT_GT(expected.size(), 50U);

  options.threads = 2;
  generate_dataset(suite, folder / "two", options);
  EXPECT_EQ(hashes(folder / "two"), expected) << "threads";

  // Three shards on three machines, laid side by side, then finished by a call that finds nothing
  // to do.
  for (int i = 0; i < 3; ++i) {
    options.shard = {i, 3};
    const auto part = generate_dataset(suite, folder / ("shard" + std::to_string(i)), options);
    EXPECT_FALSE(part.complete);
    EXPECT_FALSE(fs::exists(folder / ("shard" + std::to_string(i)) / "dataset.json"));
  }
  std::map<std::string, std::string> seen;
  for (int i = 0; i < 3; ++i) {
    for (const auto& [name, hash] : hashes(folder / ("shard" + std::to_string(i)))) {
      EXPECT_TRUE(!seen.contains(name) || seen[name] == hash) << name << " differs between shards";
      seen[name] = hash;
    }
    fs::copy(folder / ("shard" + std::to_string(i)), folder / "merged",
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  options.shard = {};
  const auto merged = generate_dataset(suite, folder / "merged", options);
  EXPECT_EQ(merged.scenes_written, 0);
  EXPECT_EQ(merged.scenes_found, 4);
  EXPECT_TRUE(merged.complete);
  EXPECT_EQ(hashes(folder / "merged"), expected) << "shards";

  // Stopped after three scans, then a file of a finished scene cut short as a crash might, then
  // resumed.
  std::atomic<bool> stop = false;
  options.threads = 1;
  options.stop = &stop;
  options.progress = [&](std::size_t done, std::size_t total) {
    EXPECT_EQ(total, 8U);
    if (done == 3) stop = true;
  };
  const auto stopped = generate_dataset(suite, folder / "resumed", options);
  EXPECT_TRUE(stopped.interrupted);
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(stopped.scenes_written, 1);
  options.stop = nullptr;
  options.progress = nullptr;
  const auto resumed = generate_dataset(suite, folder / "resumed", options);
  EXPECT_EQ(resumed.scenes_found, 1);
  EXPECT_EQ(resumed.scenes_written, 3);
  EXPECT_EQ(hashes(folder / "resumed"), expected) << "interruption";
  std::ofstream(folder / "resumed/sequences/02/velodyne/000001.bin", std::ios::trunc) << "x";
  write_file(folder / "resumed/sequences/02/velodyne/000001.bin.part-1", "left by a killed run");
  fs::remove(folder / "resumed/dataset.json");
  EXPECT_EQ(generate_dataset(suite, folder / "resumed", options).scenes_written, 1)
      << "a damaged scene is made again";
  EXPECT_EQ(hashes(folder / "resumed"), expected);
}

// Twenty scans from seed to files; bench/hashes_bench does it with scans of 100,000 points.
TEST(Dataset, TheBytesDoNotDependOnInstructionSetOrPackets) {
  const TemporaryFolder folder;
  Suite suite = four_scene_suite();
  suite.families = {{"office", 1.0}, {"kitchen", 1.0}};
  suite.scans = 5;
  suite.lidar = lidar_preset("lms-1xx");  // footprints, mixed pixels, quantum
  suite.lidar.lines = 12;
  suite.lidar.beams_per_line = 90;
  suite.lidar.subrays = 7;
  std::map<std::string, std::string> first;
  int run = 0;
  for (const char* isa : {"", "sse2", "avx2"}) {
    for (const int width : {1, 8, 16}) {
      for (const int threads : {1, 2}) {
        DatasetOptions options;
        options.threads = threads;
        options.world.embree_isa = isa;
        options.world.packet_width = width;
        const fs::path set = folder / std::to_string(run++);
        EXPECT_EQ(generate_dataset(suite, set, options).scans_written, 20U);
        if (first.empty()) first = hashes(set);
        EXPECT_EQ(hashes(set), first) << isa << " width " << width << " threads " << threads;
      }
    }
  }
}

TEST(Dataset, AnotherSuiteSeedOrFormatIsRefused) {
  const TemporaryFolder folder;
  Suite suite = four_scene_suite();
  suite.scenes = 1;
  generate_dataset(suite, folder / "a");
  const auto before = hashes(folder / "a");
  suite.seed = 2;
  EXPECT_NE(
      data_error([&] { generate_dataset(suite, folder / "a"); }).find("holds another data set"),
      std::string::npos);
  suite.seed = 1;
  DatasetOptions options;
  options.formats.pcd = true;
  EXPECT_NE(data_error([&] {
              generate_dataset(suite, folder / "a", options);
            }).find("holds another data set"),
            std::string::npos);
  fs::create_directories(folder / "b" / "sequences");
  EXPECT_NE(data_error([&] { generate_dataset(suite, folder / "b"); }).find("without suite.json"),
            std::string::npos);
  EXPECT_EQ(hashes(folder / "a"), before);
}

TEST(Dataset, AFullDiskLeavesNoHalfFileAndIsResumed) {
  const TemporaryFolder folder;
  Suite suite = four_scene_suite();
  suite.scenes = 1;
  generate_dataset(suite, folder / "whole");
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = old;
  small.rlim_cur = 6000;  // below a .bin and a scene
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = data_error([&] { generate_dataset(suite, folder / "full"); });
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("cannot be written: File too large"), std::string::npos) << message;
  for (const auto& [name, hash] : hashes(folder / "full")) {
    EXPECT_EQ(hash, hashes(folder / "whole")[name]) << name << " is there but not whole";
  }
  generate_dataset(suite, folder / "full");
  EXPECT_EQ(hashes(folder / "full"), hashes(folder / "whole"));
}

TEST(Dataset, AnUnwritableFolderIsSaidAtOnce) {
  const TemporaryFolder folder;
  write_file(folder / "file", "");
  EXPECT_NE(data_error([&] { generate_dataset(four_scene_suite(), folder / "file"); }).find("file"),
            std::string::npos);
  EXPECT_NE(data_error([&] {
              generate_dataset(four_scene_suite(), folder / "file/below");
            }).find("folder cannot be made"),
            std::string::npos);
}

TEST(Dataset, SplitIsByScene) {
  const TemporaryFolder folder;
  generate_dataset(four_scene_suite(), folder / "a");
  const Json card = read_json(folder / "a/dataset.json");
  EXPECT_EQ(card["split"]["train"].size(), 2U);
  EXPECT_EQ(card["split"]["valid"].size(), 1U);
  EXPECT_EQ(card["split"]["test"].size(), 1U);
  EXPECT_EQ(card["scans"], 8);
  EXPECT_EQ(card["suite"]["seed"], 1);
}

}  // namespace
}  // namespace scanchor
