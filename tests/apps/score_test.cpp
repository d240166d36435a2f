// Bad predictions, as a table: each row gives one clear line, its exit code, and no score.

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "cloud/io.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

namespace fs = std::filesystem;
using testing_support::lines_of;
using testing_support::run_scanchor;
using testing_support::scratch;

/// A data set of two small scans, made once.
const fs::path& data_set() {
  static const fs::path folder = [] {
    const auto ran = run_scanchor(
        "generate quick --scenes 2 --set lidar.lines=20 --set lidar.beams_per_line=80 --ply "
        "--quiet --out score-data");
    EXPECT_EQ(ran.code, 0) << ran.error;
    return fs::path(scratch()) / "score-data";
  }();
  return folder;
}

std::size_t points_of_scan(const std::string& sequence) {
  return fs::file_size(data_set() / "sequences" / sequence / "labels" / "000000.label") / 4;
}

std::string rows(std::size_t count, std::uint32_t word) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    for (unsigned b = 0; b < 4; ++b) bytes += static_cast<char>(word >> (8 * b) & 0xffU);
  }
  return bytes;
}

void put(const fs::path& folder, const std::string& name, const std::string& bytes) {
  fs::create_directories((folder / name).parent_path());
  write_file(folder / name, bytes);
}

/// The scan as PLY with a label field.
PointCloud labelled_scan() {
  PointCloud cloud;
  for (const auto& entry : fs::recursive_directory_iterator(data_set() / "sequences" / "00")) {
    if (entry.path().extension() == ".ply") cloud = read_cloud(entry.path());
  }
  EXPECT_EQ(cloud.size(), points_of_scan("00"));
  cloud.fields.clear();
  cloud.set({"label", std::vector<std::int32_t>(cloud.size(), 1)});
  return cloud;
}

struct BadPrediction {
  const char* name;
  std::function<void(const fs::path& folder)> make;
  const char* arguments;  ///< beside --truth and --predictions
  const char* message;
  int code = 3;
  friend void PrintTo(const BadPrediction& bad, std::ostream* out) { *out << bad.name; }
};

class BadPredictions : public testing::TestWithParam<BadPrediction> {};

TEST_P(BadPredictions, AreOneClearLineAndNoScore) {
  const BadPrediction& bad = GetParam();
  const fs::path folder = fs::path(scratch()) / "mine";
  fs::remove_all(folder);
  fs::create_directories(folder);
  bad.make(folder);
  const auto ran = run_scanchor("score --truth " + data_set().string() + " --predictions " +
                                folder.string() + " --out mine-scores.json " + bad.arguments);
  EXPECT_EQ(ran.code, bad.code) << ran.out << ran.error;
  EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
  EXPECT_NE(ran.error.find(bad.message), std::string::npos) << ran.error;
  EXPECT_EQ(ran.out, "");
  EXPECT_FALSE(fs::exists(scratch() + "mine-scores.json"));
}

const std::string first = "sequences/00/predictions/000000.label";

