#pragma once
// How two partitions of the same points overlap.

#include <cstdint>
#include <span>
#include <vector>

namespace scanchor {

/// Points that carry label `truth` on one side and `predicted` on the other.
struct Overlap {
  std::int32_t truth;
  std::int32_t predicted;
  std::int64_t points;
};

/// All pairs that occur, in rising order of (truth, predicted); labels below 0 are counted like
/// others, under -1. Both spans must be equally long. O(n log n), no dependence on the order of the
/// points.
std::vector<Overlap> overlap_table(std::span<const std::int32_t> truth,
                                   std::span<const std::int32_t> predicted);

}  // namespace scanchor
