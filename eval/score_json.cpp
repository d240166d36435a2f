#include "eval/score.hpp"

#include <cmath>

#include "core/json.hpp"

namespace scanchor {
namespace {

constexpr int schema = 1;

// One declaration of the counts of a struct serves both directions.
struct Field {
  const char* name;
  std::int64_t* count = nullptr;
  FixedSum* sum = nullptr;
  Field(const char* n, std::int64_t& c) : name(n), count(&c) {}
  Field(const char* n, FixedSum& s) : name(n), sum(&s) {}
};
using Fields = std::vector<Field>;

std::int64_t count_in(const JsonReader& reader) {
  const std::int64_t value = reader.integer();
  if (value < 0) reader.fail("must not be below 0");
  return value;
}
// FixedSum lies on a grid of 2^-36: as a double it is exact up to 2^17 and reads back to the same
// sum. Larger ones are written as a whole number and a rest, [136393, 0.4725], both exact.
FixedSum sum_in(const JsonReader& reader) {
  FixedSum sum;
  if (reader.raw().is_array()) {
    sum.add(reader.at(std::size_t{0}).number_in(-6e7, 6e7));
    sum.add(reader.at(1).number_in(-1.0, 1.0));
  } else {
    sum.add(reader.number_in(-6e7, 6e7));
  }
  return sum;
}

Json sum_out(const FixedSum& sum) {
  FixedSum back;
  back.add(sum.value());
  if (back == sum) return sum.value();
  const double whole = std::trunc(sum.value());
  FixedSum rest = sum;
  rest.add(-whole);
  return Json::array({whole, rest.value()});
}

void put(Json& json, const char* name, Json value) { json[name] = std::move(value); }

Json fields_out(const Fields& fields) {
  Json json = Json::object();
  for (const auto& field : fields) {
    if (field.count) put(json, field.name, *field.count);
    if (field.sum) put(json, field.name, sum_out(*field.sum));
  }
  return json;
}

void fields_in(const JsonReader& reader, const Fields& fields) {
  for (const auto& field : fields) {
    if (field.count) *field.count = count_in(reader.at(field.name));
    if (field.sum) *field.sum = sum_in(reader.at(field.name));
  }
}

Fields fields_of(HooverCounts& h) {
  return {{"correct", h.correct},
          {"truth_over", h.truth_over},
          {"regions_over", h.regions_over},
          {"truth_under", h.truth_under},
          {"regions_under", h.regions_under},
          {"missed", h.missed},
          {"noise", h.noise}};
}
Fields fields_of(PlaneScore& p) {
  return {{"scans", p.scans},
          {"truths", p.truths},
          {"regions", p.regions},
          {"truth_points", p.truth_points},
          {"region_points", p.region_points},
          {"paired_points", p.paired_points},
          {"small_truths", p.small_truths},
          {"small_recall_sum", p.small_recall},
          {"pairs", p.pairs},
          {"pairs_agree", p.pairs_agree},
          {"adjusted_rand_sum", p.adjusted_rand}};
}
Fields fields_of(PanopticCounts& p) {
  return {{"matched", p.matched}, {"extra", p.extra}, {"missed", p.missed}, {"iou_sum", p.iou}};
}
Fields fields_of(ObjectCounts& o) {
  return {{"truths", o.truths}, {"found", o.found}, {"wrong", o.wrong}, {"repeated", o.repeated}};
}
Fields fields_of(ErrorStats& e) {
  return {
      {"count", e.count},           {"absolute_sum", e.absolute},       {"squared_sum", e.squared},
      {"signed_sum", e.signed_sum}, {"with_interval", e.with_interval}, {"covered", e.covered}};
}
Fields fields_of(RelationCounts& c) {
  return {{"right", c.right},
          {"wrong", c.wrong},
          {"missed", c.missed},
          {"judged", c.judged},
          {"brier_sum", c.brier}};
}
Fields fields_of(LabelScore& l) {
  return {{"things", l.things},
          {"unknown", l.unknown},
          {"ambiguous", l.ambiguous},
          {"unknown_right", l.unknown_right},
          {"brier_things", l.brier_things},
          {"brier_sum", l.brier}};
}

template <class Counts>
Json counts_out(const Counts& counts) {
  Counts copy = counts;  // fields_of points into it
  return fields_out(fields_of(copy));
}
template <class Counts>
Counts counts_in(const JsonReader& reader) {
  Counts counts;
  fields_in(reader, fields_of(counts));
  return counts;
}

Json row_of(std::int64_t a, std::int64_t b) {
  Json row = Json::array();
  row.push_back(a);
  row.push_back(b);
  return row;
}

Json planes_out(const PlaneScore& planes, const Protocol& protocol) {
  Json json = counts_out(planes);
  Json hoover = Json::array();
  for (std::size_t i = 0; i < planes.hoover.size(); ++i) {
    Json row = Json::object();
    put(row, "tolerance", protocol.plane_tolerances[i]);
    row.update(counts_out(planes.hoover[i]));
    hoover.push_back(std::move(row));
  }
  put(json, "hoover", std::move(hoover));
  return json;
}

PlaneScore planes_in(const JsonReader& reader) {
  auto planes = counts_in<PlaneScore>(reader);
  const auto hoover = reader.at("hoover");
  for (std::size_t i = 0; i < hoover.size(); ++i)
    planes.hoover.push_back(counts_in<HooverCounts>(hoover.at(i)));
  return planes;
}

// A class by its name, so that a stored score survives an appended class list.
std::size_t class_in(const JsonReader& reader, const std::string& name) {
  const auto id = find_class(name);
  if (!id) reader.fail("'" + name + "' is no class", "the score was made with another class list");
  return static_cast<std::size_t>(*id);
}
std::string class_out(std::size_t id) {
  return std::string(class_info(static_cast<ClassId>(id)).name);
}

Json points_out(const PointScore& points) {
  Json confusion = Json::object();  // truth -> predicted -> points, where there are any
  for (std::size_t t = 0; t < points.classes; ++t) {
    Json row = Json::object();
    for (std::size_t c = 0; c < points.classes; ++c) {
      if (points.at(t, c) > 0) row[class_out(c)] = points.at(t, c);
    }
    if (!row.empty()) confusion[class_out(t)] = std::move(row);
  }
  Json json = Json::object();
  put(json, "without_truth", points.without_truth);
  put(json, "confusion", std::move(confusion));
  return json;
}

PointScore points_in(const JsonReader& reader) {
  PointScore points;
  points.classes = class_list().size();
  points.confusion.assign(points.classes * points.classes, 0);
  points.without_truth = count_in(reader.at("without_truth"));
  const auto confusion = reader.at("confusion");
  for (const auto& truth : confusion.keys()) {
    const auto row = confusion.at(truth);
    for (const auto& predicted : row.keys()) {
      points.confusion[class_in(row, truth) * points.classes + class_in(row, predicted)] =
          count_in(row.at(predicted));
    }
  }
  return points;
}

Json instances_out(const InstanceClass& counts) {
  Json rows = Json::array();  // [confidence, bits that count, bits that are right]
  for (const auto& detection : counts.detections) {
    Json row = Json::array();
    row.push_back(detection.confidence);
    row.push_back(detection.counts);
    row.push_back(detection.right);
    rows.push_back(std::move(row));
  }
  Json json = Json::object();
  put(json, "truths", counts.truths);
  put(json, "claimed", counts.claimed);
  put(json, "detections", std::move(rows));
  return json;
}

InstanceClass instances_in(const JsonReader& reader) {
  InstanceClass counts;
  counts.truths = count_in(reader.at("truths"));
  counts.claimed = reader.at("claimed").boolean();
  const auto rows = reader.at("detections");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = rows.at(i);
    counts.detections.push_back({static_cast<float>(row.at(std::size_t{0}).number()),
                                 static_cast<std::uint32_t>(count_in(row.at(1))),
                                 static_cast<std::uint32_t>(count_in(row.at(2)))});
  }
  return counts;
}

Json classes_out(const Score& score) {
  Json list = Json::object();
  for (std::size_t c = 0; c < class_list().size(); ++c) {
    Json one = Json::object();
    if (c < score.panoptic.classes.size() && score.panoptic.classes[c] != PanopticCounts{}) {
      put(one, "panoptic", counts_out(score.panoptic.classes[c]));
    }
    if (c < score.objects.classes.size() && score.objects.classes[c] != ObjectCounts{}) {
      put(one, "objects", counts_out(score.objects.classes[c]));
    }
    if (c < score.instances.classes.size() && score.instances.classes[c] != InstanceClass{}) {
      put(one, "instances", instances_out(score.instances.classes[c]));
    }
    if (!one.empty()) list[class_out(c)] = std::move(one);
  }
  return list;
}

void classes_in(const JsonReader& reader, Score& score) {
  const std::size_t count = class_list().size();
  score.panoptic.classes.resize(count);
  score.objects.classes.resize(count);
  score.instances.classes.resize(count);
  for (const auto& name : reader.keys()) {
    const auto one = reader.at(name);
    const std::size_t c = class_in(one, name);
    if (one.has("panoptic"))
      score.panoptic.classes[c] = counts_in<PanopticCounts>(one.at("panoptic"));
    if (one.has("objects")) score.objects.classes[c] = counts_in<ObjectCounts>(one.at("objects"));
    if (one.has("instances")) score.instances.classes[c] = instances_in(one.at("instances"));
  }
}

Json errors_out(const ErrorStats& errors) {
  Json json = counts_out(errors);
  Json histogram = Json::array();
  for (const auto& [bin, n] : errors.histogram) histogram.push_back(row_of(bin, n));
  put(json, "histogram", std::move(histogram));
  return json;
}

ErrorStats errors_in(const JsonReader& reader) {
  auto errors = counts_in<ErrorStats>(reader);
  const auto histogram = reader.at("histogram");
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    const auto row = histogram.at(i);
    errors.histogram[static_cast<std::int32_t>(row.at(std::size_t{0}).integer())] =
        count_in(row.at(1));
  }
  return errors;
}

