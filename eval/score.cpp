#include "eval/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "eval/plane_relations.hpp"
#include "eval/truth.hpp"

namespace scanchor {
namespace {

void check_answer(const Scan& scan, const PointPrediction& p) {
  const std::size_t count = scan.truth.size();
  const auto check = [&](const char* column, std::size_t size, bool may_be_empty) {
    if (size == count || (size == 0 && may_be_empty)) return;
    fail_data("prediction", "",
              fmt::format("{} has {} rows, the scan has {} points", column, size, count),
              "one row a point, in the scan's order");
  };
  check("class_id", p.class_id.size(), false);
  check("instance", p.instance.size(), true);
  check("plane", p.plane.size(), true);
  check("confidence", p.confidence.size(), true);
  const auto classes = static_cast<std::int32_t>(class_list().size());
  for (std::size_t i = 0; i < p.class_id.size(); ++i) {
    if (p.class_id[i] >= classes) {
      fail_data("prediction", fmt::format("point {}", i),
                fmt::format("class {} is not in the class list", p.class_id[i]),
                "is the label map another one?");
    }
  }
  for (std::size_t i = 0; i < p.confidence.size(); ++i) {
    if (std::isfinite(p.confidence[i]) && p.confidence[i] >= 0.0F && p.confidence[i] <= 1.0F)
      continue;
    fail_data("prediction", fmt::format("point {}", i),
              fmt::format("confidence {} does not lie in 0 .. 1", p.confidence[i]));
  }
}

using Metrics = std::vector<std::pair<std::string, double>>;

void error_metrics(const std::string& name, const ErrorStats& stats, Metrics& list) {
  if (stats.count == 0) return;
  list.emplace_back("geometry." + name + ".mean", stats.mean());
  list.emplace_back("geometry." + name + ".median", stats.quantile(0.5));
  list.emplace_back("geometry." + name + ".rms", stats.rms());
  if (stats.with_interval > 0)
    list.emplace_back("geometry." + name + ".coverage", stats.coverage());
}

void relation_metrics(const std::string& prefix,
                      const std::map<std::string, RelationCounts>& relations, Metrics& list) {
  if (relations.empty()) return;
  RelationCounts all;
  for (const auto& [name, counts] : relations) all.add(counts);
  list.emplace_back(prefix + "precision", all.precision());
  list.emplace_back(prefix + "recall", all.recall());
  for (const auto& [name, counts] : relations) {
    list.emplace_back(prefix + "precision." + name, counts.precision());
    list.emplace_back(prefix + "recall." + name, counts.recall());
  }
}

}  // namespace

void Score::add(const Score& other) {
  if (other.protocol.empty()) return;
  if (protocol.empty()) {
    *this = other;
    return;
  }
  require_comparable(*this, other);
  scans += other.scans;
  failed.insert(failed.end(), other.failed.begin(), other.failed.end());
  planes.add(other.planes);
  points.add(other.points);
  panoptic.add(other.panoptic);
  instances.add(other.instances);
  objects.add(other.objects);
  geometry.add(other.geometry);
  relations.add(other.relations);
  labels.add(other.labels);
}

void require_comparable(const Score& a, const Score& b) {
  if (a.protocol != b.protocol) {
    fail_data("", "",
              fmt::format("scores under different protocols do not compare: {} and {}", a.protocol,
                          b.protocol),
              "score both under one protocol");
  }
  if (a.data != b.data) {
    fail_data("", "",
              fmt::format("scores of different data do not compare: '{}' and '{}'", a.data, b.data),
              "score both on the same suite or data set");
  }
}

Score score_scan(const Scan& scan, const Scene* scene, const ScanAnswer& answer,
                 const Protocol& protocol, const std::vector<NamedRelation>& relations,
                 ObjectSummary* details) {
  PointPrediction p = answer.points;
  check_answer(scan, p);
  p.instance.resize(p.class_id.size(), -1);
  p.plane.resize(p.class_id.size(), -1);
  const ScanTruth truth = truth_of(scan, scene, protocol);
  const ClassRules rules = class_rules(protocol);

  Score score;
  score.protocol = protocol_stamp(protocol);
  score.scans = 1;
  PlaneMatch match;
  score.planes = score_planes(truth.plane, truth.ignored_planes, p.plane, protocol, &match);
  score.points = score_points(truth.class_id, p.class_id, rules);
  const Segments segments =
      make_segments({truth.class_id, truth.instance}, {p.class_id, p.instance}, p.confidence,
                    truth.ignored_instances, rules, protocol);
  score.panoptic = score_panoptic(segments, rules, protocol);
  score.instances = score_instances(segments, rules, protocol);
  const ObjectSummary objects = summarize_objects(truth, p, protocol, answer.described);
  score.objects = objects.score;
  if (answer.surfaces)
    score.geometry = score_geometry(truth, match, *answer.surfaces, scan, protocol);
  if (answer.labelling && scene)
    score_groups(objects, *answer.labelling, scan, *scene, score.geometry);
  score.labels = score_labels(
      answer.surfaces && answer.labelling
          ? labelled_things(truth, *answer.surfaces, *answer.labelling, protocol, answer.described)
          : labelled_things(objects),
      protocol);
  if (!relations.empty()) {
    score.relations = score_relations(relations, answer.relations);
  } else if (answer.surfaces && answer.labelling && scene) {
    PlaneRelations planes =
        plane_relations(scan, *scene, truth, match, *answer.surfaces, answer.labelling->up,
                        answer.labelling->up_sigma, protocol);
    score.relations = score_relations(std::move(planes.truth), std::move(planes.claims));
  }
  if (details) *details = objects;
  return score;
}

Score score_scan(const Scan& scan, const Scene* scene, const PointPrediction& prediction,
                 const Protocol& protocol) {
  ScanAnswer answer;
  answer.points = prediction;
  return score_scan(scan, scene, answer, protocol);
}

Score score_failed(const Scan& scan, const Scene* scene, const std::string& name,
                   const std::string& cause, const Protocol& protocol) {
  PointPrediction nothing;
  nothing.class_id.assign(scan.truth.size(), unlabelled);
  Score score = score_scan(scan, scene, nothing, protocol);
  score.failed.push_back(name + ": " + cause);
  return score;
}

Metrics metrics(const Score& score, const Protocol& protocol) {
  const ClassRules rules = class_rules(protocol);
  Metrics list;
  list.emplace_back("scans", static_cast<double>(score.scans));
  list.emplace_back("scans.failed", static_cast<double>(score.failed.size()));
  const ObjectCounts total = score.objects.total();
  list.emplace_back("objects.precision", total.precision());
  list.emplace_back("objects.recall", total.recall());
  list.emplace_back("objects.f1", total.f1());
  list.emplace_back("objects.mean_f1", score.objects.mean_f1());
  list.emplace_back("points.miou", mean_iou(score.points, rules, protocol));
  list.emplace_back("points.accuracy", point_accuracy(score.points));
  const std::pair<const char*, ClassKind> kinds[] = {
      {"", ClassKind::all}, {"_things", ClassKind::things}, {"_stuff", ClassKind::stuff}};
  for (const auto& [suffix, kind] : kinds) {
    const PanopticQuality q = panoptic_quality(score.panoptic, kind, rules, protocol);
    list.emplace_back(std::string("panoptic.pq") + suffix, q.pq);
    list.emplace_back(std::string("panoptic.sq") + suffix, q.sq);
    list.emplace_back(std::string("panoptic.rq") + suffix, q.rq);
  }
  list.emplace_back("instances.ap25", mean_average_precision(score.instances, 0, rules, protocol));
  for (std::size_t i = 0; i < protocol.ap_thresholds.size(); ++i) {
    if (protocol.ap_thresholds[i] != 0.5) continue;
    list.emplace_back("instances.ap50",
                      mean_average_precision(score.instances, i + 1, rules, protocol));
  }
  list.emplace_back("instances.ap", mean_average_precision(score.instances, rules, protocol));
  for (std::size_t i = 0; i < protocol.plane_tolerances.size(); ++i) {
    const double tolerance = protocol.plane_tolerances[i];
    list.emplace_back(fmt::format("planes.precision@{:.2f}", tolerance),
                      plane_precision(score.planes, i));
    list.emplace_back(fmt::format("planes.recall@{:.2f}", tolerance),
                      plane_recall(score.planes, i));
    list.emplace_back(fmt::format("planes.f1@{:.2f}", tolerance), plane_f1(score.planes, i));
  }
  list.emplace_back("planes.adjusted_precision", adjusted_precision(score.planes));
  list.emplace_back("planes.adjusted_recall", adjusted_recall(score.planes));
  list.emplace_back("planes.small_recall", small_plane_recall(score.planes));
  list.emplace_back("planes.rand", rand_index(score.planes));
  list.emplace_back("planes.adjusted_rand", adjusted_rand_index(score.planes));
  error_metrics("normal_deg", score.geometry.normal_deg, list);
  error_metrics("offset", score.geometry.offset, list);
  error_metrics("length", score.geometry.length, list);
  error_metrics("width", score.geometry.width, list);
  error_metrics("area", score.geometry.area, list);
  error_metrics("elevation", score.geometry.elevation, list);
  error_metrics("group_center", score.geometry.group_center, list);
  error_metrics("group_size", score.geometry.group_size, list);
  list.emplace_back("labels.ece", expected_calibration_error(score.labels));
  list.emplace_back("labels.brier", brier_score(score.labels));
  list.emplace_back("labels.unknown_rate", unknown_rate(score.labels));
  list.emplace_back("labels.ambiguous_rate", ambiguous_rate(score.labels));
  list.emplace_back("labels.area_under_risk", area_under_risk(score.labels));
  relation_metrics("relations.", score.relations.clear, list);
  relation_metrics("relations.borderline.", score.relations.borderline, list);
  for (std::size_t c = 0; c < rules.size(); ++c) {
    if (!rules.scored[c]) continue;
    const ObjectCounts counts =
        c < score.objects.classes.size() ? score.objects.classes[c] : ObjectCounts{};
    if (counts.truths + counts.claims() > 0) {
      list.emplace_back("objects.precision." + rules.names[c], counts.precision());
      list.emplace_back("objects.recall." + rules.names[c], counts.recall());
      list.emplace_back("objects.f1." + rules.names[c], counts.f1());
    }
    const ClassPoints points = class_points(score.points, c);
    if (!points.absent()) list.emplace_back("points.iou." + rules.names[c], points.iou());
    if (c < score.panoptic.classes.size() &&
        panoptic_quality(score.panoptic.classes[c]).classes > 0) {
      list.emplace_back("panoptic.pq." + rules.names[c],
                        panoptic_quality(score.panoptic.classes[c]).pq);
    }
  }
  return list;
}

double metric(const Score& score, const Protocol& protocol, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [known, value] : metrics(score, protocol)) {
    if (known == name) return value;
    names.push_back(known);
  }
  fail_usage(fmt::format("unknown metric '{}'", name), suggestion(name, names));
}

}  // namespace scanchor
