#include "eval/baseline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {
namespace {

RunResult run_of(std::int64_t found) {
  RunResult run;
  run.suite = "small";
  run.data = "small/test (0)";
  run.method = "default";
  for (int i = 0; i < 3; ++i) {
    SceneRow row;
    row.index = i;
    row.name = std::to_string(i);
    row.seed = 18446744073709551615ULL - static_cast<std::uint64_t>(i);
    row.score.protocol = protocol_stamp(run.protocol);
    row.score.data = run.data;
    row.score.scans = 1;
    row.score.points.classes = class_list().size();
    row.score.points.confusion.assign(class_list().size() * class_list().size(), 0);
    row.score.panoptic.classes.resize(class_list().size());
    row.score.instances.classes.resize(class_list().size());
    row.score.objects.classes.resize(class_list().size());
    row.score.objects.classes[8] = {10, found, 1, 0};
    row.times.scan = 0.5;
    run.pooled.add(row.score);
    run.rows.push_back(row);
  }
  return run;
}

struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "scanchor-baseline-test";
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() { std::filesystem::remove_all(path); }
};

TEST(Baseline, ReadsBackAndHoldsNoTimes) {
  const Folder folder;
  const Baseline baseline = update_baseline({}, run_of(7), "the first one ever", "2026-11-22");
  write_baseline(folder.path / "b.json", baseline);
  const Baseline read = read_baseline(folder.path / "b.json");
  EXPECT_EQ(read.run.pooled, baseline.run.pooled);
  EXPECT_EQ(read.run.rows[2].seed, baseline.run.rows[2].seed);
  EXPECT_EQ(read.history[0].reason, "the first one ever");
  EXPECT_THAT(read_file(folder.path / "b.json"), testing::Not(testing::HasSubstr("wall_seconds")));
}

TEST(Baseline, ASceneIsALineAndTheFolderIsMade) {
  const Folder folder;
  const auto path = folder.path / "results" / "baselines" / "b.json";
  write_baseline(path, update_baseline({}, run_of(7), "the first one ever", "2026-11-22"));
  const std::string text = read_file(path);
  std::size_t scenes = 0;
  for (std::size_t at = 0; (at = text.find("\n    {\"index\":", at)) != std::string::npos; ++at)
    ++scenes;
  EXPECT_EQ(scenes, run_of(7).rows.size());
}

TEST(Baseline, UpdateSaysWhatChangedAndWantsAReason) {
  const Baseline old = update_baseline({}, run_of(7), "the first one ever", "2026-11-22");
  EXPECT_THROW(update_baseline(old, run_of(8), "", "2026-11-23"), Error);
  EXPECT_THROW(update_baseline(old, run_of(8), "better", "2026-11-23"), Error);
  EXPECT_THROW(update_baseline(old, run_of(7), "nothing new at all", "2026-11-23"), Error);
  const Baseline next = update_baseline(old, run_of(8), "desks are found better", "2026-11-23");
  ASSERT_EQ(next.history.size(), 2U);
  EXPECT_THAT(next.history[1].changes, testing::Contains("objects.recall: 0.7000 -> 0.8000"));
}

TEST(Baseline, AnEditedFileIsNoticed) {
  const Folder folder;
  const auto path = folder.path / "b.json";
  write_baseline(path, update_baseline({}, run_of(7), "the first one ever", "2026-11-22"));
  std::string text = read_file(path);
  text.replace(text.rfind("\"found\":7"), 9, "\"found\":9");
  write_file(path, text);
  try {
    read_baseline(path);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("is not the sum of the scenes"));
  }
  write_file(path, "{}");
  EXPECT_THROW(read_baseline(path), Error);
}

}  // namespace
}  // namespace scanchor
