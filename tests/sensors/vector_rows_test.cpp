#include "sensors/vector_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/math.hpp"
#include "core/random.hpp"
#include "sensors/portable_angle.hpp"

namespace scanchor {
namespace {

TEST(VectorRows, NormalsHaveTheBitsOfTheScalarGenerator) {
  for (const std::size_t count : {1U, 63U, 64U, 65U, 5000U}) {
    std::vector<double> row(count);
    const std::uint64_t seed = 0x123456789abcdef0ULL + count, a = 0xfedcba9876543210ULL;
    normal_row(seed, a, count, row.data());
    const CounterRandom random(seed);
    for (std::size_t k = 0; k < count; ++k) {
      const auto w = random.words(a, static_cast<std::uint32_t>(k / 2));
      const std::uint64_t bits = (std::uint64_t{w[2 * (k % 2)]} << 21) ^ (w[2 * (k % 2) + 1] >> 11);
      const double p = (static_cast<double>(bits) + 0.5) * 0x1p-53;
      ASSERT_EQ(row[k], normal_quantile(std::min(p, 1.0 - 0x1p-53))) << k;
      if (k % 2 == 0) {
        ASSERT_EQ(row[k], random.normal(a, static_cast<std::uint32_t>(k / 2)));
      }
    }
  }
}

TEST(VectorRows, AnglesHaveTheBitsOfTheScalarFunction) {
  std::vector<double> cosine;
  for (int i = 0; i <= 1000; ++i) cosine.push_back(i / 1000.0);
  std::vector<float> row(cosine.size());
  angle_row(cosine.data(), cosine.size(), row.data());
  for (std::size_t k = 0; k < row.size(); ++k) {
    ASSERT_EQ(row[k], static_cast<float>(angle_of_cosine(cosine[k])));
  }
}

TEST(VectorRows, TransformsLikeAMatrix) {
  const double R[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1}, t[3] = {10, 20, 30};
  const std::vector<double> x = {1, 2, 3}, y = {4, 5, 6}, z = {7, 8, 9};
  std::vector<double> ox(3), oy(3), oz(3);
  transform_row(R, t, x.data(), y.data(), z.data(), 3, ox.data(), oy.data(), oz.data());
  EXPECT_EQ(ox, (std::vector<double>{6, 5, 4}));
  EXPECT_EQ(oy, (std::vector<double>{21, 22, 23}));
  EXPECT_EQ(oz, (std::vector<double>{37, 38, 39}));
}

}  // namespace
}  // namespace scanchor
