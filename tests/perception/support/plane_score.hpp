#pragma once
// How well a labelling of points into planes agrees with the truth: the classes of Hoover et al.,
// "An experimental comparison of range image segmentation algorithms", PAMI 18(7) 1996, section 3,
// and point precision and recall.

#include <cstdint>
#include <vector>

namespace scanchor::support {

struct PlaneScore {
  int planes = 0;    ///< of the truth, with at least `least` points
  int correct = 0;   ///< mutual overlap of at least the tolerance
  int over = 0;      ///< true planes cut into several regions
  int under = 0;     ///< regions that join several true planes
  int missed = 0;    ///< true planes in none of the above
  int spurious = 0;  ///< regions in none of the above
  int regions = 0;
  double precision =
      0.0;  ///< adjPrec: share of the points of best regions that lie on their own true plane
  double recall =
      0.0;  ///< adjRec: share of the points on true planes that lie in their plane's best region
  double small_recall =
      0.0;  ///< mean over true planes of under 1 % of the points of the share in their best region
  std::vector<std::int32_t> not_correct;  ///< ids of true planes that are not correct
};

/// `truth` and `regions`: one a point, -1 none. Only true planes of at least `least` points are
/// counted; regions of fewer than `least` points that match none are not held against anybody.
PlaneScore score_planes(const std::vector<std::int32_t>& truth,
                        const std::vector<std::int32_t>& regions, double tolerance,
                        std::size_t least);

}  // namespace scanchor::support
