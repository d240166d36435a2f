#pragma once
// Average precision of things, by COCO's or by ScanNet's rules.

#include <cstdint>
#include <vector>

#include "eval/segments.hpp"

namespace scanchor {

/// One claim of a class, at all thresholds at once: bit i stands for ap_levels(protocol)[i].
struct InstanceClaim {
  float confidence = 1.0F;
  std::uint32_t counts = 0;  ///< bit: an entry of the precision-recall curve at this threshold
  std::uint32_t right = 0;   ///< bit: matched
  friend bool operator==(const InstanceClaim&, const InstanceClaim&) = default;
};

struct InstanceClass {
  std::int64_t truths = 0;                ///< things that count
  std::vector<InstanceClaim> detections;  ///< in the order of the scans
  bool claimed = false;                   ///< somebody claimed the class at all
  friend bool operator==(const InstanceClass&, const InstanceClass&) = default;
};

struct InstanceScore {
  std::vector<InstanceClass> classes;  ///< by ClassId
  /// Appends. Associative; equal confidences keep the order of the scans, as COCO's stable sort
  /// does.
  void add(const InstanceScore& other);
  friend bool operator==(const InstanceScore&, const InstanceScore&) = default;
};

/// 0.25, and then the protocol's thresholds.
std::vector<double> ap_levels(const Protocol& protocol);

InstanceScore score_instances(const Segments& segments, const ClassRules& rules,
                              const Protocol& protocol);

/// AP of one class at one level (index into ap_levels); negative: the class has no truth and is
/// left out of means.
double average_precision(const InstanceClass& counts, std::size_t level, const Protocol& protocol);
/// Mean over classes that have truth. 0 where there is none.
double mean_average_precision(const InstanceScore& score, std::size_t level,
                              const ClassRules& rules, const Protocol& protocol);
/// Mean over the protocol's thresholds too: "AP" of COCO (0.5 .. 0.95) and ScanNet (0.5 .. 0.9).
double mean_average_precision(const InstanceScore& score, const ClassRules& rules,
                              const Protocol& protocol);

}  // namespace scanchor
