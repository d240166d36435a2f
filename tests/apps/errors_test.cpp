// Bad input, as a table: each row gives one clear line, the right exit code, and leaves nothing
// behind.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "core/file.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::lines_of;
using testing_support::run_scanchor;
using testing_support::scratch;

std::string pcd_header(std::size_t points, const std::string& data) {
  const std::string count = std::to_string(points);
  return "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + count +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count + "\nDATA " + data + "\n";
}

std::string repeated(const std::string& line, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += line;
  return text;
}

struct BadInput {
  const char* name;
  const char* file;  ///< written before the run; empty: none
  std::string content;
  const char* arguments;  ///< of scanchor
  int code;
  const char* message;  ///< must occur in the one line
};

class Errors : public testing::TestWithParam<BadInput> {};

TEST_P(Errors, OneClearLineTheRightCodeAndNothingWritten) {
  const BadInput& bad = GetParam();
  if (*bad.file != '\0') write_file(scratch() + bad.file, bad.content);
  std::filesystem::remove_all(scratch() + "out");
  const auto ran = run_scanchor(bad.arguments);
  EXPECT_EQ(ran.code, bad.code) << ran.out << ran.error;
  EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
  EXPECT_NE(ran.error.find(bad.message), std::string::npos) << ran.error;
  EXPECT_FALSE(std::filesystem::exists(scratch() + "out/labels.json"));
  EXPECT_FALSE(std::filesystem::exists(scratch() + "out.ply"));
  EXPECT_FALSE(std::filesystem::exists(scratch() + "out.png"));
}

std::string random_cube_points(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(0.F, 5.F);
  std::string bytes = pcd_header(static_cast<std::size_t>(count), "binary");
  for (int i = 0; i < 3 * count; ++i) {
    const float value = uniform(random);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  return bytes;
}

INSTANTIATE_TEST_SUITE_P(
    Label, Errors,
    testing::Values(
        BadInput{"empty_file", "empty.pcd", "", "label empty.pcd --out out", 3, "empty"},
        BadInput{"absent_file", "", "", "label absent.pcd --out out", 3, "No such file"},
        BadInput{"folder", "", "", "label . --out out", 3, "folder"},
        BadInput{"truncated_pcd", "short.pcd", pcd_header(100, "binary") + "only a few bytes",
                 "label short.pcd --out out", 3, "short.pcd"},
        BadInput{"unknown_format", "picture.gif", "GIF89a and so on\n",
                 "label picture.gif --out out", 3, "picture.gif"},
        BadInput{"only_not_a_number", "nan.xyz", repeated("nan nan nan\n", 50),
                 "label nan.xyz --out out", 4, "finite"},
        BadInput{"only_infinite", "inf.xyz", repeated("inf 0 0\n", 50), "label inf.xyz --out out",
                 4, "finite"},
        BadInput{"one_point", "one.xyz", "1 2 3\n", "label one.xyz --out out", 4,
                 "no planar surface"},
        BadInput{"all_in_one_place", "same.xyz", repeated("1 2 3\n", 5000),
                 "label same.xyz --out out", 4, "no planar surface"},
        BadInput{"missing_ontology", "one.xyz", "1 2 3\n",
                 "label one.xyz --ontology ofice --out out", 3, "did you mean 'office'?"},
        BadInput{"bad_up", "one.xyz", "1 2 3\n", "label one.xyz --up 1,2 --out out", 2, "--up"},
        BadInput{"unknown_option", "one.xyz", "1 2 3\n",
                 "label one.xyz --set perceive.nois_sigma=1 --out out", 2,
                 "did you mean 'perceive.noise_sigma'?"},
        BadInput{"unknown_verb", "", "", "lable one.xyz", 2, "scanchor"},
        BadInput{"segment_one_point", "one.xyz", "1 2 3\n", "segment one.xyz --points out.ply", 4,
                 "no planar surface"}),
    [](const auto& row) { return std::string(row.param.name); });

INSTANTIATE_TEST_SUITE_P(
    OtherVerbs, Errors,
    testing::Values(
        BadInput{"score_absent_truth", "", "", "score --truth absent --method default", 3,
                 "holds no data set"},
        BadInput{"score_without_answer", "", "", "score --truth absent", 2, "exactly one of"},
        BadInput{"score_two_answers", "", "",
                 "score --truth absent --predictions mine --method paper", 2, "exactly one of"},
        BadInput{"render_broken_scene", "scene.json",
                 "{\"format\": ", "render scene.json --out out.png", 3, "line 1, column 12"},
        BadInput{"render_other_json", "other.json", "{}", "render other.json --out out.png", 3,
                 "other.json"},
        BadInput{"render_only_not_a_number", "nan.xyz", repeated("nan nan nan\n", 50),
                 "render nan.xyz --out out.png", 4, "finite"},
        BadInput{"render_absent_cloud", "", "", "render absent.pcd --out out.png", 3,
                 "No such file"},
        BadInput{"render_unknown_color", "one.xyz", "1 2 3\n",
                 "render one.xyz --color hight --out out.png", 2, "height"},
        BadInput{"explain_absent_folder", "", "", "explain absent 3", 3, "absent/labels.json"},
        BadInput{"check_absent_baseline", "", "", "check quick --scenes 1 --baseline absent.json",
                 3, "absent.json"},
        BadInput{"check_broken_baseline", "broken.json", "[1,",
                 "check quick --scenes 1 --baseline broken.json", 3, "broken.json"},
        BadInput{"sweep_unknown_option", "", "",
                 "sweep quick --vary lidar.range_sigm=0..1 --out out", 2,
                 "did you mean 'lidar.range_sigma'?"},
        BadInput{"blame_unknown_suite", "", "", "blame quikc", 3, "did you mean 'quick'?"},
        BadInput{"report_absent_run", "", "", "report absent", 3, "absent"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(Errors, GenerateLeavesAnotherDataSetAlone) {
  ASSERT_EQ(run_scanchor("generate quick --scenes 1 --out data -q").code, 0);
  const std::string before = read_file(scratch() + "data/suite.json");
  const auto ran = run_scanchor("generate office --scenes 1 --out data");
  EXPECT_EQ(ran.code, 3) << ran.out << ran.error;
  EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
  EXPECT_NE(ran.error.find("holds another data set"), std::string::npos) << ran.error;
  EXPECT_EQ(read_file(scratch() + "data/suite.json"), before);
}

TEST(Errors, AMillionRandomPointsInACubeAreNoSurfaces) {
  write_file(scratch() + "cube.pcd", random_cube_points(1'000'000));
  const auto ran = run_scanchor("label cube.pcd --out cube-out");
  EXPECT_EQ(ran.code, 4) << ran.out << ran.error;
  EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
  EXPECT_NE(ran.error.find("no planar surface"), std::string::npos) << ran.error;
}

TEST(Errors, AnUnwritableFolderIsOneLineForEveryVerbThatWrites) {
  write_file(scratch() + "file", "in the way");
  std::string square;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y)
      square += std::to_string(x * 0.02) + " " + std::to_string(y * 0.02) + " 0\n";
  }
  write_file(scratch() + "square.xyz", square);
  for (const std::string arguments :
       {"label square.xyz --out file/below", "run --scenes 1 --out file/below",
        "generate quick --scenes 1 --out file/below"}) {
    const auto ran = run_scanchor(arguments);
    EXPECT_EQ(ran.code, 3) << arguments << "\n" << ran.out << ran.error;
    EXPECT_EQ(lines_of(ran.error), 1) << arguments << "\n" << ran.error;
  }
}

}  // namespace
}  // namespace scanchor
