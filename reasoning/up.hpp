#pragma once
// Which way is up: gravity is never exact, so the direction that was given is refined by the floor
// and walls near it.

#include <string>

#include "perception/surface.hpp"

namespace scanchor {

struct UpDirection {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< unit, in the cloud's frame
  double sigma = 0.0;    ///< [rad] standard deviation of each of its two tilts
  double upright = 1.0;  ///< [0, 1] probability that it is up: of "auto" against all other
                         ///< candidates, of a given direction against its opposite
  int supports = 0;      ///< surfaces that took part in the refinement
};

/// `given`: "x,y,z" or "auto" (the likeliest of up_candidates, up_evidence.hpp). `sigma` [rad]:
/// deviation of the given direction. Throws Error(wrong_usage) if `given` is neither.
UpDirection find_up(const Surfaces& surfaces, const std::string& given, double sigma);

}  // namespace scanchor
