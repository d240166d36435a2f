#pragma once
// Lines and tokens of a text in memory, without copies.

#include <cstddef>
#include <string>
#include <string_view>

namespace scanchor {

/// Takes the next token off the front of `rest`. Blanks, tabs, carriage returns, and `extra` (0:
/// none) stand between tokens. Empty: there is none left.
std::string_view next_token(std::string_view& rest, char extra = '\0', char extra2 = '\0');

/// Goes through a text line by line and counts them.
class LineReader {
 public:
  /// `first_line`: the number of the text's first line in its file.
  explicit LineReader(std::string_view text, std::size_t first_line = 1)
      : rest_(text), line_(first_line - 1) {}
  /// The next line without its end ("\n" or "\r\n"); false at the end of the text.
  bool next(std::string_view& line);
  /// Number of the line that `next` gave last, from 1.
  [[nodiscard]] std::size_t number() const { return line_; }
  /// What follows that line.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t line_;
};

/// Where in a file a fault lies.
std::string line_place(std::size_t line);

}  // namespace scanchor
