#pragma once
// Clouds and comparisons that the tests of the formats share.

#include <cstdint>
#include <functional>
#include <string>

#include "cloud/point_cloud.hpp"

namespace scanchor::testing {

/// A cloud with a field of each type, NaN points, extreme values and a pose. `wide`: coordinates
/// that need float64.
PointCloud cloud_with_all_types(bool wide, std::uint64_t seed = 1);

/// Bit-exact comparison of points, fields (names, types, values), organization; poses to 1e-12. NaN
/// equals NaN.
void expect_same(const PointCloud& a, const PointCloud& b);

/// The line of the Error(bad_data) that `body` throws; a failure if it throws nothing or something
/// else.
std::string data_error(const std::function<void()>& body);

/// Cuts and bit flips of `bytes` at seeded places, each given to `read`: it must return or throw
/// scanchor::Error, never anything else.
void expect_robust(const std::string& bytes, int mutations,
                   const std::function<void(const std::string&)>& read);

}  // namespace scanchor::testing
