#pragma once
// One way to write a class file: `scanchor ontology format`.

#include <string>

#include "reasoning/ontology.hpp"

namespace scanchor {

/// The text in its standard form: four blanks of indentation, one blank line between classes,
/// canonical words and units as written. All comments are kept. Idempotent: format(format(x)) ==
/// format(x), and the meaning is the same. Throws Error(bad_data) like the reader.
std::string format_sdl(const std::string& text, const std::string& file);

/// The same from the tree, imported classes as its own.
std::string ontology_to_sdl(const Ontology& ontology);

}  // namespace scanchor
