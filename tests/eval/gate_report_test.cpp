#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "eval/gate.hpp"

namespace scanchor {
namespace {

GateReport example() {
  GateReport report;
  report.suite = "office <&\"> suite";
  report.data = "office/test (0123)";
  report.protocol = "scanchor-1 v1 (abc)";
  report.before_method = report.after_method = "default";
  report.scenes = 100;
  report.verdict = Verdict::regressed;
  GateMetric bad{"objects.f1", 0.80, 0.77, {-0.04, -0.02}, 0.0005, 0.002, Verdict::regressed};
  GateMetric open{"points.miou", 0.60, 0.595, {-0.02, 0.01}, 0.2, 0.4, Verdict::inconclusive};
  GateMetric good{"planes.f1", 0.90, 0.91, {0.001, 0.02}, 0.9, 1.0, Verdict::improved};
  report.gated = {bad, open, good};
  report.classes = {{"objects.f1.desk", 0.9, 0.8, {-0.15, -0.05}, 0.001}};
  report.worst = {{17, "017", "office", 99, -0.2}};
  return report;
}

TEST(GateReport, JsonHasVerdictAndNumbers) {
  const auto json = gate_to_json(example());
  EXPECT_EQ(json["verdict"], "regressed");
  EXPECT_EQ(json["exit_code"], 1);
  EXPECT_NEAR(json["metrics"][0]["difference"].get<double>(), -0.03, 1e-12);
  EXPECT_EQ(json["worst_scenes"][0]["seed"], 99);
}

TEST(GateReport, JunitCountsAndEscapes) {
  const auto xml = gate_to_junit(example());
  EXPECT_THAT(xml, testing::HasSubstr("tests=\"4\" failures=\"1\" skipped=\"1\""));
  EXPECT_THAT(xml, testing::HasSubstr("office &lt;&amp;&quot;&gt; suite"));
  EXPECT_THAT(xml, testing::Not(testing::HasSubstr("<&")));
}

TEST(GateReport, MarkdownIsATable) {
  const auto text = gate_to_markdown(example());
  EXPECT_THAT(text,
              testing::HasSubstr(
                  "| objects.f1 | 80.00 | 77.00 | -3.00 | -4.00 .. -2.00 | 0.0020 | regressed |"));
  EXPECT_THAT(text, testing::HasSubstr("| desk | 90.00 | 80.00 | -10.00 |"));
}

TEST(GateReport, TextNamesClassMetricSceneAndInterval) {
  const auto text = gate_to_text(example());
  for (const char* part : {"regressed over 100 scenes", "objects.f1        80.00  77.00   -3.00",
                           "-4.00 .. -2.00", "class desk", "scene 017"}) {
    EXPECT_THAT(text, testing::HasSubstr(part));
  }
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(GateReport, BencherHasValueAndBounds) {
  const auto json = gate_to_bencher(example());
  const auto& measure = json.begin().value()["objects.f1"];
  EXPECT_NEAR(measure["lower_value"].get<double>(), 0.76, 1e-12);
  EXPECT_NEAR(measure["upper_value"].get<double>(), 0.78, 1e-12);
}

}  // namespace
}  // namespace scanchor
