#pragma once
// The local plane around each leaf of the pool: what a patch of some twenty points can say about
// position and direction.

#include <vector>

#include "perception/point_pool.hpp"

namespace scanchor {

struct Surfel {
  GrownPlane grown;
  double tilt =
      1e3;  ///< [rad] one sigma of the normal; `unknown_tilt` or more: the points do not say
  double score = 0.0;  ///< [0, 1] how much of the neighbourhood lies on the plane, and how well
};

/// Beyond this a normal is not used: three sigma are half a radian.
inline constexpr double unknown_tilt = 0.17;

/// One a leaf, from the points within 1.2 leaf sides or three sigma of the leaf's mean. Two rounds
/// of least squares, each without what lies beyond 2.5 sigma.
std::vector<Surfel> fit_surfels(const PointPool& pool, const BeamNoise& noise);

/// Does the patch continue the plane? Its mean must lie on it and its normal agree, within three
/// sigma of what both are known to.
bool continues(const GrownPlane& plane, const Surfel& patch, const BeamNoise& noise);

}  // namespace scanchor
