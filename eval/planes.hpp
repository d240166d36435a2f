#pragma once
// Planes against planes: Hoover et al., "An experimental comparison of range image segmentation
// algorithms", IEEE PAMI 18(7), 1996, section 4; Rand, "Objective criteria for the evaluation of
// clustering methods", JASA 66, 1971; Hubert and Arabie, "Comparing partitions", Journal of
// Classification 2, 1985.

#include <cstdint>
#include <span>
#include <vector>

#include "eval/fixed_sum.hpp"
#include "eval/protocol.hpp"

namespace scanchor {

/// Counts of planes of the truth and of found regions, by Hoover's classes at one tolerance.
/// truths = truth_correct + truth_over + truth_under + truth_missed; likewise for regions.
struct HooverCounts {
  std::int64_t correct = 0;        ///< pairs: one truth, one region
  std::int64_t truth_over = 0;     ///< truths that came out in pieces
  std::int64_t regions_over = 0;   ///< the pieces
  std::int64_t truth_under = 0;    ///< truths that ran together with others
  std::int64_t regions_under = 0;  ///< the regions they ran into
  std::int64_t missed = 0;         ///< truths without any of these
  std::int64_t noise = 0;          ///< regions without any of these
  void add(const HooverCounts& other);
  friend bool operator==(const HooverCounts&, const HooverCounts&) = default;
};

struct PlaneScore {
  std::vector<HooverCounts> hoover;  ///< one a tolerance of the protocol
  std::int64_t scans = 0;
  std::int64_t truths = 0;   ///< planes that count
  std::int64_t regions = 0;  ///< found regions that count
  // Points of planes that count; each truth and each region belongs to at most one pair, paired by
  // falling overlap:
  std::int64_t truth_points = 0;
  std::int64_t region_points = 0;
  std::int64_t paired_points = 0;
  // Small planes (Protocol::small_plane_share): share of their points in their best region
  std::int64_t small_truths = 0;
  FixedSum small_recall;
  // Pairs of points
  std::int64_t pairs = 0;        ///< all
  std::int64_t pairs_agree = 0;  ///< together in both or apart in both
  FixedSum adjusted_rand;        ///< of the scans
  void add(const PlaneScore& other);
  friend bool operator==(const PlaneScore&, const PlaneScore&) = default;
};

/// How region and truth were paired, for geometry and pictures.
enum class HooverClass : std::uint8_t { ignored, correct, over, under, missed_or_noise };
struct PlaneMatch {
  std::vector<HooverClass> truth;             ///< by truth plane, at Protocol::geometry_tolerance
  std::vector<HooverClass> region;            ///< by region label
  std::vector<std::int32_t> region_of_truth;  ///< the one correct region of a truth plane; -1: none
};

/// `truth`: index of the plane of each point, -1: none (counts on neither side). `ignored[plane]`:
/// could not be seen well enough. `predicted`: label of the region, -1: none. Equally long. `match`
/// may be null.
PlaneScore score_planes(std::span<const std::int32_t> truth, std::span<const char> ignored,
                        std::span<const std::int32_t> predicted, const Protocol& protocol,
                        PlaneMatch* match = nullptr);

/// Derived numbers, each in [0, 1]; 0 where nothing was there.
double plane_precision(const PlaneScore& score, std::size_t tolerance);  ///< correct / regions
double plane_recall(const PlaneScore& score, std::size_t tolerance);     ///< correct / truths
double plane_f1(const PlaneScore& score,
                std::size_t tolerance);              ///< 2 correct / (regions + truths)
double adjusted_precision(const PlaneScore& score);  ///< paired points / points of regions
double adjusted_recall(const PlaneScore& score);     ///< paired points / points of truths
double small_plane_recall(const PlaneScore& score);
double rand_index(const PlaneScore& score);  ///< pooled over pairs of points
double adjusted_rand_index(
    const PlaneScore& score);  ///< mean over scans, up to 1, about 0 by chance

}  // namespace scanchor
