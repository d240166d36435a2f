#pragma once
// Brings scans from several poses together: point-to-plane ICP. The paper takes ICP from Besl &
// McKay 1992 for its merged clouds (section 2); the metric is that of Chen & Medioni 1992, which
// lets walls slide along themselves and so converges in few steps.

#include <Eigen/Geometry>
#include <vector>

#include "cloud/point_cloud.hpp"
#include "core/options.hpp"

namespace scanchor {

struct RegisterOptions {
  double reach = 0.5;  ///< [m] how far off the first guess may be: pairs farther apart are not made
  double voxel =
      0.0;  ///< [m] cell of the thinned clouds; 0: a two-hundredth of the target's diagonal
  int neighbours = 12;  ///< of a point, for its normal
  int maximum_iterations = 60;
  void describe(OptionList& list);
};

/// How two clouds lie to each other.
struct Registration {
  Eigen::Isometry3d T_target_source = Eigen::Isometry3d::Identity();
  bool converged = false;  ///< the last step moved by less than 10 micrometres and 10 microradians
  int iterations = 0;
  double overlap = 0.0;  ///< [0, 1] share of the source's points with a partner
  double residual =
      0.0;  ///< [m] robust standard deviation of the distances to the partners' planes
  int free_directions =
      0;  ///< of 6 that the geometry does not hold (along a bare corridor: 1; a lone wall: 3)
};

/// T_target_source from a first guess. Non-finite points are left out. Outliers, moved things and
/// parts that only one scan saw are held down by a Cauchy kernel whose width is the residual's own
/// robust deviation; directions that the geometry does not fix stay as guessed (Zhang, Kaess,
/// Singh, "On degeneracy of optimization-based state estimation problems", ICRA 2016).
/// Deterministic: the same clouds give the same bits for any number of threads. Throws
/// Error(bad_data) for a cloud with fewer than 50 finite points.
Registration register_clouds(const PointCloud& target, const PointCloud& source,
                             const Eigen::Isometry3d& guess, const RegisterOptions& options = {});

/// Poses of all clouds in the first one's frame: each is registered to all before it, as they lie
/// by then.
std::vector<Eigen::Isometry3d> register_all(const std::vector<PointCloud>& clouds,
                                            const std::vector<Eigen::Isometry3d>& guesses,
                                            const RegisterOptions& options = {});

}  // namespace scanchor
