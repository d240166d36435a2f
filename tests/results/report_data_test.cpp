#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "results/report.hpp"
#include "tests/results/run_sample.hpp"

namespace scanchor {
namespace {

TEST(ReportData, CountsAndClasses) {
  const Json data = report_data(samples::run_summary(9, 1), nullptr, "summary.json");
  EXPECT_EQ(data["there"], 12);
  EXPECT_EQ(data["found"], 9);
  EXPECT_EQ(data["claims"], 10);
  ASSERT_EQ(data["by_class"].size(), 1u);
  EXPECT_EQ(data["by_class"][0]["class"], *find_class("desk"));
  EXPECT_NEAR(data["by_class"][0]["recall"].get<double>(), 0.75, 1e-12);
  EXPECT_EQ(data["classes"][*find_class("desk")][0], "desk");
  EXPECT_EQ(data["scenes"].size(), 2u);
  EXPECT_GT(data["metrics"].size(), 5u);
}

TEST(ReportData, TheSentenceSaysIt) {
  EXPECT_EQ(report_sentence(report_data(samples::run_summary(9, 1), nullptr, "summary.json")),
            "Of 12 things in 2 rooms, 9 were found (75 %); of 10 claims, 9 were right (90 %).");
}

TEST(ReportData, ComparesWithABaseline) {
  const Json before = samples::run_summary(8, 1);
  const Json data = report_data(samples::run_summary(9, 1), &before, "summary.json");
  bool compared = false;
  for (const auto& metric : data["metrics"]) {
    if (metric["name"] == "objects.recall") {
      compared = true;
      EXPECT_NEAR(metric["before"].get<double>(), 8.0 / 12.0, 1e-12);
    }
  }
  EXPECT_TRUE(compared);
}

TEST(ReportData, OtherDataCannotBeCompared) {
  Json before = samples::run_summary(8, 1);
  before["score"]["data"] = "something else";
  const Json after = samples::run_summary(9, 1);
  EXPECT_THROW(report_data(after, &before, "summary.json"), Error);
}

TEST(ReportData, ASeedKeepsAllItsDigits) {
  Json summary = samples::run_summary(9, 1);
  summary["rooms"][0]["seed"] = 653413151813739762;
  EXPECT_EQ(report_data(summary, nullptr, "summary.json")["scenes"][0]["seed"],
            "653413151813739762");
}

TEST(ReportData, ABrokenSummaryIsNamed) {
  Json summary = samples::run_summary(9, 1);
  summary.erase("rooms");
  try {
    report_data(summary, nullptr, "run/summary.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("run/summary.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace scanchor
