#include "results/report_scene.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/json.hpp"
#include "tests/results/surface_samples.hpp"

namespace scanchor {
namespace {

Scan sample_scan() {
  Scan scan;
  scan.cloud.points = {{0, 0, 0.72}, {0.1, 0, 0.72}, {0, 0, 1.1}, {3, 3, 0}};
  scan.truth.resize(4);
  scan.truth.class_id = {*find_class("desk"), *find_class("desk"), *find_class("monitor"),
                         *find_class("floor")};
  return scan;
}

TEST(ReportScene, HoldsPointsSurfacesAndProof) {
  const Json json = Json::parse(
      report_scene("a", sample_scan(), samples::two_surfaces(), samples::two_labels(), 100));
  EXPECT_EQ(json["points"].size(), 12u);
  EXPECT_EQ(json["points"][5], 720);
  EXPECT_EQ(json["truth"][2], *find_class("monitor"));
  EXPECT_EQ(json["said"].size(), 4u);
  ASSERT_EQ(json["surfaces"].size(), 2u);
  EXPECT_EQ(json["surfaces"][0]["rings"], (Json{4, 4}));
  EXPECT_EQ(json["surfaces"][0]["triangles"].size(), 3u * 8u);  // a ring of 4 with a hole of 4
  ASSERT_EQ(json["entities"].size(), 2u);
  EXPECT_EQ(json["entities"][1]["proof"][0]["text"], "above a desk");
  EXPECT_EQ(json["entities"][1]["class"], *find_class("monitor"));
  EXPECT_EQ(json["entities"][1]["center"], (Json{0, 0, 1100}));
}

TEST(ReportScene, SamplesEvenlyAndLeavesOutWhatHasNoPlace) {
  Scan scan;
  for (int i = 0; i < 1000; ++i) scan.cloud.points.emplace_back(i, 0, 0);
  scan.cloud.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  const Json json = Json::parse(report_scene("a", scan, Surfaces{}, Labelling{}, 100));
  EXPECT_EQ(json["all_points"], 1000);
  EXPECT_LE(json["points"].size(), 300u);
  EXPECT_GE(json["points"].size(), 290u);
  EXPECT_FALSE(json.contains("truth"));
}

TEST(ReportScene, TurnsUpright) {
  Labelling labelling = samples::two_labels();
  labelling.up = Eigen::Vector3d::UnitX();
  const Json json =
      Json::parse(report_scene("a", sample_scan(), samples::two_surfaces(), labelling, 100));
  // x is up now: the point 3 m along x is 3 m high.
  EXPECT_EQ(json["points"][11], 3000);
}

}  // namespace
}  // namespace scanchor
