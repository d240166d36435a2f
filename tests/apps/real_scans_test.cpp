// Scans that nobody here made: every one of them is labelled, and where the truth is known the
// plainest things are right.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/json.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::run_scanchor;
using testing_support::scratch;

class RealScan : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(path())) GTEST_SKIP() << "no shared data";
  }
  static std::string path() { return std::string(SCANCHOR_SHARED_DATA) + "/" + GetParam(); }
};

TEST_P(RealScan, IsLabelledWithEveryPointInItsPlace) {
  const auto ran = run_scanchor("label '" + path() +
                                "' --up auto --no-pictures --out real --points real.ply --json");
  ASSERT_EQ(ran.code, 0) << ran.error;
  const Json labels = Json::parse(ran.out);
  EXPECT_FALSE(labels["objects"].empty());
  EXPECT_TRUE(std::filesystem::exists(scratch() + "real/surfaces.json"));
  EXPECT_TRUE(std::filesystem::exists(scratch() + "real.ply"));
}

INSTANTIATE_TEST_SUITE_P(SharedData, RealScan,
                         testing::Values("office_laser/room_scan1.pcd",
                                         "apartment_laser/cloud_0.ply", "office_kinect/office1.pcd",
                                         "plane_bench/test_100.pcd"),
                         [](const auto& row) {
                           const std::string path = row.param;
                           return path.substr(0, path.find('/'));
                         });

TEST(OfficeLaser, FloorAndCeilingAreWhereTheyWereMeasured) {
  const std::string scan = std::string(SCANCHOR_SHARED_DATA) + "/office_laser/room_scan1.pcd";
  if (!std::filesystem::exists(scan)) GTEST_SKIP() << "no shared data";
  const auto ran = run_scanchor("label '" + scan +
                                "' --up auto --sensor 0,0,0 --no-pictures --out office --json");
  ASSERT_EQ(ran.code, 0) << ran.error;
  int floors = 0;
  int ceilings = 0;
  const Json labels = Json::parse(ran.out);
  for (const auto& object : labels["objects"]) {
    if (object["points"].get<int>() < 1000) continue;
    const double z = object["center"][2].get<double>();
    if (object["class"] == "floor") {
      ++floors;
      EXPECT_NEAR(z, -1.252, 0.05);  // truth.json: the floor slopes by a degree
    }
    if (object["class"] == "ceiling") {
      ++ceilings;
      EXPECT_NEAR(z, 1.67, 0.1);  // and so does the ceiling
    }
  }
  EXPECT_GE(floors, 1);
  EXPECT_GE(ceilings, 1);
}

}  // namespace
}  // namespace scanchor
