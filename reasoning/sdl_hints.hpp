#pragma once
// What somebody may have meant who writes the language as he would speak.

#include <string>
#include <vector>

#include "reasoning/sdl_cursor.hpp"

namespace scanchor {

/// Where a clause was to begin: "write 'near a desk'" for "next to a desk". Empty: no idea.
std::string clause_hint(const SdlCursor& cursor);

/// Behind a "no" or "not" that no relation follows: "write 'not above a chair'" for "no chair
/// above".
std::string denial_hint(const SdlCursor& cursor);

/// Where "a", "an" or "the" is missing in front of a target: "write 'a desk'".
std::string target_hint(const SdlCursor& cursor);

/// Inside of a range of the feature or relation `what`: "> 0.4 m", "0.4 to 0.5 m", "0.4m..0.5m".
std::string range_hint(const SdlCursor& cursor, const std::string& what);

/// Behind the end of a clause: "horizontal, rectangular".
std::string end_hint(const SdlCursor& cursor);

/// In a question, where a thing or what is said of it was to begin: "a chair by the desk".
std::string question_hint(const SdlCursor& cursor);

}  // namespace scanchor
