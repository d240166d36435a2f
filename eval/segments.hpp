#pragma once
// Truth and prediction of one scan as segments: what panoptic quality, average precision and the
// count of things are made of.

#include <cstdint>
#include <span>
#include <vector>

#include "eval/protocol.hpp"

namespace scanchor {

struct TruthSegment {
  std::int32_t class_id = 0;
  std::int32_t instance = -1;  ///< of the scan; -1 for stuff
  std::int64_t points = 0;
  bool ignored = false;  ///< could not be seen well enough: counts on neither side
};

struct PredictedSegment {
  std::int32_t class_id = 0;
  std::int32_t instance = -1;
  std::int64_t points = 0;       ///< with truth or without
  std::int64_t void_points = 0;  ///< of them without truth, or of an ignored truth segment
  float confidence = 1.0F;       ///< largest of its points
};

/// `predicted` and `truth` are indices into the lists of Segments.
struct SegmentOverlap {
  std::int32_t truth;
  std::int32_t predicted;
  std::int64_t points;
};

struct Segments {
  std::vector<TruthSegment> truth;          ///< in rising order of (class, instance)
  std::vector<PredictedSegment> predicted;  ///< in rising order of (class, instance)
  std::vector<SegmentOverlap>
      overlaps;  ///< in rising order of (truth, predicted); classes may differ
};

/// Columns of one scan, one row a point.
struct LabelColumns {
  std::span<const std::int32_t> class_id;  ///< unscored and negative ids: no truth, or nothing said
  std::span<const std::int32_t> instance;  ///< below 0: none
};

/// The intersection over union under the protocol's rule for points without truth.
double segment_iou(const Segments& segments, const SegmentOverlap& overlap,
                   const Protocol& protocol);

/// Builds the segments. `ignored_instances`: rising list of truth instances that are ignored for
/// what was seen of them; small ones (Protocol::min_points) are found here. `confidence` may be
/// empty: 1. All spans equally long.
Segments make_segments(const LabelColumns& truth, const LabelColumns& predicted,
                       std::span<const float> confidence,
                       std::span<const std::int32_t> ignored_instances, const ClassRules& rules,
                       const Protocol& protocol);

}  // namespace scanchor
