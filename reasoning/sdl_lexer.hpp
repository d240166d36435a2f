#pragma once
// Lines of a class file as tokens. The language goes line by line: a clause is a line, indentation
// says what belongs to what.

#include <string>
#include <string_view>
#include <vector>

namespace scanchor {

/// A word may hold letters, digits, underscores, hyphens, slashes, apostrophes and all of UTF-8
/// beyond ASCII.
struct Token {
  enum class Kind { word, number, dots, comma, colon, other, end };
  Kind kind = Kind::end;
  std::string text;
  double value = 0.0;
  int column = 1;
};

/// One line; `tokens` ends with an `end` token.
struct Line {
  std::vector<Token> tokens;
  int number = 0;       ///< from 1
  int indent = 0;       ///< blanks in front; a tab counts four
  std::string comment;  ///< behind '#'
  bool has_comment = false;
};

Line scan_line(std::string_view line, int number);

/// Words separated by single blanks.
std::vector<std::string> split_words(std::string_view words);

}  // namespace scanchor
