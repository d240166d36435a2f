#include "results/report_sweeps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/json.hpp"

namespace scanchor {
namespace {

Json point(std::vector<double> values, double f1) {
  Json json = Json::object();
  json["values"] = values;
  json["gated"] = {{"objects.f1", f1}, {"planes.f1", f1 / 2}};
  json["intervals"] = {{"objects.f1", {f1 - 0.1, f1 + 0.1}}, {"planes.f1", {0.0, 1.0}}};
  return json;
}

Json one_axis() {
  Json json;
  json["format"] = "scanchor-sweep";
  json["axes"] = Json::array({{{"option", "lidar.range_sigma"}, {"values", {0.0, 0.02}}}});
  json["points"] = Json::array({point({0.0}, 0.8), point({0.02}, 0.5)});
  return json;
}

TEST(ReportSweeps, OneAxisIsACurveForEachMetricWithItsInterval) {
  const Json plots = report_sweeps(one_axis(), "sweep.json");
  ASSERT_EQ(plots.size(), 1U);
  EXPECT_EQ(plots[0]["axis"], "lidar.range_sigma");
  EXPECT_EQ(plots[0]["x"], Json({0.0, 0.02}));
  ASSERT_EQ(plots[0]["curves"].size(), 2U);
  EXPECT_EQ(plots[0]["curves"][0]["name"], "objects.f1");
  EXPECT_EQ(plots[0]["curves"][0]["value"], Json({0.8, 0.5}));
  EXPECT_EQ(plots[0]["curves"][0]["low"], Json({0.8 - 0.1, 0.5 - 0.1}));
}

TEST(ReportSweeps, SeveralMethodsAreComparedMetricByMetric) {
  Json json = one_axis();
  json["methods"] =
      Json::array({{{"method", "default/default/office"}, {"points", json["points"]}},
                   {{"method", "paper/paper/office"},
                    {"points", Json::array({point({0.0}, 0.4), point({0.02}, 0.3)})}}});
  const Json plots = report_sweeps(json, "sweep.json");
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_EQ(plots[1]["measure"], "objects.f1");
  EXPECT_EQ(plots[1]["curves"][1]["name"], "paper");
  EXPECT_EQ(plots[1]["curves"][1]["value"], Json({0.4, 0.3}));
  EXPECT_EQ(plots[2]["measure"], "planes.f1");
}

TEST(ReportSweeps, TwoAxesAreACurveForEachValueOfTheSecond) {
  Json json = one_axis();
  json["axes"].push_back({{"option", "lidar.lines"}, {"values", {50, 100, 200}}});
  json["points"] = Json::array();
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 3; ++b)
      json["points"].push_back(point({0.02 * a, 50.0}, 0.1 * (3 * a + b)));
  }
  const Json plots = report_sweeps(json, "sweep.json");
  ASSERT_EQ(plots.size(), 1U);
  ASSERT_EQ(plots[0]["curves"].size(), 3U);
  EXPECT_EQ(plots[0]["curves"][2]["name"], "lidar.lines 200");
  EXPECT_NEAR(plots[0]["curves"][2]["value"][1].get<double>(), 0.5, 1e-12);
}

TEST(ReportSweeps, WhatIsNoSweepIsRefusedByName) {
  for (const auto& json : {Json{{"format", "scanchor-run"}}, Json::object()}) {
    try {
      report_sweeps(json, "some/sweep.json");
      FAIL();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("some/sweep.json"));
    }
  }
  EXPECT_THROW(read_report_sweeps("/nowhere", {"/nowhere/either"}), Error);
  EXPECT_TRUE(read_report_sweeps("/nowhere", {}).empty());
}

}  // namespace
}  // namespace scanchor
