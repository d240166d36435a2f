#pragma once
// Panoptic quality: Kirillov, He, Girshick, Rother, Dollar, "Panoptic Segmentation", CVPR 2019,
// equation 2.

#include <cstdint>
#include <vector>

#include "eval/fixed_sum.hpp"
#include "eval/segments.hpp"

namespace scanchor {

/// Counts of one class, added up over scans.
struct PanopticCounts {
  std::int64_t matched = 0;  ///< TP
  std::int64_t extra = 0;    ///< FP
  std::int64_t missed = 0;   ///< FN
  FixedSum iou;              ///< of the matched
  friend bool operator==(const PanopticCounts&, const PanopticCounts&) = default;
};

struct PanopticScore {
  std::vector<PanopticCounts> classes;  ///< by ClassId; empty: nothing scored yet
  void add(const PanopticScore& other);
  friend bool operator==(const PanopticScore&, const PanopticScore&) = default;
};

/// PQ = sum IoU / (TP + FP/2 + FN/2), SQ = sum IoU / TP, RQ = TP / (TP + FP/2 + FN/2); 0 where the
/// denominator is 0.
struct PanopticQuality {
  double pq = 0, sq = 0, rq = 0;
  int classes = 0;  ///< that the mean is over
};

PanopticScore score_panoptic(const Segments& segments, const ClassRules& rules,
                             const Protocol& protocol);

PanopticQuality panoptic_quality(const PanopticCounts& counts);
enum class ClassKind { all, things, stuff };
/// Mean over the classes of a kind, absent ones as the protocol says.
PanopticQuality panoptic_quality(const PanopticScore& score, ClassKind kind,
                                 const ClassRules& rules, const Protocol& protocol);

}  // namespace scanchor
