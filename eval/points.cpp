#include "eval/points.hpp"

#include <algorithm>
#include <cassert>

namespace scanchor {

void PointScore::add(const PointScore& other) {
  if (other.classes == 0) return;
  if (classes == 0) {
    *this = other;
    return;
  }
  assert(classes == other.classes);
  for (std::size_t i = 0; i < confusion.size(); ++i) confusion[i] += other.confusion[i];
  without_truth += other.without_truth;
}

PointScore score_points(std::span<const std::int32_t> truth_class,
                        std::span<const std::int32_t> predicted_class, const ClassRules& rules) {
  assert(truth_class.size() == predicted_class.size());
  PointScore score;
  score.classes = rules.size();
  score.confusion.assign(rules.size() * rules.size(), 0);
  for (std::size_t i = 0; i < truth_class.size(); ++i) {
    const std::int32_t truth = rules.of(truth_class[i]);
    if (truth < 0) {
      ++score.without_truth;
      continue;
    }
    const std::int32_t predicted = std::max(rules.of(predicted_class[i]), 0);
    ++score.confusion[static_cast<std::size_t>(truth) * score.classes +
                      static_cast<std::size_t>(predicted)];
  }
  return score;
}

double ClassPoints::iou() const {
  return absent() ? 0.0 : static_cast<double>(right) / static_cast<double>(right + wrong + missed);
}

ClassPoints class_points(const PointScore& score, std::size_t class_id) {
  ClassPoints points;
  if (class_id >= score.classes) return points;
  points.right = score.at(class_id, class_id);
  for (std::size_t other = 0; other < score.classes; ++other) {
    if (other == class_id) continue;
    points.missed += score.at(class_id, other);
    points.wrong += score.at(other, class_id);
  }
  return points;
}

double mean_iou(const PointScore& score, const ClassRules& rules, const Protocol& protocol) {
  double sum = 0;
  int count = 0;
  for (std::size_t c = 0; c < rules.size(); ++c) {
    if (!rules.scored[c]) continue;
    const ClassPoints points = class_points(score, c);
    if (points.absent() && protocol.absent_class == "skip") continue;
    sum += points.iou();
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

double point_accuracy(const PointScore& score) {
  std::int64_t right = 0;
  std::int64_t all = 0;
  for (std::size_t t = 0; t < score.classes; ++t) {
    right += score.at(t, t);
    for (std::size_t p = 0; p < score.classes; ++p) all += score.at(t, p);
  }
  return all > 0 ? static_cast<double>(right) / static_cast<double>(all) : 0.0;
}

}  // namespace scanchor
