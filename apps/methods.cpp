#include "apps/methods.hpp"

#include <algorithm>

#include "apps/peers/peers.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace scanchor::apps {

std::vector<std::string> method_names() {
  std::vector<std::string> names = {"default", "paper"};
  for (const auto& peer : built_peers()) names.push_back(peer.name);
  return names;
}

Method find_method(const std::string& name, PerceiveOptions perceive, const Ontology& ontology,
                   ReasonOptions reason) {
  if (name == "default" || name == "paper") {
    perceive.method = name;
    reason.mode = name;
    return own_method(perceive, ontology, reason);
  }
  for (const auto& peer : built_peers()) {
    if (peer.name == name) return peer_method(name, peer.finder, perceive, ontology, reason);
  }
  if (name.starts_with("cgal-") || name.starts_with("pcl-")) {
    fail_usage("this build has no method '" + name + "'",
               "configure with -DSCANCHOR_PEERS=ON, and libpcl-dev for those of PCL");
  }
  fail_usage("unknown method '" + name + "'", suggestion(name, method_names()));
}

}  // namespace scanchor::apps
