#pragma once
// Text with one point a line: x, y, z, then whatever else. Blanks, tabs, commas or semicolons
// between, # or // before comments.

#include <string>
#include <string_view>

#include "cloud/point_cloud.hpp"

namespace scanchor {

/// Names of the columns come from a first comment or line of words that begins with x y z; without
/// it a fourth column is "intensity", three further ones of whole numbers 0..255 are "red",
/// "green", "blue" (S3DIS), and the rest is "column_4" and so on. Types come from a
/// "# types" comment; without it columns of whole numbers are int32 and others double. A first line
/// with nothing but the number of points (PTS) is understood. `file` names the source in errors.
/// Throws Error(bad_data).
PointCloud parse_xyz(std::string_view content, const std::string& file);
std::string format_xyz(const PointCloud& cloud, const std::string& file);

}  // namespace scanchor
