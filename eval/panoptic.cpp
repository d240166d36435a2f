#include "eval/panoptic.hpp"

namespace scanchor {

void PanopticScore::add(const PanopticScore& other) {
  if (classes.size() < other.classes.size()) classes.resize(other.classes.size());
  for (std::size_t c = 0; c < other.classes.size(); ++c) {
    classes[c].matched += other.classes[c].matched;
    classes[c].extra += other.classes[c].extra;
    classes[c].missed += other.classes[c].missed;
    classes[c].iou.add(other.classes[c].iou);
  }
}

PanopticScore score_panoptic(const Segments& segments, const ClassRules& rules,
                             const Protocol& protocol) {
  PanopticScore score;
  score.classes.resize(rules.size());
  std::vector<char> truth_matched(segments.truth.size(), 0);
  std::vector<char> predicted_matched(segments.predicted.size(), 0);
  // Above one half the match is unique on both sides (Kirillov et al., theorem 1), so order does
  // not matter.
  for (const auto& overlap : segments.overlaps) {
    const auto& truth = segments.truth[static_cast<std::size_t>(overlap.truth)];
    const auto& claim = segments.predicted[static_cast<std::size_t>(overlap.predicted)];
    if (truth.ignored || truth.class_id != claim.class_id) continue;
    const double iou = segment_iou(segments, overlap, protocol);
    if (iou <= protocol.match_iou) continue;
    auto& counts = score.classes[static_cast<std::size_t>(truth.class_id)];
    ++counts.matched;
    counts.iou.add(iou);
    truth_matched[static_cast<std::size_t>(overlap.truth)] = 1;
    predicted_matched[static_cast<std::size_t>(overlap.predicted)] = 1;
  }
  const bool unpunished = protocol.small == "unpunished";
  for (std::size_t i = 0; i < segments.truth.size(); ++i) {
    const auto& truth = segments.truth[i];
    if (truth_matched[i] || truth.ignored || (unpunished && truth.points < protocol.min_points))
      continue;
    ++score.classes[static_cast<std::size_t>(truth.class_id)].missed;
  }
  for (std::size_t i = 0; i < segments.predicted.size(); ++i) {
    const auto& claim = segments.predicted[i];
    if (predicted_matched[i] || (unpunished && claim.points < protocol.min_points)) continue;
    // panopticapi: a claim that lies mostly where there is no truth is neither right nor wrong.
    if (2 * claim.void_points > claim.points) continue;
    ++score.classes[static_cast<std::size_t>(claim.class_id)].extra;
  }
  return score;
}

PanopticQuality panoptic_quality(const PanopticCounts& counts) {
  PanopticQuality quality;
  const double denominator = static_cast<double>(counts.matched) +
                             0.5 * static_cast<double>(counts.extra) +
                             0.5 * static_cast<double>(counts.missed);
  if (denominator <= 0) return quality;
  quality.classes = 1;
  quality.pq = counts.iou.value() / denominator;
  quality.sq = counts.matched > 0 ? counts.iou.value() / static_cast<double>(counts.matched) : 0.0;
  quality.rq = static_cast<double>(counts.matched) / denominator;
  return quality;
}

PanopticQuality panoptic_quality(const PanopticScore& score, ClassKind kind,
                                 const ClassRules& rules, const Protocol& protocol) {
  PanopticQuality mean;
  for (std::size_t c = 0; c < rules.size(); ++c) {
    if (!rules.scored[c]) continue;
    if (kind == ClassKind::things && !rules.thing[c]) continue;
    if (kind == ClassKind::stuff && rules.thing[c]) continue;
    const PanopticQuality one =
        c < score.classes.size() ? panoptic_quality(score.classes[c]) : PanopticQuality{};
    if (one.classes == 0 && protocol.absent_class == "skip") continue;
    mean.pq += one.pq;
    mean.sq += one.sq;
    mean.rq += one.rq;
    ++mean.classes;
  }
  if (mean.classes > 0) {
    mean.pq /= mean.classes;
    mean.sq /= mean.classes;
    mean.rq /= mean.classes;
  }
  return mean;
}

}  // namespace scanchor
