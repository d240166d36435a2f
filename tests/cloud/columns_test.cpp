#include "cloud/columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/cloud/support/clouds.hpp"

namespace scanchor {
namespace {
using testing::data_error;

template <class T>
std::optional<T> parse(std::string_view token, ScalarType type) {
  char raw[8] = {};
  if (!parse_scalar(token, type, raw)) return std::nullopt;
  T value;
  std::memcpy(&value, raw, sizeof value);
  return value;
}

TEST(Columns, ParsesRealNumbersAsCDoes) {
  EXPECT_EQ(parse<float>("0.1", ScalarType::f32), 0.1F);
  EXPECT_EQ(parse<double>("+1e-3", ScalarType::f64), 1e-3);
  EXPECT_EQ(parse<double>("-.5", ScalarType::f64), -0.5);
  EXPECT_TRUE(std::isnan(*parse<float>("NaN", ScalarType::f32)));
  EXPECT_TRUE(std::isnan(*parse<float>("-nan(ind)", ScalarType::f32)));
  EXPECT_TRUE(std::isnan(*parse<float>("1.#QNAN", ScalarType::f32)));
  EXPECT_TRUE(std::isinf(*parse<double>("inf", ScalarType::f64)));
  EXPECT_EQ(parse<float>("1e99", ScalarType::f32), INFINITY);
  EXPECT_EQ(parse<double>("-1e999", ScalarType::f64), -INFINITY);
  EXPECT_EQ(parse<float>("1e-99", ScalarType::f32), 0.0F);
  EXPECT_EQ(parse<double>("1e-999", ScalarType::f64), 0.0);
  for (const char* bad : {"", "x", "1.5x", "--1", "+", "0x10", "1,5"}) {
    EXPECT_EQ(parse<double>(bad, ScalarType::f64), std::nullopt) << bad;
  }
}

TEST(Columns, ParsesWholeNumbersWithinTheirType) {
  EXPECT_EQ(parse<std::uint8_t>("255", ScalarType::u8), 255);
  EXPECT_EQ(parse<std::uint8_t>("3.0", ScalarType::u8), 3);
  EXPECT_EQ(parse<std::int32_t>("-2147483648", ScalarType::i32), INT32_MIN);
  EXPECT_EQ(parse<std::int32_t>("1e3", ScalarType::i32), 1000);
  EXPECT_EQ(parse<std::uint64_t>("18446744073709551615", ScalarType::u64), UINT64_MAX);
  EXPECT_EQ(parse<std::uint8_t>("256", ScalarType::u8), std::nullopt);
  EXPECT_EQ(parse<std::uint32_t>("-1", ScalarType::u32), std::nullopt);
  EXPECT_EQ(parse<std::int32_t>("1.5", ScalarType::i32), std::nullopt);
  EXPECT_EQ(parse<std::int32_t>("nan", ScalarType::i32), std::nullopt);
}

TEST(Columns, SixtyFourBitIntegersBecomeTheSmallestTypeThatHoldsThem) {
  const auto read = [](std::vector<std::int64_t> values) {
    std::vector<Column> columns = {{"x", ScalarType::i64},
                                   {"y", ScalarType::i64},
                                   {"z", ScalarType::i64},
                                   {"id", ScalarType::i64}};
    const std::size_t record = lay_out_records(columns);
    std::string bytes(record * values.size(), '\0');
    for (std::size_t i = 0; i < values.size(); ++i)
      std::memcpy(bytes.data() + i * record + 24, &values[i], 8);
    return cloud_from_columns(columns, bytes, values.size(), false, "f").fields[0];
  };
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int32_t>>(read({-1, INT32_MAX}).values));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint32_t>>(read({0, UINT32_MAX}).values));
  EXPECT_TRUE(std::holds_alternative<std::vector<double>>(read({-1, UINT32_MAX}).values));
  EXPECT_EQ(read({-5, 1LL << 40}).at(1), 1099511627776.0);
}

TEST(Columns, BytesAreTurnedRoundWhereAsked) {
  std::vector<Column> columns = {
      {"x", ScalarType::u16}, {"y", ScalarType::u16}, {"z", ScalarType::u16}};
  lay_out_records(columns);
  const std::string bytes("\x01\x02\x03\x04\x05\x06", 6);
  EXPECT_EQ(cloud_from_columns(columns, bytes, 1, false, "f").points[0],
            Eigen::Vector3d(0x0201, 0x0403, 0x0605));
  EXPECT_EQ(cloud_from_columns(columns, bytes, 1, true, "f").points[0],
            Eigen::Vector3d(0x0102, 0x0304, 0x0506));
}

TEST(Columns, NeedXYZOnceEach) {
  const std::vector<Column> no_z = {{"x", ScalarType::f32}, {"y", ScalarType::f32}};
  EXPECT_EQ(data_error([&] { (void)cloud_from_columns(no_z, "", 0, false, "f"); }),
            "f: header: has no field 'z'; a point needs x, y and z");
  const std::vector<Column> twice = {{"x", ScalarType::f32}, {"x", ScalarType::f32}};
  EXPECT_EQ(data_error([&] { (void)cloud_from_columns(twice, "", 0, false, "f"); }),
            "f: header: names the field 'x' twice");
}

TEST(Columns, PositionsAreFloatUnlessTheyNeedMore) {
  EXPECT_EQ(columns_of(testing::cloud_with_all_types(false), "f")[0].type, ScalarType::f32);
  EXPECT_EQ(columns_of(testing::cloud_with_all_types(true), "f")[0].type, ScalarType::f64);
}

TEST(Columns, RefusesWhatNoFileCanHold) {
  PointCloud cloud = testing::cloud_with_all_types(false);
  cloud.fields[0].values = std::vector<float>{1.0F};
  EXPECT_NE(data_error([&] {
              (void)columns_of(cloud, "f");
            }).find("'intensity' has 1 values for 50 points"),
            std::string::npos);
  cloud = testing::cloud_with_all_types(false);
  cloud.fields[0].name = "x";
  EXPECT_NE(data_error([&] { (void)columns_of(cloud, "f"); }).find("'x' cannot be the name"),
            std::string::npos);
  cloud.fields[0].name = "a b,c";
  EXPECT_EQ(columns_of(cloud, "f")[3].name, "a_b_c");
  cloud.width = 7;
  cloud.height = 7;
  EXPECT_NE(data_error([&] { (void)columns_of(cloud, "f"); }).find("50 points are not 7 x 7"),
            std::string::npos);
}

TEST(Columns, PosesRoundTripAndBadOnesAreNone) {
  const Eigen::Isometry3d pose = testing::cloud_with_all_types(false).sensor_poses[0];
  Eigen::Isometry3d back;
  ASSERT_TRUE(parse_pose(pose_text(pose), back));
  EXPECT_LT((back.matrix() - pose.matrix()).norm(), 1e-14);
  for (const char* bad : {"", "0 0 0 1 0 0", "0 0 0 0 0 0 0", "0 0 nan 1 0 0 0", "0 0 0 1 0 0 0 0",
                          "a 0 0 1 0 0 0"}) {
    EXPECT_FALSE(parse_pose(bad, back)) << bad;
  }
}

}  // namespace
}  // namespace scanchor
