#include "reasoning/owl.hpp"

#include <gtest/gtest.h>

#include "reasoning/sdl_format.hpp"
#include "tests/reasoning/support/built.hpp"

namespace scanchor {
namespace {

TEST(Owl, SaysAClauseInOwl) {
  const auto turtle = ontology_to_turtle(test::shipped("paper"));
  for (const auto* part : {":desk a owl:Class", "rdfs:label \"desk\"", "owl:onProperty sdl:area",
                           "[ xsd:minInclusive 0.9e0 ] [ xsd:maxInclusive 1.7e0 ]",
                           "sdl:orthogonalToAndAbove a owl:ObjectProperty ; rdfs:subPropertyOf "
                           "sdl:orthogonalTo ; rdfs:subPropertyOf sdl:above",
                           "owl:onProperty sdl:orthogonalToAndAbove ; owl:someValuesFrom :desk",
                           "owl:minQualifiedCardinality \"2\"",
                           "sdl:words \"at least 2 boards, each pair parallel and same size and "
                           "vertically aligned\""}) {
    EXPECT_NE(turtle.find(part), std::string::npos) << part << "\n" << turtle;
  }
}

}  // namespace
}  // namespace scanchor
