#pragma once
// PLY, Greg Turk's polygon format: the element "vertex" of ascii and binary files of both byte
// orders. Other elements (faces) and list properties are skipped.

#include <string>
#include <string_view>

#include "cloud/point_cloud.hpp"

namespace scanchor {

enum class PlyData { ascii, little_endian, big_endian };

/// `file` names the source in errors. Throws Error(bad_data).
PointCloud parse_ply(std::string_view content, const std::string& file);
/// Writes ascii or binary_little_endian; big_endian is only read (PlyData::big_endian writes it
/// too, for tests of readers).
std::string format_ply(const PointCloud& cloud, PlyData data, const std::string& file);

}  // namespace scanchor
