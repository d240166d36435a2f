#pragma once
// Other people's plane finders as methods of the command. One of built.cpp and none.cpp is in the
// build (SCANCHOR_PEERS).

#include <string>
#include <vector>

#include "eval/region_surfaces.hpp"

namespace scanchor::apps {

struct Peer {
  std::string name;  ///< "cgal-region-growing"
  PlaneFinder finder;
};

/// Those of this build; empty where it has none.
const std::vector<Peer>& built_peers();

}  // namespace scanchor::apps
