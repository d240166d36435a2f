#pragma once
// The labelled scene as linked data: the same names as the class file in Turtle, so that any triple
// store can be used outside.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "reasoning/labelling.hpp"

namespace scanchor {

/// JSON-LD 1.1 with its context inside: every thing with class, probability, position, size, parts
/// and members, and the relations its proof rests on ("above": the desk). IRIs as in
/// ontology_to_turtle. Entities that are unknown or parts of others are included only as what their
/// whole refers to. Metres, the cloud's frame.
nlohmann::ordered_json labelling_to_jsonld(const Labelling& labelling,
                                           const std::string& scene_name);

}  // namespace scanchor
