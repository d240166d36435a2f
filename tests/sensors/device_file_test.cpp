#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {
namespace {

class DeviceFile : public ::testing::Test {
 protected:
  std::filesystem::path path() const {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    return std::filesystem::path(::testing::TempDir()) /
           (std::string("scanchor_device_") + info->name() + ".yaml");
  }
  LidarOptions read(const std::string& text) {
    write_file(path(), text);
    return read_lidar_options(path());
  }
  std::string error(const std::string& text) {
    try {
      read(text);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::bad_data);
      return e.what();
    }
    return "";
  }
  void TearDown() override { std::filesystem::remove(path()); }
};

TEST_F(DeviceFile, StartsFromItsPresetWhereverThatStands) {
  const LidarOptions o =
      read("lines: 278\nencoder_sigma_deg: 0.02\npreset: utm-30lx\necho: last\n");
  EXPECT_EQ(o.preset, "utm-30lx");
  EXPECT_EQ(o.beams_per_line, 1081);
  EXPECT_EQ(o.lines, 278);
  EXPECT_EQ(o.encoder_sigma_deg, 0.02);
  EXPECT_EQ(o.echo, "last");
}

TEST_F(DeviceFile, ErrorsNameFileLineAndWhatWasMeant) {
  const std::string unknown = error("lines: 10\nrange_sigam: 0.01\n");
  EXPECT_NE(unknown.find(path().string() + ": line 2"), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("did you mean 'range_sigma'"), std::string::npos) << unknown;
  EXPECT_NE(error("lines: 10\n\nlines: 11\n").find("line 3"), std::string::npos);
  EXPECT_NE(error("range_sigma: -1\n").find("outside"), std::string::npos);
  EXPECT_NE(error("range_sigma: lots\n").find("not a number"), std::string::npos);
  EXPECT_NE(error("lines: [1, 2]\n").find("one value"), std::string::npos);
  EXPECT_NE(error("preset: paperr\n").find("'paper'"), std::string::npos);
  EXPECT_NE(error("- 1\n- 2\n").find("no map"), std::string::npos);
  EXPECT_NE(error("lines: {\n").find("line 2"), std::string::npos);
  EXPECT_NE(error("minimum_range: 40\n").find("minimum_range"), std::string::npos);
}

}  // namespace
}  // namespace scanchor
