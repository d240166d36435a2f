#pragma once
// Section 2, Algorithm 1 of the paper: region growing with the k nearest neighbours found once.

#include <cstdint>
#include <vector>

#include "perception/canonical_cloud.hpp"

namespace scanchor {

/// The paper names delta and gamma and gives no numbers; these defaults are ours, from the noise.
struct PaperOptions {
  int neighbours = 20;  ///< k of the KNN search
  double delta = 2.25;  ///< bound of the mean square error, in squared noise sigmas: (1.5 sigma)^2
  double gamma = 3.0;   ///< bound of the distance to the best-fitting plane, in noise sigmas
  std::size_t minimum = 30;  ///< smaller regions are no planes
  std::uint64_t seed = 1;    ///< of the order in which seed points are drawn
};

/// Region of each point of the canonical cloud, -1: none. Regions are numbered in the order of
/// their finding.
std::vector<std::int32_t> paper_planes(const CanonicalCloud& cloud, double sigma,
                                       const PaperOptions& options);

}  // namespace scanchor
