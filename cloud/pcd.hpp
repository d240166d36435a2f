#pragma once
// PCD, the format of the Point Cloud Library, versions .5 to .7.

#include <string>
#include <string_view>

#include "cloud/point_cloud.hpp"

namespace scanchor {

enum class PcdData { ascii, binary, binary_compressed };

/// `file` names the source in errors. Throws Error(bad_data).
PointCloud parse_pcd(std::string_view content, const std::string& file);
std::string format_pcd(const PointCloud& cloud, PcdData data, const std::string& file);

/// True if the text begins as a PCD header does: comments, then one of its keywords.
bool looks_like_pcd(std::string_view content);

}  // namespace scanchor
