#include "eval/instances.hpp"

#include <algorithm>
#include <numeric>

namespace scanchor {
namespace {

// The segments of one class in one scan.
struct OneClass {
  std::vector<std::size_t> truths, claims;  // indices into Segments
  std::vector<std::vector<double>> iou;     // [claim][truth]
};

std::vector<OneClass> by_class(const Segments& segments, const ClassRules& rules,
                               const Protocol& protocol) {
  std::vector<OneClass> classes(rules.size());
  std::vector<std::size_t> truth_place(segments.truth.size()),
      claim_place(segments.predicted.size());
  for (std::size_t i = 0; i < segments.truth.size(); ++i) {
    auto& list = classes[static_cast<std::size_t>(segments.truth[i].class_id)].truths;
    truth_place[i] = list.size();
    list.push_back(i);
  }
  for (std::size_t i = 0; i < segments.predicted.size(); ++i) {
    auto& list = classes[static_cast<std::size_t>(segments.predicted[i].class_id)].claims;
    claim_place[i] = list.size();
    list.push_back(i);
  }
  for (auto& one : classes)
    one.iou.assign(one.claims.size(), std::vector<double>(one.truths.size(), 0.0));
  for (const auto& overlap : segments.overlaps) {
    const auto t = static_cast<std::size_t>(overlap.truth);
    const auto p = static_cast<std::size_t>(overlap.predicted);
    if (segments.truth[t].class_id != segments.predicted[p].class_id) continue;
    classes[static_cast<std::size_t>(segments.truth[t].class_id)]
        .iou[claim_place[p]][truth_place[t]] = segment_iou(segments, overlap, protocol);
  }
  return classes;
}

// COCO (cocoeval.py, evaluateImg): claims by falling confidence, each takes the best free truth;
// ignored truth last.
void match_coco(const Segments& segments, const OneClass& one, const std::vector<double>& levels,
                InstanceClass& out) {
  std::vector<std::size_t> order(one.claims.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return segments.predicted[one.claims[a]].confidence >
           segments.predicted[one.claims[b]].confidence;
  });
  std::vector<InstanceClaim> detections(one.claims.size());
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const std::uint32_t bit = 1U << level;
    std::vector<char> taken(one.truths.size(), 0);
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      const std::size_t claim = order[rank];
      double best = std::min(levels[level], 1.0 - 1e-10);
      std::size_t found = one.truths.size();
      for (const bool ignored : {false, true}) {
        if (found != one.truths.size()) break;
        for (std::size_t t = 0; t < one.truths.size(); ++t) {
          if (segments.truth[one.truths[t]].ignored != ignored || taken[t] ||
              one.iou[claim][t] < best)
            continue;
          best = one.iou[claim][t];
          found = t;
        }
      }
      const auto& segment = segments.predicted[one.claims[claim]];
      detections[rank].confidence = segment.confidence;
      if (found != one.truths.size()) {
        taken[found] = 1;
        if (segments.truth[one.truths[found]].ignored) continue;
        detections[rank].counts |= bit;
        detections[rank].right |= bit;
      } else if (2 * segment.void_points <= segment.points) {
        detections[rank].counts |= bit;
      }
    }
  }
  out.detections = std::move(detections);
}

// ScanNet (evaluate_semantic_instance.py, evaluate_matches): truths in order, each takes every
// claim that overlaps enough; of two on one truth the lower confidence is a false claim.
void match_scannet(const Segments& segments, const OneClass& one, const std::vector<double>& levels,
                   const Protocol& protocol, InstanceClass& out) {
  const auto large = [&](std::size_t claim) {
    return segments.predicted[one.claims[claim]].points >= protocol.min_points;
  };
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const std::uint32_t bit = 1U << level;
    std::vector<char> visited(one.claims.size(), 0);
    for (std::size_t t = 0; t < one.truths.size(); ++t) {
      if (segments.truth[one.truths[t]].ignored) continue;
      bool matched = false;
      float confidence = 0;
      for (std::size_t claim = 0; claim < one.claims.size(); ++claim) {
        if (visited[claim] || !large(claim) || one.iou[claim][t] <= levels[level]) continue;
        const float own = segments.predicted[one.claims[claim]].confidence;
        if (matched) {
          out.detections.push_back({std::min(confidence, own), bit, 0});
          confidence = std::max(confidence, own);
        } else {
          matched = true;
          confidence = own;
          visited[claim] = 1;
        }
      }
      if (matched) out.detections.push_back({confidence, bit, bit});
    }
    for (std::size_t claim = 0; claim < one.claims.size(); ++claim) {
      if (!large(claim)) continue;
      const bool found = std::any_of(one.iou[claim].begin(), one.iou[claim].end(),
                                     [&](double iou) { return iou > levels[level]; });
      const auto& segment = segments.predicted[one.claims[claim]];
      const double unknown =
          static_cast<double>(segment.void_points) / static_cast<double>(segment.points);
      if (!found && unknown <= levels[level])
        out.detections.push_back({segment.confidence, bit, 0});
    }
  }
}