constexpr std::pair<const char*, ErrorStats GeometryScore::*> quantities[] = {
    {"normal_deg", &GeometryScore::normal_deg},
    {"offset", &GeometryScore::offset},
    {"length", &GeometryScore::length},
    {"width", &GeometryScore::width},
    {"area", &GeometryScore::area},
    {"elevation", &GeometryScore::elevation},
    {"group_center", &GeometryScore::group_center},
    {"group_size", &GeometryScore::group_size}};

Json relations_out(const std::map<std::string, RelationCounts>& relations) {
  Json list = Json::object();
  for (const auto& [name, counts] : relations) list[name] = counts_out(counts);
  return list;
}

std::map<std::string, RelationCounts> relations_in(const JsonReader& reader) {
  std::map<std::string, RelationCounts> relations;
  for (const auto& name : reader.keys())
    relations[name] = counts_in<RelationCounts>(reader.at(name));
  return relations;
}

Json bins_out(const std::vector<ReliabilityBin>& bins) {
  Json rows = Json::array();  // [bin, count, right, sum of probabilities], where there are any
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].count == 0) continue;
    Json row = row_of(static_cast<std::int64_t>(i), bins[i].count);
    row.push_back(bins[i].right);
    row.push_back(bins[i].probability.value());
    rows.push_back(std::move(row));
  }
  Json json = Json::object();
  put(json, "bins", bins.size());
  put(json, "rows", std::move(rows));
  return json;
}

