#pragma once
// One room through the whole chain, from one place or several, with every value written where a
// person can find it.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "eval/objects.hpp"
#include "eval/protocol.hpp"
#include "eval/score.hpp"
#include "perception/perceive.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/reason.hpp"
#include "sensors/suite.hpp"

namespace scanchor::apps {

struct Chain {
  PerceiveOptions perceive;
  ReasonOptions reason;
  Ontology ontology;
  Protocol protocol;
  bool pictures = true;
};

struct RoomResult {
  std::string name;
  std::string family;
  std::uint64_t seed = 0;
  std::size_t points = 0;
  std::size_t surfaces = 0;
  Score score;
  ObjectSummary objects;
  std::vector<std::pair<std::string, double>>
      seconds;  ///< wall time by stage, in the order of work
  std::vector<std::filesystem::path> pictures;
};

/// Generates, settles, scans from `scans` of the room's places, perceives, reasons, scores and
/// draws; writes scene.json, scan.pcd, surfaces.json, labels.json, scores.json and the pictures
/// into a folder of `out` for each scan: 07 for the first place, 07.2 for the second. The times of
/// the room itself are shared among its scans.
std::vector<RoomResult> run_room(const SceneTask& task, int scans, const Chain& chain,
                                 const std::filesystem::path& out);

}  // namespace scanchor::apps
