#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reasoning/owl.hpp"
#include "reasoning/sdl_format.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

#if __has_include(<serd/serd.h>)

/// What the carrier keeps: everything but comments.
std::string bare(Ontology ontology) {
  ontology.imports.clear();
  ontology.closing_comments.clear();
  for (auto& description : ontology.classes) {
    description.comments.clear();
    description.comment.clear();
    for (auto& clause : description.clauses) {
      clause.comment.clear();
      clause.comments.clear();
      clause.pair_comments.clear();
    }
  }
  return ontology_to_sdl(ontology);
}

TEST(OwlRead, RoundTripIsEqual) {
  for (const std::string name : {"paper", "office", "home", "storage"}) {
    const auto ontology = test::shipped(name);
    EXPECT_EQ(bare(ontology_from_turtle(ontology_to_turtle(ontology), name + ".ttl")),
              bare(ontology));
  }
}

const char* const nested = R"(
class window:
    vertical
class table:
    horizontal
class box:
    on and near a table that is near a window (that is rectangular) and has area over 1 m2
    not below a window that is above a table
)";

TEST(OwlRead, RoundTripOfWhatIsSaidOfTargets) {
  const auto ontology = parse_ontology(nested, "x.sdl");
  const std::string turtle = ontology_to_turtle(ontology);
  EXPECT_NE(turtle.find("owl:intersectionOf ( :table [ a owl:Restriction"), std::string::npos);
  EXPECT_EQ(bare(ontology_from_turtle(turtle, "x.ttl")), bare(ontology));
}

TEST(OwlRead, IntersectionsWithoutOurAnnotationsAreUnderstood) {
  // The same file as a tool would hand it back that drops annotations it does not know.
  std::string turtle = ontology_to_turtle(parse_ontology(R"(
class window:
    vertical
class table:
    horizontal
class box:
    on a table that is near a window that is rectangular
)",
                                                         "x.sdl"));
  for (auto at = turtle.find(";\n    sdl:words"); at != std::string::npos;
       at = turtle.find(";\n    sdl:words")) {
    turtle.erase(at, turtle.find(" ]", at) - at);
  }
  ASSERT_EQ(turtle.find("sdl:words \""), std::string::npos);
  const auto back = ontology_from_turtle(turtle, "x.ttl");
  EXPECT_EQ(clause_text(back.classes[2].clauses[0]),
            "on a table that is near a window that is rectangular");
}

TEST(OwlRead, ReadsWhatOtherToolsWrite) {
  const auto ontology = ontology_from_turtle(R"(
@prefix : <http://example.org/own#> .
@prefix sdl: <https://scanchor.example/sdl#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
:ground a owl:Class ; rdfs:subClassOf [ a owl:Restriction ; owl:onProperty sdl:lowest ; owl:hasValue true ] .
:tea_table a owl:Class ;
  rdfs:subClassOf owl:Thing ,
    [ a owl:Restriction ; owl:onProperty sdl:area ; owl:someValuesFrom [ a rdfs:Datatype ; owl:onDatatype xsd:double ;
        owl:withRestrictions ( [ xsd:minInclusive "0.5"^^xsd:double ] [ xsd:maxInclusive 1.5e0 ] ) ] ] ,
    [ a owl:Restriction ; owl:onProperty sdl:parallelTo ; owl:someValuesFrom :ground ] .
)",
                                             "own.ttl");
  ASSERT_EQ(ontology.classes.size(), 2U);
  EXPECT_EQ(ontology.classes[1].name(), "tea table");
  ASSERT_EQ(ontology.classes[1].clauses.size(), 2U);
  EXPECT_EQ(clause_text(ontology.classes[1].clauses[0]), "area 0.5..1.5 m2");
  EXPECT_EQ(clause_text(ontology.classes[1].clauses[1]), "parallel to a ground");
}

TEST(OwlRead, RefusesWhatIsNoTurtle) {
  EXPECT_THROW(ontology_from_turtle("class desk:\n    lowest\n", "x.ttl"), Error);
  EXPECT_THROW(ontology_from_turtle("", "x.ttl"), Error);
}

TEST(OwlRead, RefusesCirclesAndDeepBrackets) {
  const std::string prefixes = R"(
@prefix : <http://example.org/own#> .
@prefix sdl: <https://scanchor.example/sdl#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
)";
  const auto error_of = [&](const std::string& text) -> std::string {
    try {
      ontology_from_turtle(prefixes + text, "x.ttl");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(error_of(R"(
:desk a owl:Class ; rdfs:subClassOf _:near .
_:near a owl:Restriction ; owl:onProperty sdl:near ; owl:someValuesFrom _:both .
_:both a owl:Class ; owl:intersectionOf _:first .
_:first rdf:first :desk ; rdf:rest _:second .
_:second rdf:first _:near ; rdf:rest rdf:nil .
)")
                .find("lies in itself"),
            std::string::npos);
  for (const char bracket : {'(', '['}) {
    EXPECT_NE(error_of(":desk owl:x " + std::string(100000, bracket)).find("brackets lie more"),
              std::string::npos);
  }
  EXPECT_EQ(error_of(":desk a owl:Class ; rdfs:comment \"" + std::string(1000, '(') +
                     "\" ; rdfs:subClassOf [ owl:onProperty sdl:lowest ; owl:hasValue true ] ."),
            "");
}

#else

TEST(OwlRead, SaysThatItIsNotBuiltIn) { EXPECT_THROW(ontology_from_turtle("", "x.ttl"), Error); }

#endif

}  // namespace
}  // namespace scanchor
