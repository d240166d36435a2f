#include "core/json.hpp"
#include "reasoning/labelling.hpp"

namespace scanchor {

namespace {

Json clause_to_json(const ProofClause& clause) {
  Json json;
  json["clause"] = clause.text;
  json["likelihood"] = clause.likelihood;
  json["background"] = clause.background;
  if (!clause.unit.empty()) {
    json["measured"] = clause.measured;
    json["sigma"] = clause.sigma;
    json["unit"] = clause.unit;
  }
  if (!clause.target_class.empty()) json["target_class"] = clause.target_class;
  if (!clause.targets.empty()) json["targets"] = clause.targets;
  if (!clause.that_is.empty()) {
    json["that_is"] = Json::array();
    for (const auto& nested : clause.that_is) json["that_is"].push_back(clause_to_json(nested));
  }
  return json;
}

ProofClause clause_from_json(const JsonReader& reader) {
  ProofClause clause;
  clause.text = reader.at("clause").text();
  clause.likelihood = reader.at("likelihood").number_in(0.0, 1.0);
  clause.background = reader.at("background").number_in(0.0, 1.0);
  if (reader.has("unit")) {
    clause.measured = reader.at("measured").number();
    clause.sigma = reader.at("sigma").number();
    clause.unit = reader.at("unit").text();
  }
  if (reader.has("target_class")) clause.target_class = reader.at("target_class").text();
  if (reader.has("targets")) {
    const auto targets = reader.at("targets");
    for (std::size_t i = 0; i < targets.size(); ++i) {
      clause.targets.push_back(static_cast<std::int32_t>(targets.at(i).integer()));
    }
  }
  if (reader.has("that_is")) {
    const auto nested = reader.at("that_is");
    for (std::size_t i = 0; i < nested.size(); ++i)
      clause.that_is.push_back(clause_from_json(nested.at(i)));
  }
  return clause;
}

std::vector<std::int32_t> integers(const JsonReader& reader) {
  std::vector<std::int32_t> values;
  for (std::size_t i = 0; i < reader.size(); ++i)
    values.push_back(static_cast<std::int32_t>(reader.at(i).integer()));
  return values;
}

}  // namespace

nlohmann::ordered_json labelling_to_json(const Labelling& labelling,
                                         const std::vector<std::size_t>& points_of_surface) {
  Json json;
  json["format"] = "scanchor labels 1";
  json["ontology"] = labelling.ontology;
  json["mode"] = labelling.mode;
  json["up"] = to_json(labelling.up);
  json["up_sigma"] = labelling.up_sigma;
  json["entity_of_surface"] = labelling.entity_of_surface;
  if (!labelling.alternatives.empty()) {
    json["alternatives"] = Json::array();
    for (const auto& a : labelling.alternatives) {
      json["alternatives"].push_back({{"kind", a.kind},
                                      {"surfaces", a.surfaces},
                                      {"of", a.of},
                                      {"class", a.class_name},
                                      {"log_ratio", a.log_ratio},
                                      {"log_prior", a.log_prior}});
    }
  }
  Json objects = Json::array();
  for (const auto& entity : labelling.entities) {
    Json object;
    object["id"] = entity.id;
    object["class"] = entity.label;
    object["probability"] = entity.probability;
    object["center"] = to_json(entity.center);
    object["normal"] = to_json(entity.normal);
    object["size"] = to_json(entity.size);
    object["area"] = entity.area;
    std::size_t points = 0;
    for (const auto s : entity.surfaces) {
      if (static_cast<std::size_t>(s) < points_of_surface.size())
        points += points_of_surface[static_cast<std::size_t>(s)];
    }
    object["points"] = points;
    object["pose"] = to_json(entity.pose);
    object["surfaces"] = entity.surfaces;
    if (!entity.members.empty()) object["members"] = entity.members;
    if (entity.whole >= 0) object["part_of"] = entity.whole;
    if (entity.also >= 0)
      object["also"] = entity.classes[static_cast<std::size_t>(entity.also)].name;
    Json classes = Json::array();
    for (const auto& c : entity.classes)
      classes.push_back({{"class", c.name}, {"probability", c.probability}});
    object["classes"] = classes;
    Json proof = Json::array();
    for (const auto& clause : entity.proof) proof.push_back(clause_to_json(clause));
    object["proof"] = proof;
    objects.push_back(std::move(object));
  }
  json["objects"] = std::move(objects);
  return json;
}

Labelling labelling_from_json(const nlohmann::ordered_json& json, const std::string& file) {
  const JsonReader reader(json, file);
  if (reader.at("format").text() != "scanchor labels 1") {
    reader.at("format").fail("is not 'scanchor labels 1'", "label the surfaces again");
  }
  Labelling labelling;
  labelling.ontology = reader.at("ontology").text();
  labelling.mode = reader.at("mode").text();
  labelling.up = reader.at("up").vector3();
  labelling.up_sigma = reader.at("up_sigma").number_in(0.0, 10.0);
  labelling.entity_of_surface = integers(reader.at("entity_of_surface"));
  if (reader.has("alternatives")) {
    const auto list = reader.at("alternatives");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto one = list.at(i);
      labelling.alternatives.push_back({one.at("kind").text(), integers(one.at("surfaces")),
                                        static_cast<int>(one.at("of").integer()),
                                        one.at("class").text(), one.at("log_ratio").number(),
                                        one.at("log_prior").number()});
    }
  }
  const auto objects = reader.at("objects");
  const auto count = static_cast<std::int32_t>(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto object = objects.at(i);
    Entity entity;
    entity.id = static_cast<std::int32_t>(object.at("id").integer());
    if (entity.id != static_cast<std::int32_t>(i))
      object.at("id").fail("must be " + std::to_string(i) + ", its place in the list");
    entity.label = object.at("class").text();
    entity.probability = object.at("probability").number_in(0.0, 1.0);
    entity.center = object.at("center").vector3();
    entity.normal = object.at("normal").vector3();
    entity.size = object.at("size").vector3();
    entity.area = object.at("area").number();
    entity.pose = object.at("pose").pose();
    entity.surfaces = integers(object.at("surfaces"));
    for (const auto s : entity.surfaces) {
      if (s < 0 || static_cast<std::size_t>(s) >= labelling.entity_of_surface.size())
        object.at("surfaces").fail("names surface " + std::to_string(s) + ", which is not there");
    }
    if (object.has("members")) entity.members = integers(object.at("members"));
    for (const auto m : entity.members) {
      if (m < 0 || m >= count)
        object.at("members").fail("names entity " + std::to_string(m) + ", which is not there");
    }
    if (object.has("part_of")) {
      entity.whole = static_cast<std::int32_t>(object.at("part_of").integer());
      if (entity.whole < 0 || entity.whole >= count)
        object.at("part_of").fail("is " + std::to_string(entity.whole) + ", which is not there");
    }
    const auto classes = object.at("classes");
    for (std::size_t c = 0; c < classes.size(); ++c) {
      entity.classes.push_back(
          {classes.at(c).at("class").text(), classes.at(c).at("probability").number_in(0.0, 1.0)});
    }
    if (object.has("also")) {
      const std::string also = object.at("also").text();
      for (std::size_t c = 0; c < entity.classes.size(); ++c) {
        if (entity.classes[c].name == also) entity.also = static_cast<std::int32_t>(c);
      }
    }
    const auto proof = object.at("proof");
    for (std::size_t p = 0; p < proof.size(); ++p)
      entity.proof.push_back(clause_from_json(proof.at(p)));
    labelling.entities.push_back(std::move(entity));
  }
  for (const auto e : labelling.entity_of_surface) {
    if (e < 0 || e >= count)
      reader.at("entity_of_surface")
          .fail("names entity " + std::to_string(e) + ", which is not there");
  }
  return labelling;
}

}  // namespace scanchor
