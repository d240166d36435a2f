#include "eval/predictions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>

#include "cloud/io.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {
namespace {

using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

class Predictions : public testing::Test {
 protected:
  fs::path folder =
      fs::temp_directory_path() / ("scanchor-predictions-" + std::to_string(getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
  fs::path put(const std::string& name, const std::string& text) {
    fs::create_directories((folder / name).parent_path());
    write_file(folder / name, text);
    return folder / name;
  }
  static std::string rows(const std::vector<std::uint32_t>& words) {
    std::string bytes;
    for (const auto word : words) {
      for (unsigned b = 0; b < 4; ++b) bytes += static_cast<char>(word >> (8 * b) & 0xffU);
    }
    return bytes;
  }
  static std::string failure(const fs::path& path, std::size_t points,
                             const PredictionOptions& options = {}) {
    try {
      read_prediction(path, points, options);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::bad_data);
      return error.what();
    }
    return "no error";
  }
};

TEST_F(Predictions, SemanticKittiRows) {
  const auto p = read_prediction(put("a.label", rows({8, 12 | 7U << 16U, 0})), 3);
  EXPECT_EQ(p.class_id, (std::vector<std::int32_t>{8, 12, 0}));
  EXPECT_EQ(p.instance, (std::vector<std::int32_t>{-1, 7, -1}));
}

TEST_F(Predictions, LabelFilesComeBack) {
  PointPrediction p;
  p.class_id = {8, 8, 12, 0};
  p.instance = {500000, 500000, 3, -1};
  write_prediction_label(folder / "b.label", p);
  const auto read = read_prediction(folder / "b.label", 4);
  EXPECT_EQ(read.class_id, p.class_id);
  EXPECT_EQ(read.instance, (std::vector<std::int32_t>{1, 1, 2, -1}));
}

TEST_F(Predictions, WrongNumberOfRows) {
  EXPECT_THAT(
      failure(put("a.label", rows({8, 8})), 3),
      AllOf(HasSubstr("has 2 rows, the scan has 3 points"), HasSubstr("every point needs a row")));
  EXPECT_THAT(failure(put("a.label", rows({8, 8})), 1), HasSubstr("another scan"));
  EXPECT_THAT(failure(put("a.label", "abcde"), 1), HasSubstr("ends within a row"));
}

TEST_F(Predictions, WrongLabelMap) {
  EXPECT_THAT(failure(put("a.label", rows({8, 252})), 2),
              AllOf(HasSubstr("point 1"), HasSubstr("label 252"), HasSubstr("--label-map")));
  PredictionOptions options;
  options.label_map = {{252, 8}};
  EXPECT_EQ(read_prediction(put("a.label", rows({0, 252})), 2, options).class_id,
            (std::vector<std::int32_t>{0, 8}));
  EXPECT_THAT(failure(put("a.label", rows({252, 30})), 2, options),
              HasSubstr("label 30 is not in the label map"));
}

TEST_F(Predictions, LabelMapsAreReadByName) {
  using Map = std::vector<std::pair<std::int32_t, std::int32_t>>;
  EXPECT_EQ(read_label_map(put("m.yaml", "labels:\n  0: unlabeled\n  52: desk\n  60: screen\n")),
            (Map{{0, 0}, {52, 8}, {60, 21}}));
  const auto fails = [&](const char* text) {
    try {
      read_label_map(put("m.yaml", text));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(fails("1: desk\n2: dexk\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("did you mean 'desk'?")));
  EXPECT_THAT(fails("1: desk\n1: chair\n"), HasSubstr("twice"));
  EXPECT_THAT(fails("desk: 1\n"), HasSubstr("whole number"));
}

TEST_F(Predictions, FieldsOfClouds) {
  PointCloud cloud;
  cloud.points.resize(2, Eigen::Vector3d::Zero());
  cloud.set({"label", std::vector<std::int32_t>{8, 0}});
  cloud.set({"instance", std::vector<std::int32_t>{4, -1}});
  cloud.set({"confidence", std::vector<float>{0.5F, 1.0F}});
  for (const char* name : {"c.ply", "c.pcd"}) {
    write_cloud(folder / name, cloud);
    const auto p = read_prediction(folder / name, 2);
    EXPECT_EQ(p.class_id, (std::vector<std::int32_t>{8, 0})) << name;
    EXPECT_EQ(p.instance, (std::vector<std::int32_t>{4, -1})) << name;
    EXPECT_FLOAT_EQ(p.confidence[0], 0.5F);
  }
  PredictionOptions options;
  options.label_field = "lable";
  EXPECT_THAT(failure(folder / "c.ply", 2, options), HasSubstr("did you mean 'label'?"));
}

TEST_F(Predictions, AnotherOrderOfPointsIsSeenByTheirPositions) {
  PointCloud scan;
  scan.points = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  PointCloud cloud = scan;
  cloud.set({"label", std::vector<std::int32_t>{8, 0, 8}});
  write_cloud(folder / "same.ply", cloud);
  EXPECT_EQ(read_prediction(folder / "same.ply", scan).class_id[2], 8);
  std::swap(cloud.points[1], cloud.points[2]);
  write_cloud(folder / "other.ply", cloud);
  try {
    read_prediction(folder / "other.ply", scan);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("point 1"), HasSubstr("another order of points")));
  }
  for (auto& p : cloud.points) p.setZero();  // labels only
  write_cloud(folder / "none.ply", cloud);
  EXPECT_EQ(read_prediction(folder / "none.ply", scan).class_id[0], 8);
}

TEST_F(Predictions, NanAndFractionsAreNoLabels) {
  PointCloud cloud;
  cloud.points.resize(2, Eigen::Vector3d::Zero());
  cloud.set({"label", std::vector<float>{8.0F, std::nanf("")}});
  write_cloud(folder / "c.ply", cloud);
  EXPECT_THAT(failure(folder / "c.ply", 2),
              AllOf(HasSubstr("point 1"), HasSubstr("whole numbers")));
  cloud.set({"label", std::vector<float>{8.5F, 0.0F}});
  write_cloud(folder / "c.ply", cloud);
  EXPECT_THAT(failure(folder / "c.ply", 2), HasSubstr("point 0"));
}

TEST_F(Predictions, ObjectsOfJson) {
  const auto p = read_prediction(
      put("a.json",
          R"({"objects": [{"id": 3, "class": "screen", "probability": 0.75, "points": [1, 2]}]})"),
      4);
  EXPECT_EQ(p.class_id, (std::vector<std::int32_t>{0, 21, 21, 0}));
  EXPECT_EQ(p.instance, (std::vector<std::int32_t>{-1, 3, 3, -1}));
  EXPECT_FLOAT_EQ(p.confidence[1], 0.75F);
}

TEST_F(Predictions, BrokenJsonIsNamed) {
  const auto fails = [&](const char* text) { return failure(put("a.json", text), 4); };
  EXPECT_THAT(
      fails(
          R"({"objects": [{"id": 3, "class": "desk", "points": [1]}, {"id": 3, "class": "desk", "points": [2]}]})"),
      HasSubstr("objects[1].id: is the id of two objects"));
  EXPECT_THAT(
      fails(R"({"objects": [{"class": "desk", "points": [1]}, {"class": "desk", "points": [1]}]})"),
      HasSubstr("belongs to two objects"));
  EXPECT_THAT(fails(R"({"objects": [{"class": "desk", "points": [9]}]})"),
              HasSubstr("the scan has 4"));
  EXPECT_THAT(fails(R"({"objects": [{"class": "desc", "points": [1]}]})"),
              HasSubstr("did you mean 'desk'?"));
  EXPECT_THAT(fails(R"({"objects": [{"class": "desk", "points": 12}]})"),
              HasSubstr("list of point indices"));
  EXPECT_THAT(fails(R"({"objects": [{"class": "desk", "probability": 2, "points": [1]}]})"),
              HasSubstr("0 .. 1"));
  EXPECT_THAT(fails(R"({"label": [8, 8, 8]})"), HasSubstr("3 rows"));
  EXPECT_THAT(fails(R"({"label": [8, 8, 8, 8], "confidence": [1, 1, 1, 7]})"),
              HasSubstr("point 3"));
  EXPECT_THAT(fails("{\"label\""), HasSubstr("a.json: line 1"));
  EXPECT_THAT(failure(put("a.txt", "8"), 1), HasSubstr("is no prediction"));
}

Dataset two_sequences() {
  Dataset dataset;
  dataset.sequences = {{"00", "train", {}, {"000000", "000001"}}, {"01", "test", {}, {"000000"}}};
  return dataset;
}

TEST_F(Predictions, FoldersArePairedWithTheDataSet) {
  put("sequences/00/predictions/000001.label", "");
  put("01/000000.json", "{}");
  const auto found = find_predictions(folder, two_sequences());
  ASSERT_EQ(found.files.size(), 2U);
  EXPECT_EQ(found.files[0].scan, "000001");
  EXPECT_EQ(found.files[1].sequence, "01");
  EXPECT_EQ(found.missing, std::vector<std::string>{"00/000000"});
  EXPECT_EQ(find_predictions(folder, two_sequences(), "test").files.size(), 1U);
}

TEST_F(Predictions, StrangersDoublesAndSwappedFoldersAreErrors) {
  const auto fails = [&] {
    try {
      find_predictions(folder, two_sequences());
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(fails(), HasSubstr("no prediction for any scan"));
  fs::create_directories(folder / "sequences/00/labels");
  EXPECT_THAT(fails(), HasSubstr("were --truth and --predictions swapped?"));
  put("sequences/00/predictions/000000.label", "");
  put("sequences/00/predictions/000007.label", "");
  EXPECT_THAT(fails(), HasSubstr("a scan that the data set does not have"));
  fs::remove(folder / "sequences/00/predictions/000007.label");
  put("00/000000.ply", "");
  EXPECT_THAT(fails(), HasSubstr("a second prediction for scan 00/000000"));
}

}  // namespace
}  // namespace scanchor
