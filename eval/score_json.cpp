#include "eval/score.hpp"

#include <algorithm>

#include "core/json.hpp"

namespace scanchor {
namespace {

constexpr int schema = 1;

// FixedSum lies on a grid of 2^-36: as a double it is exact up to 2^17, and reads back to the same sum.
double out(const FixedSum& sum) { return sum.value(); }
FixedSum sum_in(const JsonReader& reader) {
  FixedSum sum;
  sum.add(reader.number_in(-6e7, 6e7));
  return sum;
}
std::int64_t count_in(const JsonReader& reader) {
  const std::int64_t value = reader.integer();
  if (value < 0) reader.fail("must not be below 0");
  return value;
}

Json planes_out(const PlaneScore& p, const Protocol& protocol) {
  Json hoover = Json::array();
  for (std::size_t i = 0; i < p.hoover.size(); ++i) {
    const auto& h = p.hoover[i];
    hoover.push_back({{"tolerance", protocol.plane_tolerances[i]}, {"correct", h.correct}, {"truth_over", h.truth_over},
                      {"regions_over", h.regions_over}, {"truth_under", h.truth_under}, {"regions_under", h.regions_under},
                      {"missed", h.missed}, {"noise", h.noise}});
  }
  return {{"hoover", hoover}, {"scans", p.scans}, {"truths", p.truths}, {"regions", p.regions}, {"truth_points", p.truth_points},
          {"region_points", p.region_points}, {"paired_points", p.paired_points}, {"small_truths", p.small_truths},
          {"small_recall_sum", out(p.small_recall)}, {"pairs", p.pairs}, {"pairs_agree", p.pairs_agree},
          {"adjusted_rand_sum", out(p.adjusted_rand)}};
}

PlaneScore planes_in(const JsonReader& r) {
  PlaneScore p;
  const auto hoover = r.at("hoover");
  for (std::size_t i = 0; i < hoover.size(); ++i) {
    const auto h = hoover.at(i);
    p.hoover.push_back({count_in(h.at("correct")), count_in(h.at("truth_over")), count_in(h.at("regions_over")),
                        count_in(h.at("truth_under")), count_in(h.at("regions_under")), count_in(h.at("missed")),
                        count_in(h.at("noise"))});
  }
  p.scans = count_in(r.at("scans"));
  p.truths = count_in(r.at("truths"));
  p.regions = count_in(r.at("regions"));
  p.truth_points = count_in(r.at("truth_points"));
  p.region_points = count_in(r.at("region_points"));
  p.paired_points = count_in(r.at("paired_points"));
  p.small_truths = count_in(r.at("small_truths"));
  p.small_recall = sum_in(r.at("small_recall_sum"));
  p.pairs = count_in(r.at("pairs"));
  p.pairs_agree = count_in(r.at("pairs_agree"));
  p.adjusted_rand = sum_in(r.at("adjusted_rand_sum"));
  return p;
}

// A class by its name, so that a stored score survives an appended class list.
std::size_t class_in(const JsonReader& r, const std::string& name) {
  const auto id = find_class(name);
  if (!id) r.fail("'" + name + "' is no class", "the score was made with another class list");
  return static_cast<std::size_t>(*id);
}
std::string class_out(std::size_t id) { return std::string(class_info(static_cast<ClassId>(id)).name); }

Json points_out(const PointScore& p) {
  Json confusion = Json::array();  // [truth, predicted, points], where there are any
  for (std::size_t t = 0; t < p.classes; ++t) {
    for (std::size_t c = 0; c < p.classes; ++c) {
      if (p.at(t, c) > 0) confusion.push_back({class_out(t), class_out(c), p.at(t, c)});
    }
  }
  return {{"without_truth", p.without_truth}, {"confusion", confusion}};
}

PointScore points_in(const JsonReader& r) {
  PointScore p;
  p.classes = class_list().size();
  p.confusion.assign(p.classes * p.classes, 0);
  p.without_truth = count_in(r.at("without_truth"));
  const auto confusion = r.at("confusion");
  for (std::size_t i = 0; i < confusion.size(); ++i) {
    const auto row = confusion.at(i);
    const auto t = class_in(row, row.at(std::size_t{0}).text());
    p.confusion[t * p.classes + class_in(row, row.at(1).text())] += count_in(row.at(2));
  }
  return p;
}

Json classes_out(const Score& s) {
  Json list = Json::object();
  for (std::size_t c = 0; c < class_list().size(); ++c) {
    Json one = Json::object();
    if (c < s.panoptic.classes.size()) {
      const auto& p = s.panoptic.classes[c];
      if (p.matched + p.extra + p.missed > 0) {
        one["panoptic"] = {{"matched", p.matched}, {"extra", p.extra}, {"missed", p.missed}, {"iou_sum", out(p.iou)}};
      }
    }
    if (c < s.objects.classes.size()) {
      const auto& o = s.objects.classes[c];
      if (o.truths + o.claims() > 0) {
        one["objects"] = {{"truths", o.truths}, {"found", o.found}, {"wrong", o.wrong}, {"repeated", o.repeated}};
      }
    }
    if (c < s.instances.classes.size()) {
      const auto& d = s.instances.classes[c];
      if (d.truths > 0 || d.claimed) {
        Json rows = Json::array();  // [confidence, bits that count, bits that are right]
        for (const auto& row : d.detections) rows.push_back({row.confidence, row.counts, row.right});
        one["instances"] = {{"truths", d.truths}, {"claimed", d.claimed}, {"detections", rows}};
      }
    }
    if (!one.empty()) list[class_out(c)] = one;
  }
  return list;
}

void classes_in(const JsonReader& r, Score& s) {
  const std::size_t count = class_list().size();
  s.panoptic.classes.resize(count);
  s.objects.classes.resize(count);
  s.instances.classes.resize(count);
  for (const auto& name : r.keys()) {
    const auto one = r.at(name);
    const std::size_t c = class_in(one, name);
    if (one.has("panoptic")) {
      const auto p = one.at("panoptic");
      s.panoptic.classes[c] = {count_in(p.at("matched")), count_in(p.at("extra")), count_in(p.at("missed")), sum_in(p.at("iou_sum"))};
    }
    if (one.has("objects")) {
      const auto o = one.at("objects");
      s.objects.classes[c] = {count_in(o.at("truths")), count_in(o.at("found")), count_in(o.at("wrong")), count_in(o.at("repeated"))};
    }
    if (!one.has("instances")) continue;
    const auto d = one.at("instances");
    auto& to = s.instances.classes[c];
    to.truths = count_in(d.at("truths"));
    to.claimed = d.at("claimed").boolean();
    const auto rows = d.at("detections");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto row = rows.at(i);
      to.detections.push_back({static_cast<float>(row.at(std::size_t{0}).number()),
                               static_cast<std::uint32_t>(count_in(row.at(1))), static_cast<std::uint32_t>(count_in(row.at(2)))});
    }
  }
}

Json errors_out(const ErrorStats& e) {
  Json histogram = Json::array();
  for (const auto& [bin, n] : e.histogram) histogram.push_back({bin, n});
  return {{"count", e.count}, {"absolute_sum", out(e.absolute)}, {"squared_sum", out(e.squared)}, {"signed_sum", out(e.signed_sum)},
          {"with_interval", e.with_interval}, {"covered", e.covered}, {"histogram", histogram}};
}

ErrorStats errors_in(const JsonReader& r) {
  ErrorStats e;
  e.count = count_in(r.at("count"));
  e.absolute = sum_in(r.at("absolute_sum"));
  e.squared = sum_in(r.at("squared_sum"));
  e.signed_sum = sum_in(r.at("signed_sum"));
  e.with_interval = count_in(r.at("with_interval"));
  e.covered = count_in(r.at("covered"));
  const auto histogram = r.at("histogram");
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    const auto row = histogram.at(i);
    e.histogram[static_cast<std::int32_t>(row.at(std::size_t{0}).integer())] = count_in(row.at(1));
  }
  return e;
}

