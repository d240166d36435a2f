#include "reasoning/owl.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <set>

#include "reasoning/sdl_words.hpp"

namespace scanchor {

namespace {

std::string camel(const std::string& words) {
  std::string name;
  bool up = false;
  for (const char c : words) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (!letter) {
      up = true;
      continue;
    }
    name +=
        up && !name.empty() ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    up = false;
  }
  return name;
}

/// A local name that Turtle takes as it is; every other byte goes as its code, so that names stay
/// apart.
std::string local_name(const std::string& words) {
  std::string name;
  for (const char c : words) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      name += c;
    } else if (c == ' ') {
      name += '_';
    } else {
      char code[8];
      std::snprintf(code, sizeof code, "-%02X", static_cast<unsigned char>(c));
      name += code;
    }
  }
  return name;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

/// xsd:double always with an exponent: a bare 0.9 would be an xsd:decimal, which a data range of
/// doubles does not hold.
std::string turtle_double(double value) { return number_text(value) + "e0"; }

std::string property_of(const std::vector<RelationTerm>& terms) {
  std::string words;
  for (const auto& term : terms)
    words += (words.empty() ? "" : " and ") + relation_words(term.relation);
  return camel(words);
}

std::string data_range(const Range& range) {
  std::string facets;
  if (range.has_low()) facets += " [ xsd:minInclusive " + turtle_double(range.low) + " ]";
  if (range.has_high()) facets += " [ xsd:maxInclusive " + turtle_double(range.high) + " ]";
  return "[ a rdfs:Datatype ; owl:onDatatype xsd:double ; owl:withRestrictions (" + facets + " ) ]";
}

std::string restriction(const Clause& clause, std::size_t order);

/// The class, or what it has in common with all that is said of the target.
std::string target_expression(const Clause& clause) {
  if (clause.target_clauses.empty()) return ":" + local_name(clause.target);
  std::string all = "[ a owl:Class ; owl:intersectionOf ( :" + local_name(clause.target);
  for (std::size_t i = 0; i < clause.target_clauses.size(); ++i)
    all += " " + restriction(clause.target_clauses[i], i);
  return all + " ) ]";
}

std::string restriction(const Clause& clause, std::size_t order) {
  std::string body = "a owl:Restriction ; ";
  switch (clause.kind) {
    case ClauseKind::feature:
      body += "owl:onProperty sdl:" + feature_word(clause.feature) + " ; owl:someValuesFrom " +
              data_range(clause.range);
      break;
    case ClauseKind::relation:
      body += "owl:onProperty sdl:" + property_of(clause.relations) + " ; owl:someValuesFrom " +
              target_expression(clause);
      break;
    case ClauseKind::negation:
      // "no such target" is a maximum of none.
      body += "owl:onProperty sdl:" + property_of(clause.relations) +
              " ; owl:maxQualifiedCardinality \"0\"^^xsd:nonNegativeInteger ; owl:onClass " +
              target_expression(clause);
      break;
    case ClauseKind::group:
      body += "owl:onProperty sdl:hasMember ; owl:minQualifiedCardinality \"" +
              std::to_string(clause.count_low) +
              "\"^^xsd:nonNegativeInteger ; owl:onClass :" + local_name(clause.target);
      break;
    default: {
      Clause bare = clause;
      bare.usually = false;
      bare.weight = 1.0;
      bare.range = {};
      body += "owl:onProperty sdl:" + camel(clause_text(bare)) + " ; owl:hasValue true";
    }
  }
  return "[ " + body + " ;\n    sdl:words " + quoted(clause_text(clause)) + " ; sdl:order " +
         std::to_string(order) + " ]";
}

}  // namespace

std::string ontology_to_turtle(const Ontology& ontology) {
  const std::string base = "https://scanchor.example/ontology/" + local_name(ontology.name);
  std::string out = "@prefix : <" + base +
                    "#> .\n@prefix sdl: <https://scanchor.example/sdl#> .\n"
                    "@prefix owl: <http://www.w3.org/2002/07/owl#> .\n@prefix rdf: "
                    "<http://www.w3.org/1999/02/22-rdf-syntax-ns#> .\n"
                    "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n@prefix xsd: "
                    "<http://www.w3.org/2001/XMLSchema#> .\n\n<" +
                    base + "> a owl:Ontology .\n\n";
  for (const auto* annotation : {"words", "order", "axiom", "unique", "severalFaces", "partOf"}) {
    out += std::string("sdl:") + annotation + " a owl:AnnotationProperty .\n";
  }
  for (const auto& word : feature_vocabulary()) {
    out += "sdl:" + std::string(word.word) + " a owl:DatatypeProperty ; rdfs:range xsd:double .\n";
  }
  for (const auto* flag :
       {"horizontal", "vertical", "rectangular", "lowest", "highest", "outermost", "largest"}) {
    out += std::string("sdl:") + flag + " a owl:DatatypeProperty ; rdfs:range xsd:boolean .\n";
  }
  out += "sdl:hasMember a owl:ObjectProperty .\n";
  for (const auto& word : relation_vocabulary()) {
    out += "sdl:" + camel(std::string(word.words)) + " a owl:ObjectProperty" +
           (word.symmetric ? " , owl:SymmetricProperty" : "") + " .\n";
  }
  // Conjunctions on one shared target: a property below each of its parts.
  std::set<std::string> declared;
  const std::function<void(const Clause&)> declare = [&](const Clause& clause) {
    for (const auto& nested : clause.target_clauses) declare(nested);
    if (clause.relations.size() < 2 || !declared.insert(property_of(clause.relations)).second)
      return;
    out += "sdl:" + property_of(clause.relations) + " a owl:ObjectProperty";
    for (const auto& term : clause.relations)
      out += " ; rdfs:subPropertyOf sdl:" + camel(relation_words(term.relation));
    out += " .\n";
  };
  for (const auto& description : ontology.classes) {
    for (const auto& clause : description.clauses) declare(clause);
  }
  for (std::size_t c = 0; c < ontology.classes.size(); ++c) {
    const auto& description = ontology.classes[c];
    out += "\n:" + local_name(description.name()) + " a owl:Class";
    for (std::size_t i = 0; i < description.names.size(); ++i) {
      out += std::string(" ;\n  ") +
             (i == 0 ? "rdfs:label " : "<http://www.w3.org/2004/02/skos/core#altLabel> ") +
             quoted(description.names[i]);
    }
    out += " ;\n  sdl:order " + std::to_string(c);
    if (description.axiom) out += " ;\n  sdl:axiom true";
    if (description.unique) out += " ;\n  sdl:unique true";
    if (description.several_faces) out += " ;\n  sdl:severalFaces true";
    if (!description.parent.empty())
      out += " ;\n  rdfs:subClassOf :" + local_name(description.parent);
    if (!description.part_of.empty()) out += " ;\n  sdl:partOf :" + local_name(description.part_of);
    for (std::size_t i = 0; i < description.clauses.size(); ++i) {
      out += " ;\n  rdfs:subClassOf " + restriction(description.clauses[i], i);
    }
    out += " .\n";
  }
  return out;
}

}  // namespace scanchor
