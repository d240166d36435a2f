#pragma once
// Small things about words: the "did you mean" of every error message.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scanchor {

/// Damerau-Levenshtein distance (insert, delete, replace, swap of neighbours).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, if it is near enough to be a slip of the hand (at most one edit
/// in three letters).
std::optional<std::string> nearest_word(std::string_view word,
                                        const std::vector<std::string>& candidates);

/// "did you mean 'X'?" or, where nothing is near, "known are: A, B, C".
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// The shortest text that is read back as the same number.
std::string shortest_text(double value);

}  // namespace scanchor
