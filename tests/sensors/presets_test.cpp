#include <gtest/gtest.h>

#include "core/error.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {
namespace {

TEST(Presets, EachIsNamedAfterItselfAndWithinTheBoundsOfItsOptions) {
  ASSERT_EQ(lidar_presets().size(), 8U);
  for (const std::string& name : lidar_presets()) {
    LidarOptions options = lidar_preset(name);
    EXPECT_EQ(options.preset, name);
    check_lidar_options(options);
    OptionList list;
    options.describe(list);
    for (const Option& option : list.options()) list.set(option.name, list.get(option.name));
  }
}

TEST(Presets, PaperIsAHundredThousandPointsIn180By90Degrees) {
  const LidarOptions options = lidar_preset("paper");
  EXPECT_EQ(options.beams_per_line * options.lines, 100000);
  EXPECT_EQ(options.horizontal_deg, 180.0);
  EXPECT_EQ(options.vertical_deg, 90.0);
}

TEST(Presets, BeamSpacingFitsTheMirror) {
  for (const char* name : {"utm-30lx", "ust-20lx", "lms-200", "lms-1xx", "lms-5xx"}) {
    const LidarOptions o = lidar_preset(name);
    EXPECT_NEAR(o.horizontal_deg / (o.beams_per_line - 1), 360.0 / o.beams_per_turn, 1e-3) << name;
  }
}

TEST(Presets, UnknownNameSuggestsTheNearest) {
  try {
    lidar_preset("utm-30xl");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_usage);
    EXPECT_NE(std::string(error.what()).find("did you mean 'utm-30lx'"), std::string::npos);
  }
}

}  // namespace
}  // namespace scanchor
