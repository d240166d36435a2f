#include "results/score_plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/file.hpp"
#include "eval/truth.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

TEST(ScorePlots, WilsonsIntervalHoldsTheShareAndStaysWithinZeroAndOne) {
  LabelScore labels;
  labels.reliability.resize(3);
  labels.reliability[1].count = 1;
  labels.reliability[1].right = 1;
  labels.reliability[1].probability.add(0.5);
  labels.reliability[2].count = 100;
  labels.reliability[2].right = 80;
  labels.reliability[2].probability.add(90.0);
  const auto points = reliability_points(labels);
  ASSERT_EQ(points.size(), 2U);              // the empty bin is left out
  EXPECT_NEAR(points[0].low, 0.2065, 1e-4);  // one of one: Wilson's lower end, by hand
  EXPECT_NEAR(points[0].high, 1.0, 1e-12);
  EXPECT_NEAR(points[1].stated, 0.9, 1e-9);
  EXPECT_NEAR(points[1].low, 0.7112, 1e-4);
  EXPECT_NEAR(points[1].high, 0.8666, 1e-4);
}

TEST(ScorePlots, OnlyWhatWasMeasuredIsDrawn) {
  const auto folder = std::filesystem::temp_directory_path() / "scanchor-score-plots";
  std::filesystem::remove_all(folder);
  const Protocol protocol;
  EXPECT_TRUE(write_score_plots(folder, Score{}, protocol, "nothing").empty());
  Score score;
  score.planes.truths = 4;
  score.planes.regions = 4;
  score.planes.hoover.resize(protocol.plane_tolerances.size());
  for (auto& one : score.planes.hoover) one.correct = 3;
  const auto files = write_score_plots(folder, score, protocol, "mine");
  ASSERT_EQ(files.size(), 1U);
  const std::string svg = read_file(files.front());
  EXPECT_THAT(svg, testing::HasSubstr("Planes by Hoover"));
  EXPECT_THAT(svg, testing::HasSubstr("mine"));
  EXPECT_TRUE(std::filesystem::exists(folder / "planes.png"));
  std::filesystem::remove_all(folder);
}

TEST(ScorePlots, ConfusionKeepsTheLargestClasses) {
  PointScore points;
  points.classes = class_list().size();
  points.confusion.assign(points.classes * points.classes, 0);
  for (std::size_t c = 1; c < 6; ++c)
    points.confusion[c * points.classes + c] = static_cast<std::int64_t>(10 * c);
  const std::string svg = to_svg(confusion_plot(points, "", 2));
  EXPECT_THAT(svg, testing::HasSubstr(std::string(class_info(5).name)));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr(">" + std::string(class_info(1).name) + "<")));
}

TEST(ScorePlots, NamesBecomeFileNames) {
  EXPECT_EQ(file_name_of("default/paper/my words"), "default-paper-my-words");
  EXPECT_EQ(file_name_of("v1.2"), "v1.2");
}

}  // namespace
}  // namespace scanchor
