#pragma once
// What `scanchor run` leaves behind, small and by hand.

#include <cstdint>

#include "core/json.hpp"
#include "eval/score.hpp"

namespace scanchor::samples {

/// summary.json of two rooms with twelve desks.
inline Json run_summary(std::int64_t found, std::int64_t wrong) {
  const Protocol protocol = find_protocol("scanchor-1");
  Score score;
  score.protocol = protocol_stamp(protocol);
  score.scans = 2;
  score.objects.classes.resize(class_list().size());
  ObjectCounts& desk = score.objects.classes[std::size_t(*find_class("desk"))];
  desk.truths = 12;
  desk.found = found;
  desk.wrong = wrong;
  Json summary;
  summary["suite"] = {{"name", "demo"}};
  summary["rooms"] = Json::array();
  for (const char* name : {"00000", "00001"}) {
    Json room;
    room["name"] = name;
    room["family"] = "office";
    room["seed"] = 1;
    room["points"] = 4;
    room["surfaces"] = 2;
    room["found"] = found / 2;
    room["there"] = 6;
    room["seconds"] = {{"scan", 0.1}, {"planes", 0.2}};
    summary["rooms"].push_back(room);
  }
  // An unscored part has no classes and no tolerances; score_to_json writes what there is.
  score.planes.hoover.resize(protocol.plane_tolerances.size());
  score.points.classes = class_list().size();
  score.points.confusion.assign(score.points.classes * score.points.classes, 0);
  score.panoptic.classes.resize(class_list().size());
  score.instances.classes.resize(class_list().size());
  summary["score"] = score_to_json(score, protocol);
  return summary;
}

}  // namespace scanchor::samples
