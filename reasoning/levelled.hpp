#pragma once
// Surfaces seen upright: which way is up, and from where they were seen.

#include "perception/surface.hpp"
#include "reasoning/reason.hpp"
#include "reasoning/relation.hpp"
#include "reasoning/up.hpp"

namespace scanchor {

struct Levelled {
  UpDirection up;
  Eigen::Matrix3d R_level_cloud;  ///< turns the cloud's frame so that z is up
  Surrounding around;             ///< seen from the first sensor position, if there is one
};

/// By `up` and `up_sigma_deg` of the options (find_up). Throws Error(wrong_usage) as that does.
Levelled level(const Surfaces& surfaces, const ReasonOptions& options);

}  // namespace scanchor
