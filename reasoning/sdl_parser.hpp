#pragma once
// The reader's inside: one file of text to classes, imports not yet followed.

#include <string>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// Parses one file: grammar in docs/reference/sdl.md. Names of targets are not yet resolved.
/// Throws Error(bad_data): file:line:column, cause, suggestion, the line and a caret.
Ontology parse_sdl(const std::string& text, const std::string& file);

/// Throws the error of a place in a text, with its line and a caret.
[[noreturn]] void fail_sdl(const std::string& text, const std::string& file, SourcePlace place,
                           const std::string& cause, const std::string& remedy = "");

}  // namespace scanchor