std::vector<ReliabilityBin> bins_in(const JsonReader& reader) {
  std::vector<ReliabilityBin> bins(static_cast<std::size_t>(reader.at("bins").number_in(0, 10000)));
  const auto rows = reader.at("rows");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = rows.at(i);
    const auto place = static_cast<std::size_t>(count_in(row.at(std::size_t{0})));
    if (place >= bins.size()) row.fail("names a bin that is none");
    bins[place] = {count_in(row.at(1)), count_in(row.at(2)), sum_in(row.at(3))};
  }
  return bins;
}

}  // namespace

Json score_to_json(const Score& score, const Protocol& protocol) {
  Json json = Json::object();
  put(json, "format", "scanchor-score");
  put(json, "schema", schema);
  put(json, "protocol", score.protocol);
  put(json, "data", score.data);
  put(json, "scans", score.scans);
  put(json, "failed", score.failed);
  Json derived = Json::object();
  for (const auto& [name, value] : metrics(score, protocol)) derived[name] = value;
  put(json, "metrics", std::move(derived));
  put(json, "planes", planes_out(score.planes, protocol));
  put(json, "points", points_out(score.points));
  put(json, "classes", classes_out(score));
  put(json, "ignored_things", score.objects.ignored);
  put(json, "not_described_things", score.objects.not_described);
  Json geometry = Json::object();
  for (const auto& [name, member] : quantities)
    put(geometry, name, errors_out(score.geometry.*member));
  put(json, "geometry", std::move(geometry));
  Json relations = Json::object();
  put(relations, "clear", relations_out(score.relations.clear));
  put(relations, "borderline", relations_out(score.relations.borderline));
  put(json, "relations", std::move(relations));
  Json labels = counts_out(score.labels);
  put(labels, "reliability", bins_out(score.labels.reliability));
  put(labels, "risk", bins_out(score.labels.risk));
  put(json, "labels", std::move(labels));
  return json;
}

Score score_from_json(const Json& json, const std::string& file) {
  const JsonReader reader(json, file);
  if (!reader.has("format") || reader.at("format").text() != "scanchor-score") {
    reader.fail("is no score", "'scanchor score --json' writes one");
  }
  if (reader.at("schema").integer() != schema)
    reader.at("schema").fail("is of another version of the format");
  Score score;
  score.protocol = reader.at("protocol").text();
  score.data = reader.at("data").text();
  score.scans = count_in(reader.at("scans"));
  const auto failed = reader.at("failed");
  for (std::size_t i = 0; i < failed.size(); ++i) score.failed.push_back(failed.at(i).text());
  score.planes = planes_in(reader.at("planes"));
  score.points = points_in(reader.at("points"));
  classes_in(reader.at("classes"), score);
  score.objects.ignored = count_in(reader.at("ignored_things"));
  score.objects.not_described = count_in(reader.at("not_described_things"));
  for (const auto& [name, member] : quantities)
    score.geometry.*member = errors_in(reader.at("geometry").at(name));
  score.relations.clear = relations_in(reader.at("relations").at("clear"));
  score.relations.borderline = relations_in(reader.at("relations").at("borderline"));
  const auto labels = reader.at("labels");
  score.labels = counts_in<LabelScore>(labels);
  score.labels.reliability = bins_in(labels.at("reliability"));
  score.labels.risk = bins_in(labels.at("risk"));
  return score;
}

}  // namespace scanchor
