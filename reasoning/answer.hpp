#pragma once
// What a question gets: the things, how sure, on what they stand, and why; or what came closest.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/query.hpp"
#include "reasoning/scene_things.hpp"

namespace scanchor {

/// One step of the reason: a clause of the question, or that something is of its class.
struct AnswerStep {
  std::string text;  ///< "on a desk", "second highest"
  double likelihood = 0.0;
  double measured = 0.0;
  double sigma = 0.0;
  std::string unit;              ///< "" where nothing was measured
  bool unseen = false;           ///< not seen: cannot tell
  std::optional<double> needed;  ///< where it fails: the value from which on it would hold
  std::vector<std::int32_t> targets;
  std::vector<AnswerStep> because;  ///< why the first target is what the clause says of it
};

struct AnswerThing {
  std::int32_t id = 0;
  std::string label;         ///< class in the labelling
  double of_class = 0.0;     ///< P(it is of the class that was asked for)
  double probability = 0.0;  ///< that the whole description holds
  std::vector<AnswerStep> steps;
  std::vector<std::int32_t> anchors;  ///< targets of its relations: what a robot goes by
};

struct Answer {
  enum class Status { ok, ambiguous, not_found, not_seen };
  Query query;
  Status status = Status::not_found;
  std::vector<AnswerThing>
      things;  ///< all that hold; the likeliest first, or in the order asked for
  std::optional<AnswerThing> closest;  ///< not_found, not_seen: what came nearest
  std::string failing;  ///< of `closest`: the clause that fails, in the words of the language
  std::string ask;      ///< ambiguous: what would tell the first two apart
  // how many
  int count = 0;                     ///< things that hold
  double expected = 0.0;             ///< sum of the probabilities
  std::vector<double> distribution;  ///< P(there are 0, 1, 2, ...)
  // is there
  double exists = 0.0;  ///< P(at least one), noisy-or
  // distance
  std::optional<Evidence> distance;  ///< [m] of the first to the second thing
};

/// Throws Error(wrong_usage) where the question needs to know where the robot stood.
Answer answer(const Query& query, const SceneThings& scene);

std::string status_word(Answer::Status status);
/// A few lines for a person, in the words of the language.
std::string answer_text(const Answer& answer, const SceneThings& scene);
/// docs/reference/queries.md
nlohmann::ordered_json answer_to_json(const Answer& answer, const SceneThings& scene);

}  // namespace scanchor