INSTANTIATE_TEST_SUITE_P(
    Table, BadPredictions,
    testing::Values(
        BadPrediction{"no_predictions", [](const fs::path&) {}, "", "no prediction for any scan",
                      4},
        BadPrediction{"wrong_label_map",
                      [](const fs::path& f) { put(f, first, rows(points_of_scan("00"), 252)); }, "",
                      "label 252"},
        BadPrediction{"label_missing_in_the_map",
                      [](const fs::path& f) {
                        put(f, first, rows(points_of_scan("00"), 252));
                        put(f, "map.yaml", "40: floor\n");
                      },
                      "--label-map mine/map.yaml", "not in the label map"},
        BadPrediction{"label_map_with_an_unknown_class",
                      [](const fs::path& f) {
                        put(f, first, rows(points_of_scan("00"), 1));
                        put(f, "map.yaml", "1: flor\n");
                      },
                      "--label-map mine/map.yaml", "did you mean 'floor'?"},
        BadPrediction{"fewer_rows_than_points",
                      [](const fs::path& f) { put(f, first, rows(points_of_scan("00") - 1, 1)); },
                      "", "every point needs a row"},
        BadPrediction{"more_rows_than_points",
                      [](const fs::path& f) { put(f, first, rows(points_of_scan("00") + 1, 1)); },
                      "", "another scan"},
        BadPrediction{
            "ends_within_a_row",
            [](const fs::path& f) { put(f, first, rows(points_of_scan("00"), 1).substr(1)); }, "",
            "ends within a row"},
        BadPrediction{"other_order_of_points",
                      [](const fs::path& f) {
                        PointCloud cloud = labelled_scan();
                        std::reverse(cloud.points.begin(), cloud.points.end());
                        fs::create_directories(f / "00");
                        write_cloud(f / "00/000000.ply", cloud);
                      },
                      "", "another order of points"},
        BadPrediction{"nan_label",
                      [](const fs::path& f) {
                        PointCloud cloud = labelled_scan();
                        std::vector<float> labels(cloud.size(), 1.0F);
                        labels[3] = std::nanf("");
                        cloud.fields.clear();
                        cloud.set({"label", labels});
                        fs::create_directories(f / "00");
                        write_cloud(f / "00/000000.ply", cloud);
                      },
                      "", "point 3"},
        BadPrediction{"duplicate_object_id",
                      [](const fs::path& f) {
                        put(f, "00/000000.json",
                            R"({"objects": [{"id": 1, "class": "desk", "points": [1]},)"
                            R"({"id": 1, "class": "desk", "points": [2]}]})");
                      },
                      "", "is the id of two objects"},
        BadPrediction{"point_claimed_twice",
                      [](const fs::path& f) {
                        put(f, "00/000000.json",
                            R"({"objects": [{"id": 1, "class": "desk", "points": [1]},)"
                            R"({"id": 2, "class": "desk", "points": [1]}]})");
                      },
                      "", "belongs to two objects"},
        BadPrediction{"prediction_for_an_unknown_scan",
                      [](const fs::path& f) {
                        put(f, first, rows(points_of_scan("00"), 1));
                        put(f, "sequences/00/predictions/000007.label", rows(3, 1));
                      },
                      "", "a scan that the data set does not have"},
        BadPrediction{"two_predictions_for_one_scan",
                      [](const fs::path& f) {
                        put(f, first, rows(points_of_scan("00"), 1));
                        put(f, "00/000000.label", rows(points_of_scan("00"), 1));
                      },
                      "", "a second prediction"},
        BadPrediction{
            "truth_and_predictions_swapped",
            [](const fs::path& f) { put(f, "sequences/00/labels/000000.label", rows(3, 1)); }, "",
            "swapped"}),
    [](const auto& row) { return row.param.name; });

TEST(ScoreCommand, AMissingScanIsMissedAndListedNotSilentlyLeftOut) {
  const fs::path folder = fs::path(scratch()) / "mine";
  fs::remove_all(folder);
  const std::size_t count = points_of_scan("00");
  put(folder, first, read_file(data_set() / "sequences/00/labels/000000.label"));
  ASSERT_GT(count, 0U);
  const auto ran = run_scanchor("score --json --truth " + data_set().string() + " --predictions " +
                                folder.string());
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Json json = Json::parse(ran.out);
  EXPECT_EQ(json.at("scans"), 2);
  EXPECT_EQ(json.at("failed").size(), 1U);
  EXPECT_EQ(json.at("failed")[0], "01/000000: no prediction");
  EXPECT_LT(json.at("metrics").at("objects.recall").get<double>(), 1.0);
}

TEST(ScoreCommand, SeveralMethodsGoOverOneSuite) {
  const auto ran = run_scanchor(
      "score --suite quick --split train --scenes 1 --method default --method paper --json --set "
      "lidar.lines=40 --set lidar.beams_per_line=100");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Json json = Json::parse(ran.out);
  ASSERT_EQ(json.at("methods").size(), 2U);
  for (const auto& [name, score] : json.at("methods").items()) {
    EXPECT_EQ(score.at("data"), json.at("methods").begin()->at("data")) << name;
    EXPECT_TRUE(score.at("metrics").contains("relations.recall")) << name;
  }
}

TEST(ScoreCommand, OneKindOfTruthAndOneKindOfAnswer) {
  for (const char* arguments :
       {"score --method default", "score --truth a --suite quick --method default",
        "score --suite quick", "score --suite quick --predictions mine",
        "score --suite quick --method default --pipeline 'x {scan} {out}'",
        "score --suite quick --method nonsense", "score --suite quick --method cgal-nonsense"}) {
    const auto ran = run_scanchor(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << ran.error;
    EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
  }
}

TEST(ScoreCommand, AProgramThatAnswersNothingIsNoScore) {
  const auto ran = run_scanchor(
      "score --suite quick --scenes 1 --pipeline 'false {scan} {out}' --set lidar.lines=40 "
      "--set lidar.beams_per_line=100");
  EXPECT_EQ(ran.code, 4) << ran.error;
  EXPECT_EQ(lines_of(ran.error), 1) << ran.error;
  EXPECT_NE(ran.error.find("not one of 1 scans got an answer"), std::string::npos) << ran.error;
}

}  // namespace
}  // namespace scanchor
