#pragma once
// The score of one scan, and of many: counts that add up exactly, whatever the order.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "eval/evaluate.hpp"
#include "eval/geometry.hpp"
#include "eval/instances.hpp"
#include "eval/labels.hpp"
#include "eval/objects.hpp"
#include "eval/panoptic.hpp"
#include "eval/planes.hpp"
#include "eval/points.hpp"
#include "eval/protocol.hpp"
#include "eval/relations.hpp"

namespace scanchor {

/// Everything that was counted. Pooled numbers are made of pooled counts, never of means of ratios.
struct Score {
  std::string protocol;  ///< protocol_stamp; empty: nothing scored yet
  std::string data;      ///< what was scored: name and hash of the data set or suite; may be empty
  std::int64_t scans = 0;
  std::vector<std::string>
      failed;  ///< scans without an answer, scored as all missed: "name: cause"
  PlaneScore planes;
  PointScore points;
  PanopticScore panoptic;
  InstanceScore instances;
  ObjectScore objects;
  GeometryScore geometry;
  RelationScore relations;
  LabelScore labels;
  /// Adds another score. Throws Error(bad_data) where protocol or data differ: such numbers cannot
  /// be compared, let alone added.
  void add(const Score& other);
  friend bool operator==(const Score&, const Score&) = default;
};

/// An answer to a scan. Only `points` is needed; the others add geometry, calibration and groups.
struct ScanAnswer {
  PointPrediction points;
  const Surfaces* surfaces = nullptr;
  const Labelling* labelling = nullptr;
  std::vector<ClassId> described;        ///< classes that the method has a word for; empty: all
  std::vector<NamedRelation> relations;  ///< claims in terms of the truth's ids
};

/// Holds an answer against the truth. `scene` may be null; `relations`: true relations that
/// ScanAnswer::relations is held against, empty: those between planes are scored (plane_relations),
/// where the answer has surfaces and a labelling. `details` may be null. Throws Error(bad_data)
/// where the answer has another number of points than the scan, or says what cannot be (NaN, class
/// that is none).
Score score_scan(const Scan& scan, const Scene* scene, const ScanAnswer& answer,
                 const Protocol& protocol, const std::vector<NamedRelation>& relations = {},
                 ObjectSummary* details = nullptr);
Score score_scan(const Scan& scan, const Scene* scene, const PointPrediction& prediction,
                 const Protocol& protocol);

/// The score of a scan on which the method gave no answer: all missed, and listed with the cause.
Score score_failed(const Scan& scan, const Scene* scene, const std::string& name,
                   const std::string& cause, const Protocol& protocol);

/// All derived numbers by name, in a fixed order: "points.miou", "panoptic.pq",
/// "planes.recall@0.80", "objects.f1.desk", ... Classes that are in neither truth nor answer are
/// left out. docs/reference/metrics.md defines each.
std::vector<std::pair<std::string, double>> metrics(const Score& score, const Protocol& protocol);
/// One of them. Throws Error(wrong_usage) with "did you mean".
double metric(const Score& score, const Protocol& protocol, const std::string& name);

/// Throws Error(bad_data) unless both were made under the same protocol and on the same data.
void require_comparable(const Score& a, const Score& b);

/// scores.json: stamp, counts and derived numbers; reading takes the counts and checks them.
nlohmann::ordered_json score_to_json(const Score& score, const Protocol& protocol);
Score score_from_json(const nlohmann::ordered_json& json, const std::string& file);

}  // namespace scanchor
