#pragma once
// Methods by the names that --method takes: ours, the paper's, and other people's plane finders.

#include <string>
#include <vector>

#include "eval/run.hpp"

namespace scanchor::apps {

/// "default", "paper", and the peers of this build.
std::vector<std::string> method_names();

/// Throws Error(wrong_usage) for an unknown name, and for a peer that this build does not have.
Method find_method(const std::string& name, PerceiveOptions perceive, const Ontology& ontology,
                   ReasonOptions reason);

}  // namespace scanchor::apps
