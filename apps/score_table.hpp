#pragma once
// A score as a person reads it.

#include "apps/command.hpp"
#include "eval/objects.hpp"
#include "eval/protocol.hpp"
#include "eval/score.hpp"

namespace scanchor::apps {

/// Class by class: there, found, missed, wrong, precision, recall; then what does not count.
void print_objects(const Common& common, const ObjectScore& score);

/// The headline numbers, the class table, and the scans without an answer.
void print_score(const Common& common, const Score& score, const Protocol& protocol);

}  // namespace scanchor::apps
