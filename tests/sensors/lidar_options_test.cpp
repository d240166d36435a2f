#include <gtest/gtest.h>

#include "core/error.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {
namespace {

TEST(LidarOptions, EveryOptionReadsBackToTheSameText) {
  LidarOptions options;
  OptionList list;
  options.describe(list);
  EXPECT_GT(list.options().size(), 50U);
  for (const Option& option : list.options()) {
    const std::string before = list.get(option.name);
    list.set(option.name, before);
    EXPECT_EQ(list.get(option.name), before) << option.name;
    EXPECT_FALSE(option.text.empty());
  }
}

TEST(LidarOptions, ContradictionsAreWrongUsage) {
  const auto code = [](auto change) {
    LidarOptions options;
    change(options);
    try {
      check_lidar_options(options);
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::done;
  };
  EXPECT_EQ(code([](LidarOptions&) {}), ExitCode::done);
  EXPECT_EQ(code([](LidarOptions& o) { o.minimum_range = 40; }), ExitCode::wrong_usage);
  EXPECT_EQ(code([](LidarOptions& o) { o.geometry = "camera"; }), ExitCode::wrong_usage);
  EXPECT_EQ(code([](LidarOptions& o) { o.subrays = 9; }), ExitCode::wrong_usage);
}

}  // namespace
}  // namespace scanchor