constexpr std::pair<const char*, ErrorStats GeometryScore::*> quantities[] = {
    {"normal_deg", &GeometryScore::normal_deg}, {"offset", &GeometryScore::offset}, {"length", &GeometryScore::length},
    {"width", &GeometryScore::width}, {"area", &GeometryScore::area}, {"elevation", &GeometryScore::elevation},
    {"group_center", &GeometryScore::group_center}, {"group_size", &GeometryScore::group_size}};

Json relations_out(const std::map<std::string, RelationCounts>& relations) {
  Json list = Json::object();
  for (const auto& [name, c] : relations) {
    list[name] = {{"right", c.right}, {"wrong", c.wrong}, {"missed", c.missed}, {"judged", c.judged}, {"brier_sum", out(c.brier)}};
  }
  return list;
}

std::map<std::string, RelationCounts> relations_in(const JsonReader& r) {
  std::map<std::string, RelationCounts> relations;
  for (const auto& name : r.keys()) {
    const auto c = r.at(name);
    relations[name] = {count_in(c.at("right")), count_in(c.at("wrong")), count_in(c.at("missed")), count_in(c.at("judged")),
                       sum_in(c.at("brier_sum"))};
  }
  return relations;
}

Json bins_out(const std::vector<ReliabilityBin>& bins) {
  Json rows = Json::array();  // [bin, count, right, sum of probabilities], where there are any
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (bins[i].count > 0) rows.push_back({i, bins[i].count, bins[i].right, out(bins[i].probability)});
  }
  return {{"bins", bins.size()}, {"rows", rows}};
}

