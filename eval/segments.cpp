#include "eval/segments.hpp"

#include <algorithm>
#include <cassert>

#include "eval/overlap.hpp"

namespace scanchor {
namespace {

struct Key {
  std::int32_t class_id, instance;
  auto operator<=>(const Key&) const = default;
};

// Rows -> index of the segment (-1: none), and the list of keys in rising order.
struct Numbered {
  std::vector<std::int32_t> segment;
  std::vector<Key> keys;
};

Numbered number_segments(const std::vector<Key>& rows) {
  Numbered numbered;
  numbered.keys = rows;
  std::erase_if(numbered.keys, [](const Key& key) { return key.class_id < 0; });
  std::sort(numbered.keys.begin(), numbered.keys.end());
  numbered.keys.erase(std::unique(numbered.keys.begin(), numbered.keys.end()), numbered.keys.end());
  numbered.segment.resize(rows.size(), -1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].class_id < 0) continue;
    const auto found = std::lower_bound(numbered.keys.begin(), numbered.keys.end(), rows[i]);
    numbered.segment[i] = static_cast<std::int32_t>(found - numbered.keys.begin());
  }
  return numbered;
}

// `merge_stuff`: all points of a stuff class are one segment.
std::vector<Key> rows_of(const LabelColumns& columns, bool merge_stuff, const ClassRules& rules,
                         const Protocol& protocol) {
  std::vector<Key> rows(columns.class_id.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::int32_t class_id = rules.of(columns.class_id[i]);
    const std::int32_t instance = std::max(columns.instance[i], -1);
    rows[i] = {class_id, instance};
    if (class_id < 0) continue;
    if (!rules.thing[static_cast<std::size_t>(class_id)]) {
      if (merge_stuff) rows[i].instance = -1;
    } else if (instance < 0 && protocol.no_instance == "drop") {
      rows[i].class_id = -1;
    }
  }
  return rows;
}

}  // namespace

Segments make_segments(const LabelColumns& truth, const LabelColumns& predicted,
                       std::span<const float> confidence,
                       std::span<const std::int32_t> ignored_instances, const ClassRules& rules,
                       const Protocol& protocol) {
  assert(truth.class_id.size() == predicted.class_id.size());
  const auto truth_rows = rows_of(truth, true, rules, protocol);
  auto predicted_rows = rows_of(predicted, protocol.merge_stuff, rules, protocol);
  if (protocol.void_points == "remove") {
    for (std::size_t i = 0; i < truth_rows.size(); ++i) {
      if (truth_rows[i].class_id < 0) predicted_rows[i].class_id = -1;
    }
  }
  const Numbered t = number_segments(truth_rows);
  const Numbered p = number_segments(predicted_rows);

  Segments segments;
  for (const Key& key : t.keys) segments.truth.push_back({key.class_id, key.instance, 0, false});
  for (const Key& key : p.keys)
    segments.predicted.push_back({key.class_id, key.instance, 0, 0, 0.0F});
  for (const Overlap& overlap : overlap_table(t.segment, p.segment)) {
    if (overlap.truth >= 0)
      segments.truth[static_cast<std::size_t>(overlap.truth)].points += overlap.points;
    if (overlap.predicted < 0) continue;
    auto& claim = segments.predicted[static_cast<std::size_t>(overlap.predicted)];
    claim.points += overlap.points;
    if (overlap.truth < 0) {
      claim.void_points += overlap.points;
    } else {
      segments.overlaps.push_back({overlap.truth, overlap.predicted, overlap.points});
    }
  }
  for (auto& segment : segments.truth) {
    const bool stuff = !rules.thing[static_cast<std::size_t>(segment.class_id)];
    const bool unseen = !stuff && std::binary_search(ignored_instances.begin(),
                                                     ignored_instances.end(), segment.instance);
    segment.ignored =
        unseen || (protocol.small == "ignore" && segment.points < protocol.min_points);
  }
  for (const auto& overlap : segments.overlaps) {
    if (!segments.truth[static_cast<std::size_t>(overlap.truth)].ignored) continue;
    segments.predicted[static_cast<std::size_t>(overlap.predicted)].void_points += overlap.points;
  }
  for (std::size_t i = 0; i < p.segment.size(); ++i) {
    if (p.segment[i] < 0) continue;
    auto& claim = segments.predicted[static_cast<std::size_t>(p.segment[i])];
    claim.confidence = std::max(claim.confidence, confidence.empty() ? 1.0F : confidence[i]);
  }
  return segments;
}

double segment_iou(const Segments& segments, const SegmentOverlap& overlap,
                   const Protocol& protocol) {
  const auto& truth = segments.truth[static_cast<std::size_t>(overlap.truth)];
  const auto& claim = segments.predicted[static_cast<std::size_t>(overlap.predicted)];
  std::int64_t united = truth.points + claim.points - overlap.points;
  // An ignored truth is itself part of the claim's void points: its overlap is not taken off twice.
  if (protocol.void_points == "subtract")
    united -= claim.void_points - (truth.ignored ? overlap.points : 0);
  return static_cast<double>(overlap.points) /
         static_cast<double>(std::max<std::int64_t>(united, 1));
}

}  // namespace scanchor
