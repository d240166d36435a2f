#include "reasoning/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/json.hpp"
#include "reasoning/background.hpp"

namespace scanchor {

namespace {

bool asks_for(const Clause& clause, const std::string& class_name) {
  return clause.target == class_name ||
         std::any_of(clause.target_clauses.begin(), clause.target_clauses.end(),
                     [&](const Clause& nested) { return asks_for(nested, class_name); });
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string header(const ClassDescription& description) {
  std::vector<std::string> said;
  if (description.axiom) said.emplace_back("an axiom");
  if (!description.parent.empty()) said.push_back("a kind of *" + description.parent + "*");
  if (!description.part_of.empty()) said.push_back("part of *" + description.part_of + "*");
  if (description.unique) said.emplace_back("at most one in a scene");
  if (description.several_faces) said.emplace_back("may have several faces");
  if (description.names.size() > 1)
    said.push_back("also called " +
                   joined({description.names.begin() + 1, description.names.end()}));
  return joined(said);
}

std::string comment_text(const ClassDescription& description) {
  std::string text;
  for (const auto& line : description.comments) {
    // Only the lines right above the class are about it.
    if (line == blank_line) {
      text.clear();
    } else {
      text += (text.empty() ? "" : " ") + line;
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> built_on(const Ontology& ontology, const std::string& class_name) {
  std::vector<std::string> names;
  for (const auto& description : ontology.classes) {
    const bool asks =
        std::any_of(description.clauses.begin(), description.clauses.end(),
                    [&](const Clause& clause) { return asks_for(clause, class_name); });
    if (asks || description.parent == class_name || description.part_of == class_name)
      names.push_back(description.name());
  }
  return names;
}

std::string catalogue_markdown(const Ontology& ontology) {
  std::string out = fmt::format("# {}: {} classes\n", ontology.name, ontology.classes.size());
  if (!ontology.fitted_on.empty()) out += "\nRates counted on: " + ontology.fitted_on + "\n";
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    const auto& description = ontology.classes[c];
    out += "\n## " + description.name() + "\n";
    if (const auto said = header(description); !said.empty()) out += "\n" + said + "\n";
    if (const auto comment = comment_text(description); !comment.empty())
      out += "\n" + comment + "\n";
    if (!description.clauses.empty())
      out +=
          "\n| clause | holds of the class | of anything else | weight |\n| --- | --- | --- | --- "
          "|\n";
    for (const auto& clause : description.clauses) {
      out += fmt::format("| {} | {:.2f} | {:.2f} | {:.2f} |\n", clause_text(clause),
                         hit_rate_of(clause), background_of(clause), weight_of(clause));
    }
    if (const auto users = built_on(ontology, description.name()); !users.empty())
      out += "\nAsked for by: " + joined(users) + "\n";
  }
  return out;
}

nlohmann::ordered_json catalogue_json(const Ontology& ontology) {
  Json json;
  json["ontology"] = ontology.name;
  json["fitted_on"] = ontology.fitted_on;
  json["classes"] = Json::array();
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    const auto& description = ontology.classes[c];
    Json one;
    one["name"] = description.name();
    one["synonyms"] =
        std::vector<std::string>(description.names.begin() + 1, description.names.end());
    one["axiom"] = description.axiom;
    if (!description.parent.empty()) one["is_a"] = description.parent;
    if (!description.part_of.empty()) one["part_of"] = description.part_of;
    one["unique"] = description.unique;
    one["several_faces"] = description.several_faces;
    one["prior"] = prior_of(ontology, static_cast<int>(c));
    one["file"] = description.file;
    one["line"] = description.place.line;
    one["clauses"] = Json::array();
    for (const auto& clause : description.clauses) {
      one["clauses"].push_back({{"clause", clause_text(clause)},
                                {"hit_rate", hit_rate_of(clause)},
                                {"background", background_of(clause)},
                                {"weight", weight_of(clause)}});
    }
    one["asked_for_by"] = built_on(ontology, description.name());
    json["classes"].push_back(std::move(one));
  }
  return json;
}

}  // namespace scanchor
