#pragma once
// The vocabulary of the language in one table, shared by reader, formatter and the OWL carrier.

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// Descriptions that lie in each other; nobody means more.
inline constexpr int deepest_description = 32;

struct RelationWords {
  Relation relation;
  std::string_view words;  ///< as printed: "parallel to"
  std::string_view
      pair_words;  ///< between two members of a group: "parallel"; empty: not for pairs
  bool symmetric;
};
const std::vector<RelationWords>& relation_vocabulary();

struct FeatureWord {
  Feature feature;
  std::string_view word;
  int dimension;  ///< power of metres of its unit: area 2, lengths 1, pure numbers 0
};
const std::vector<FeatureWord>& feature_vocabulary();

struct ExtremumWord {
  Extremum extremum;
  std::string_view word;
};
const std::vector<ExtremumWord>& extremum_vocabulary();

struct UnitWord {
  std::string_view word;
  double scale;   ///< SI units (degrees for angles) in one of it
  int dimension;  ///< 1 length, 2 area, 0 pure number, -1 angle
};
const std::vector<UnitWord>& unit_vocabulary();
/// The unit, or nullptr.
const UnitWord* find_unit(std::string_view word);

/// Shortest text of a number, at most ten digits: "0.9", "15".
std::string number_text(double value);

/// "boxes", "shelves"; Ontology::find knows the class by it.
std::string plural(const std::string& noun);

/// "a box", "an oven".
std::string with_article(const std::string& noun);

/// A relation of a pair in a group: "parallel", "within 2 m".
std::string pair_text(const RelationTerm& term);

}  // namespace scanchor
