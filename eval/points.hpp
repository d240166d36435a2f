#pragma once
// Semantic segmentation of points: confusion, intersection over union, accuracy.

#include <cstdint>
#include <span>
#include <vector>

#include "eval/protocol.hpp"

namespace scanchor {

/// Counts of points by (truth class, predicted class), added up over scans.
struct PointScore {
  std::size_t classes = 0;
  /// classes x classes, row = truth, column = predicted. Column 0 takes what was left unlabelled or
  /// is not scored; rows without truth stay empty, because such points count on neither side.
  std::vector<std::int64_t> confusion;
  std::int64_t without_truth = 0;  ///< points that were left out
  [[nodiscard]] std::int64_t at(std::size_t truth, std::size_t predicted) const {
    return confusion[truth * classes + predicted];
  }
  void add(const PointScore& other);
  friend bool operator==(const PointScore&, const PointScore&) = default;
};

PointScore score_points(std::span<const std::int32_t> truth_class,
                        std::span<const std::int32_t> predicted_class, const ClassRules& rules);

/// Of one class: TP, FP and FN in points.
struct ClassPoints {
  std::int64_t right = 0, wrong = 0, missed = 0;
  /// IoU = TP / (TP + FP + FN); 0 for an absent class.
  [[nodiscard]] double iou() const;
  [[nodiscard]] bool absent() const { return right + wrong + missed == 0; }
};
ClassPoints class_points(const PointScore& score, std::size_t class_id);
/// Mean IoU over the scored classes, absent ones as the protocol says.
double mean_iou(const PointScore& score, const ClassRules& rules, const Protocol& protocol);
/// Share of the points with truth whose class is right.
double point_accuracy(const PointScore& score);

}  // namespace scanchor
