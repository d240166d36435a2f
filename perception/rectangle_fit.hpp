#pragma once
// A rectangle from what was measured on both sides of its edges, with intervals.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "perception/rectangle_likelihood.hpp"
#include "perception/rectangle_sides.hpp"
#include "perception/surface.hpp"

namespace scanchor {

struct RectangleFit {
  FittedRectangle rectangle;
  Measured area;                    ///< [m2] of the rectangle
  double loose_area = 0.0;          ///< [m2] of the outline that may be of another thing
  std::array<double, 4> support{};  ///< share of each side (right, top, left, bottom in its own
                                    ///< frame) that true edges lie along
  std::array<bool, 4> censored{};   ///< the side is a shadow or the end of the view
};

/// Direction: that of the longest edges, at right angles to each other. Sides: the outermost that
/// carry a tenth of the extent, or three samples of true edge. Then, for a grid of directions about
/// it, each side's position has the likelihood  prod_i P(sample i is on the side where it was
/// found), with normal lateral noise and a share of wrong samples; direction and positions have
/// flat priors. Width and length are sums of two positions, their distribution follows by
/// convolution, and the answer is its mean and its central 95 %. No shape of error is assumed:
/// where the samples form a lattice parallel to a side the distribution is as flat as one spacing,
/// where they do not it is much narrower. Without samples outside, a side lies where the outline
/// does, and what the outline cannot tell is its variance. Censored sides lie at the outermost
/// sample and make the size "at least". Empty evidence gives a rectangle of size 0.
RectangleFit fit_rectangle(const RectangleEvidence& evidence);

}  // namespace scanchor
