#include "tests/cloud/support/clouds.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <new>

#include "core/error.hpp"
#include "core/random.hpp"

namespace scanchor::testing {

PointCloud cloud_with_all_types(bool wide, std::uint64_t seed) {
  SequentialRandom random(seed);
  PointCloud cloud;
  std::vector<float> f32;
  std::vector<double> f64;
  std::vector<std::int32_t> i32;
  std::vector<std::uint32_t> u32;
  std::vector<std::uint16_t> u16;
  std::vector<std::uint8_t> u8;
  for (int i = 0; i < 50; ++i) {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) {
      const double v = random.uniform(-100.0, 100.0);
      p[k] = wide ? v : static_cast<double>(static_cast<float>(v));
    }
    cloud.points.push_back(p);
    f32.push_back(static_cast<float>(random.normal()));
    f64.push_back(random.normal() * 1e100);
    i32.push_back(static_cast<std::int32_t>(random.uniform(-2147483648.0, 2147483647.0)));
    u32.push_back(random.below(4294967295U));
    u16.push_back(static_cast<std::uint16_t>(random.below(65536)));
    u8.push_back(static_cast<std::uint8_t>(random.below(256)));
  }
  cloud.points[7].setConstant(std::numeric_limits<double>::quiet_NaN());
  cloud.points[8] = {std::numeric_limits<double>::infinity(), -0.0, 0.0};
  f32[0] = std::numeric_limits<float>::denorm_min();
  f32[1] = std::numeric_limits<float>::max();
  f32[2] = std::numeric_limits<float>::quiet_NaN();
  f64[0] = std::numeric_limits<double>::denorm_min();
  f64[1] = -std::numeric_limits<double>::infinity();
  i32[0] = std::numeric_limits<std::int32_t>::min();
  i32[1] = -1;
  u32[0] = std::numeric_limits<std::uint32_t>::max();
  u16[0] = 65535;
  u8[0] = 255;
  cloud.set({"intensity", f32});
  cloud.set({"time", f64});
  cloud.set({"label", i32});
  cloud.set({"rgba", u32});
  cloud.set({"instance", u16});
  cloud.set({"flags", u8});
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(0.1, -2.5, 1.0 / 3.0));
  pose.rotate(Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()));
  cloud.sensor_poses = {pose};
  return cloud;
}

void expect_same(const PointCloud& a, const PointCloud& b) {
  const auto bits_equal = [](double x, double y) {
    return (std::isnan(x) && std::isnan(y)) ||
           std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(bits_equal(a.points[i][k], b.points[i][k])) << "point " << i << " axis " << k;
  }
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  ASSERT_EQ(a.fields.size(), b.fields.size());
  for (std::size_t f = 0; f < a.fields.size(); ++f) {
    EXPECT_EQ(a.fields[f].name, b.fields[f].name);
    EXPECT_EQ(a.fields[f].values.index(), b.fields[f].values.index())
        << "type of " << a.fields[f].name;
    ASSERT_EQ(a.fields[f].size(), b.fields[f].size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_TRUE(bits_equal(a.fields[f].at(i), b.fields[f].at(i)))
          << a.fields[f].name << " of point " << i;
    }
  }
  ASSERT_EQ(a.sensor_poses.size(), b.sensor_poses.size());
  for (std::size_t i = 0; i < a.sensor_poses.size(); ++i) {
    EXPECT_LT((a.sensor_poses[i].matrix() - b.sensor_poses[i].matrix()).norm(), 1e-12);
  }
}

std::string data_error(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

void expect_robust(const std::string& bytes, int mutations,
                   const std::function<void(const std::string&)>& read) {
  SequentialRandom random(99);
  const auto size = static_cast<std::uint32_t>(bytes.size());
  for (int m = 0; m < mutations; ++m) {
    std::string bad = bytes;
    switch (m % 4) {
      case 0:
        bad.resize(random.below(size));
        break;
      case 1:
        for (std::uint32_t k = 0; k <= random.below(8); ++k)
          bad[random.below(size)] ^= static_cast<char>(1U << random.below(8));
        break;
      case 2:
        bad[random.below(std::min<std::uint32_t>(size, 300))] =
            static_cast<char>(random.below(256));
        break;
      default: {  // a digit of the header: counts, sizes
        const auto digit =
            bad.find_first_of("0123456789", random.below(std::min<std::uint32_t>(size, 300)));
        if (digit != std::string::npos)
          bad.insert(digit, random.chance(0.5) ? "99999999999999999" : "-");
      }
    }
    try {
      read(bad);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::bad_data) << error.what();
      EXPECT_FALSE(std::string(error.what()).empty());
    } catch (const std::exception& error) {
      ADD_FAILURE() << "mutation " << m << " escaped as " << error.what();
    }
  }
}

}  // namespace scanchor::testing
