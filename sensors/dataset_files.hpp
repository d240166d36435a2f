#pragma once
// The bytes of each file of a data set.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/scene.hpp"
#include "sensors/scan.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {

/// labels/NNNNNN.label: class in the low, instance id in the high 16 bits; none is 0.
std::string label_bytes(const PointTruth& truth, const std::string& file);

/// truth/NNNNNN.npy, a structured numpy array (NEP 1, version 1.0), one record a point: face <i4,
/// part <i2, runner_up <i4, flags u1, line <u2, beam <u2 (65535: none), true_range <f4, incidence
/// <f4.
std::string truth_npy(const Scan& scan);
/// Fills the truth, line and beam of a scan whose cloud and labels are read. Throws
/// Error(bad_data).
void read_truth_npy(std::string_view bytes, Scan& scan, const std::string& file);

/// poses.txt: one line a scan, T_world_sensor moved to KITTI's camera frame (x right, y down, z
/// forward): Tr T Tr^-1.
std::string poses_text(const std::vector<Eigen::Isometry3d>& T_world_sensor);
/// calib.txt: P0..P3 (a camera that is not there) and Tr, sensor to camera.
std::string calib_text();
/// The poses back: Tr^-1 pose Tr. `calib` may be empty: then Tr is the one that calib_text writes.
/// Throws Error(bad_data).
std::vector<Eigen::Isometry3d> parse_poses(std::string_view poses, std::string_view calib,
                                           const std::string& poses_file,
                                           const std::string& calib_file);
/// times.txt: when each scan began [s], one sweep after the other.
std::string times_text(std::size_t scans, const LidarOptions& lidar);

/// S3DIS text of a scene: file name (relative to Area_k) and content, the room first, then its
/// Annotations. Points in the world frame with three decimals, colours of the materials.
std::vector<std::pair<std::string, std::string>> s3dis_files(const Scene& scene,
                                                             const std::vector<Scan>& scans,
                                                             const std::string& room);

}  // namespace scanchor
