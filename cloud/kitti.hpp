#pragma once
// SemanticKITTI: <name>.bin holds x y z remission as float32, <name>.label one uint32 a point:
// class in the low 16 bits, instance in the high 16 bits. nuScenes' <name>.pcd.bin holds x y z
// intensity ring.

#include <string>
#include <string_view>
#include <vector>

#include "cloud/point_cloud.hpp"

namespace scanchor {

/// Points with the field "intensity" (and "ring" for five columns).
/// Throws Error(bad_data) if the size is no multiple of a point's 16 (20) bytes.
PointCloud parse_kitti(std::string_view content, const std::string& file, int columns = 4);
/// Adds the fields "label" and "instance" (uint16). Throws Error(bad_data) if the number of labels
/// is not that of the points.
void add_kitti_labels(PointCloud& cloud, std::string_view content, const std::string& file);

/// Positions and "intensity" (0 where it is missing), rounded to float32.
std::string format_kitti(const PointCloud& cloud);
/// "label" and "instance"; negative values (none) become 0. Throws Error(bad_data) if one is above
/// 65535.
std::string format_kitti_labels(const PointCloud& cloud, const std::string& file);

}  // namespace scanchor