std::vector<ReliabilityBin> bins_in(const JsonReader& r) {
  std::vector<ReliabilityBin> bins(static_cast<std::size_t>(r.at("bins").number_in(0, 10000)));
  const auto rows = r.at("rows");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = rows.at(i);
    const auto place = static_cast<std::size_t>(count_in(row.at(std::size_t{0})));
    if (place >= bins.size()) row.fail("names a bin that is none");
    bins[place] = {count_in(row.at(1)), count_in(row.at(2)), sum_in(row.at(3))};
  }
  return bins;
}

}  // namespace

Json score_to_json(const Score& s, const Protocol& protocol) {
  Json json = {{"format", "scanchor-score"}, {"schema", schema}, {"protocol", s.protocol}, {"data", s.data},
               {"scans", s.scans}, {"failed", s.failed}};
  Json derived = Json::object();
  for (const auto& [name, value] : metrics(s, protocol)) derived[name] = value;
  json["metrics"] = derived;
  json["planes"] = planes_out(s.planes, protocol);
  json["points"] = points_out(s.points);
  json["classes"] = classes_out(s);
  json["objects"] = {{"ignored", s.objects.ignored}, {"not_described", s.objects.not_described}};
  Json geometry = Json::object();
  for (const auto& [name, member] : quantities) geometry[name] = errors_out(s.geometry.*member);
  json["geometry"] = geometry;
  json["relations"] = {{"clear", relations_out(s.relations.clear)}, {"borderline", relations_out(s.relations.borderline)}};
  const auto& l = s.labels;
  json["labels"] = {{"things", l.things}, {"unknown", l.unknown}, {"ambiguous", l.ambiguous}, {"unknown_right", l.unknown_right},
                    {"brier_things", l.brier_things}, {"brier_sum", out(l.brier)}, {"reliability", bins_out(l.reliability)},
                    {"risk", bins_out(l.risk)}};
  return json;
}

Score score_from_json(const Json& json, const std::string& file) {
  const JsonReader r(json, file);
  if (!r.has("format") || r.at("format").text() != "scanchor-score") r.fail("is no score", "write one with 'scanchor score --json'");
  if (r.at("schema").integer() != schema) r.at("schema").fail("is of another version of the format");
  Score s;
  s.protocol = r.at("protocol").text();
  s.data = r.at("data").text();
  s.scans = count_in(r.at("scans"));
  const auto failed = r.at("failed");
  for (std::size_t i = 0; i < failed.size(); ++i) s.failed.push_back(failed.at(i).text());
  s.planes = planes_in(r.at("planes"));
  s.points = points_in(r.at("points"));
  classes_in(r.at("classes"), s);
  s.objects.ignored = count_in(r.at("objects").at("ignored"));
  s.objects.not_described = count_in(r.at("objects").at("not_described"));
  for (const auto& [name, member] : quantities) s.geometry.*member = errors_in(r.at("geometry").at(name));
  s.relations.clear = relations_in(r.at("relations").at("clear"));
  s.relations.borderline = relations_in(r.at("relations").at("borderline"));
  const auto l = r.at("labels");
  s.labels.things = count_in(l.at("things"));
  s.labels.unknown = count_in(l.at("unknown"));
  s.labels.ambiguous = count_in(l.at("ambiguous"));
  s.labels.unknown_right = count_in(l.at("unknown_right"));
  s.labels.brier_things = count_in(l.at("brier_things"));
  s.labels.brier = sum_in(l.at("brier_sum"));
  s.labels.reliability = bins_in(l.at("reliability"));
  s.labels.risk = bins_in(l.at("risk"));
  return s;
}

}  // namespace scanchor
