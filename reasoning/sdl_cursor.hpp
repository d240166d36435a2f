#pragma once
// Walks along the tokens of one line: what the readers of class files and of questions share.

#include <string>
#include <string_view>
#include <vector>

#include "reasoning/ontology.hpp"
#include "reasoning/sdl_lexer.hpp"

namespace scanchor {

/// `text` and `file` are what errors quote; both must outlive the cursor.
class SdlCursor {
 public:
  SdlCursor(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  void start(Line line);
  [[nodiscard]] const Line& line() const { return line_; }

  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
  Token take();
  [[nodiscard]] bool at_end() const { return peek().kind == Token::Kind::end; }
  [[nodiscard]] bool at_word(std::string_view word, std::size_t ahead = 0) const;
  /// Several words, separated by single blanks.
  [[nodiscard]] bool at_words(std::string_view words) const;
  bool accept(std::string_view word);
  bool accept_words(std::string_view words);
  /// A sign such as "(".
  bool accept_sign(std::string_view sign);

  [[nodiscard]] SourcePlace place(const Token& token) const { return {line_.number, token.column}; }
  /// Throws Error(bad_data) with file, line, column and a caret below the token.
  [[noreturn]] void fail(const Token& token, const std::string& cause,
                         const std::string& remedy = "") const;
  void expect_end() const;
  /// All that is left of the line, words separated by blanks.
  [[nodiscard]] std::string rest() const;

 protected:
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  const std::string& text_;
  const std::string& file_;
  Line line_;
  std::size_t next_ = 0;
};

}  // namespace scanchor
