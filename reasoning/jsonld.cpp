#include "reasoning/jsonld.hpp"

#include <cctype>

#include "core/json.hpp"
#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

std::string underscored(std::string words) {
  for (auto& c : words) {
    if (c == ' ') c = '_';
  }
  return words;
}

std::string camel(std::string_view words) {
  std::string name;
  bool up = false;
  for (const char c : words) {
    if (c == ' ') {
      up = true;
    } else {
      name += up ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      up = false;
    }
  }
  return name;
}

}  // namespace

nlohmann::ordered_json labelling_to_jsonld(const Labelling& labelling,
                                           const std::string& scene_name) {
  Json context;
  context["@version"] = 1.1;
  context["@vocab"] = "https://scanchor.example/sdl#";
  context["class"] = "https://scanchor.example/ontology/" + underscored(labelling.ontology) + "#";
  context["xsd"] = "http://www.w3.org/2001/XMLSchema#";
  for (const auto* number : {"probability", "area"}) {
    context[number] = {{"@type", "xsd:double"}};
  }
  for (const auto* list : {"position", "size", "normal"}) {
    context[list] = {{"@container", "@list"}, {"@type", "xsd:double"}};
  }
  for (const auto& word : relation_vocabulary()) context[camel(word.words)] = {{"@type", "@id"}};
  context["hasMember"] = {{"@type", "@id"}, {"@container", "@list"}};
  context["partOf"] = {{"@type", "@id"}};

  const std::string base = "urn:scanchor:" + underscored(scene_name) + ":";
  const auto iri = [&](std::int32_t id) { return base + std::to_string(id); };
  Json graph = Json::array();
  for (const auto& entity : labelling.entities) {
    const bool named = entity.label != "unknown" && entity.label != "ambiguous";
    if (!named && entity.whole < 0) continue;
    Json node;
    node["@id"] = iri(entity.id);
    if (named) {
      node["@type"] = "class:" + underscored(entity.label);
      node["probability"] = entity.probability;
    }
    node["position"] = to_json(entity.center);
    node["size"] = to_json(entity.size);
    node["normal"] = to_json(entity.normal);
    node["area"] = entity.area;
    if (entity.whole >= 0) node["partOf"] = iri(entity.whole);
    if (!entity.members.empty()) {
      Json members = Json::array();
      for (const auto m : entity.members) members.push_back(iri(m));
      node["hasMember"] = members;
    }
    if (named) {
      for (const auto& clause : entity.proof) {
        if (clause.target_class.empty() || clause.targets.size() != 1 || clause.likelihood < 0.5)
          continue;
        if (clause.text.rfind("not ", 0) == 0 || clause.text.find("each pair") != std::string::npos)
          continue;
        for (const auto& word : relation_vocabulary()) {
          // The words of a relation stand in the clause between blanks or at its ends.
          const std::string text = " " + clause.text + " ";
          if (text.find(" " + std::string(word.words) + " ") == std::string::npos) continue;
          Json& targets = node[camel(word.words)];
          if (targets.is_null()) targets = Json::array();
          const std::string target = iri(clause.targets.front());
          bool there = false;
          for (const auto& t : targets) there = there || t == target;
          if (!there) targets.push_back(target);
        }
      }
    }
    graph.push_back(std::move(node));
  }
  Json document;
  document["@context"] = context;
  document["@graph"] = graph;
  return document;
}

}  // namespace scanchor
