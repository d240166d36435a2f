#pragma once
// Several scans from several poses as one unorganized cloud, as the paper makes them with ICP
// (section 2) - with a registration error of chosen size.

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "core/options.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

struct MergeOptions {
  double position_sigma = 0.0;   ///< [m] registration error of each scan but the first, each axis
  double angle_sigma_deg = 0.0;  ///< [deg] the same about each axis
  bool shuffle = false;          ///< mix the points: no order is left that a program could lean on
  void describe(OptionList& list);
};

/// What came together, and where each scan was put.
struct MergedScan {
  Scan scan;  ///< cloud in the frame of the first scan; all truth columns; cloud field "scan" says
              ///< from which one a point is
  std::vector<Eigen::Isometry3d> T_first_scan;  ///< true pose of each scan in the first one's frame
  std::vector<Eigen::Isometry3d>
      T_first_placed;  ///< pose it was given: true pose with the registration error
};

/// Random small pose error: a rotation vector and a translation with independent normal axes. A
/// pure function of seed and index.
Eigen::Isometry3d pose_error(const MergeOptions& options, std::uint64_t seed, std::size_t index);

/// Joins scans. `cloud.sensor_poses` holds the placed poses. The visible fractions of a face add up
/// to at most 1, which is an upper bound where scans overlap. Throws Error(wrong_usage) for no
/// scans at all. Deterministic.
MergedScan merge_scans(const std::vector<Scan>& scans, const MergeOptions& options,
                       std::uint64_t seed);

}  // namespace scanchor
