#pragma once
// How often a clause holds for things of its class and for anything else: counted on training
// scenes, kept beside the class file.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// `<ontology>.background.json`: documented in docs/reference/sdl.md.
struct ClauseRates {
  std::string class_name;
  std::string clause;       ///< clause_text
  double hit_rate = 0.0;    ///< (0, 1) mean value of the clause over entities of the class
  double background = 0.0;  ///< (0, 1) mean value over all others
  double weight = 1.0;      ///< [0, ...) factor of the clause's own weight
};

struct Background {
  std::string fitted_on;       ///< what was counted, in words: suite, seeds, number of surfaces
  double unknown_prior = 0.5;  ///< (0, 1] share of surfaces of no described class
  double temperature = 1.0;    ///< exponent of the likelihood ratios
  std::vector<std::pair<std::string, double>> priors;  ///< class, share of surfaces
  std::vector<ClauseRates> rates;
};

/// Puts the rates into the clauses with the same words; others keep their defaults.
void apply_background(Ontology& ontology, const Background& background);

/// Classes that were not counted beside classes that were, as a user's are who imports a shipped
/// file: a clause without rates gets the background of counted clauses with the same words, and the
/// mean hit rate and weight of counted clauses of its kind; a class without a prior gets the
/// geometric mean of those counted. With the plain defaults, made for files in which nothing is
/// counted, such a class wins or loses by its weights of 1 alone. Nothing counted: nothing changes.
void fill_uncounted(Ontology& ontology);

/// The documented defaults: what is assumed of a clause as long as nothing was counted.
double default_hit_rate(const Clause& clause);
double default_background(const Clause& clause);
double hit_rate_of(const Clause& clause);
double background_of(const Clause& clause);
/// Exponent of the clause's likelihood ratio: what the author wrote times what was counted.
inline double weight_of(const Clause& clause) { return clause.weight * clause.counted_weight; }
/// P(class) of a random surface, and of none of the classes.
double prior_of(const Ontology& ontology, int class_index);
double unknown_prior_of(const Ontology& ontology);

nlohmann::ordered_json background_to_json(const Background& background);
Background background_from_json(const nlohmann::ordered_json& json, const std::string& file);
Background read_background(const std::filesystem::path& path);
void write_background(const std::filesystem::path& path, const Background& background);

}  // namespace scanchor
