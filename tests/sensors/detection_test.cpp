#include "sensors/detection.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanchor {
namespace {

TEST(Detection, MarginIsTheLidarEquation) {
  LidarOptions o;
  o.detection_range = 18.0, o.detection_reflectance = 0.1;
  EXPECT_NEAR(detection_margin(o, 18.0, 0.1), 0.0, 1e-12);
  EXPECT_NEAR(detection_margin(o, 9.0, 0.1), 20.0 * std::log10(2.0), 1e-12) << "1 / R^2";
  EXPECT_NEAR(detection_margin(o, 18.0, 0.05), -10.0 * std::log10(2.0), 1e-12);
}

TEST(Detection, ShareOfReturnsWithinOnePercentOfPhi) {
  LidarOptions o;
  o.detection_range = 10.0, o.detection_reflectance = 0.1, o.detection_db = 1.5, o.loss = 0.1;
  const Detection detection(o, 9);
  for (const double range : {6.0, 8.0, 9.0, 10.0, 11.0, 13.0}) {
    int seen = 0;
    for (int line = 0; line < 200; ++line) {
      for (int beam = 0; beam < 200; ++beam) seen += detection.seen(line, beam, range, 0.1) ? 1 : 0;
    }
    EXPECT_NEAR(seen / 40000.0, detection_probability(o, range, 0.1), 0.01) << range << " m";
  }
  EXPECT_NEAR(detection_probability(o, 10.0, 0.1), 0.45, 1e-12);
}

TEST(Detection, OffSeesEverything) {
  const Detection detection(LidarOptions(), 9);
  EXPECT_TRUE(detection.always());
  EXPECT_TRUE(detection.seen(0, 0, 1e6, 1e-9));
}

}  // namespace
}  // namespace scanchor