struct Entry {
  float confidence;
  bool right;
};

// cocoeval.py, accumulate: precision made monotone, read off at 101 recalls.
double area_coco(const std::vector<Entry>& entries, std::int64_t truths) {
  std::vector<double> precision, recall;
  double right = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    right += entries[i].right ? 1 : 0;
    precision.push_back(right / static_cast<double>(i + 1));
    recall.push_back(right / static_cast<double>(truths));
  }
  for (std::size_t i = precision.size(); i-- > 1;)
    precision[i - 1] = std::max(precision[i - 1], precision[i]);
  double sum = 0;
  for (int i = 0; i <= 100; ++i) {
    const double wanted = i == 100 ? 1.0 : 0.01 * i;  // as numpy's linspace
    const auto at = std::lower_bound(recall.begin(), recall.end(), wanted);
    if (at != recall.end()) sum += precision[static_cast<std::size_t>(at - recall.begin())];
  }
  return sum / 101.0;
}

// ScanNet: one point of the curve for each different confidence, area by the trapezoid-like
// convolution with (1/2, 0, -1/2).
double area_scannet(const std::vector<Entry>& entries, std::int64_t truths) {
  std::vector<double> precision = {1.0}, recall = {0.0};  // from high confidence to low
  double right = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    right += entries[i].right ? 1 : 0;
    if (i + 1 < entries.size() && entries[i + 1].confidence == entries[i].confidence) continue;
    precision.push_back(right / static_cast<double>(i + 1));
    recall.push_back(right / static_cast<double>(truths));
  }
  double sum = 0;
  for (std::size_t i = 0; i < precision.size(); ++i) {
    const double next = i + 1 < recall.size() ? recall[i + 1] : recall[i];
    const double before = i > 0 ? recall[i - 1] : 0.0;
    sum += precision[i] * 0.5 * (next - before);
  }
  return sum;
}

}  // namespace

std::vector<double> ap_levels(const Protocol& protocol) {
  std::vector<double> levels = {0.25};
  levels.insert(levels.end(), protocol.ap_thresholds.begin(), protocol.ap_thresholds.end());
  return levels;
}

InstanceScore score_instances(const Segments& segments, const ClassRules& rules,
                              const Protocol& protocol) {
  InstanceScore score;
  score.classes.resize(rules.size());
  const auto levels = ap_levels(protocol);
  const auto classes = by_class(segments, rules, protocol);
  for (std::size_t c = 0; c < classes.size(); ++c) {
    if (!rules.thing[c] || !rules.scored[c]) continue;
    InstanceClass& out = score.classes[c];
    for (const std::size_t t : classes[c].truths) out.truths += segments.truth[t].ignored ? 0 : 1;
    out.claimed = !classes[c].claims.empty();
    if (protocol.average_precision == "scannet") {
      match_scannet(segments, classes[c], levels, protocol, out);
    } else {
      match_coco(segments, classes[c], levels, out);
    }
  }
  return score;
}

void InstanceScore::add(const InstanceScore& other) {
  if (classes.size() < other.classes.size()) classes.resize(other.classes.size());
  for (std::size_t c = 0; c < other.classes.size(); ++c) {
    classes[c].truths += other.classes[c].truths;
    classes[c].claimed = classes[c].claimed || other.classes[c].claimed;
    classes[c].detections.insert(classes[c].detections.end(), other.classes[c].detections.begin(),
                                 other.classes[c].detections.end());
  }
}

double average_precision(const InstanceClass& counts, std::size_t level, const Protocol& protocol) {
  if (counts.truths == 0) return -1.0;
  std::vector<Entry> entries;
  for (const auto& detection : counts.detections) {
    if (detection.counts >> level & 1U)
      entries.push_back({detection.confidence, (detection.right >> level & 1U) != 0});
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.confidence > b.confidence; });
  if (entries.empty()) return 0.0;
  return protocol.average_precision == "scannet" ? area_scannet(entries, counts.truths)
                                                 : area_coco(entries, counts.truths);
}

double mean_average_precision(const InstanceScore& score, std::size_t level,
                              const ClassRules& rules, const Protocol& protocol) {
  double sum = 0;
  int classes = 0;
  for (std::size_t c = 0; c < std::min(rules.size(), score.classes.size()); ++c) {
    if (!rules.scored[c] || !rules.thing[c] || score.classes[c].truths == 0) continue;
    sum += average_precision(score.classes[c], level, protocol);
    ++classes;
  }
  return classes > 0 ? sum / classes : 0.0;
}

double mean_average_precision(const InstanceScore& score, const ClassRules& rules,
                              const Protocol& protocol) {
  double sum = 0;
  for (std::size_t i = 0; i < protocol.ap_thresholds.size(); ++i)
    sum += mean_average_precision(score, i + 1, rules, protocol);
  return protocol.ap_thresholds.empty() ? 0.0
                                        : sum / static_cast<double>(protocol.ap_thresholds.size());
}

}  // namespace scanchor
