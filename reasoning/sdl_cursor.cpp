#include "reasoning/sdl_cursor.hpp"

#include <algorithm>

#include "reasoning/sdl_hints.hpp"
#include "reasoning/sdl_parser.hpp"

namespace scanchor {

void SdlCursor::start(Line line) {
  line_ = std::move(line);
  next_ = 0;
}

const Token& SdlCursor::peek(std::size_t ahead) const {
  return line_.tokens[std::min(next_ + ahead, line_.tokens.size() - 1)];
}

Token SdlCursor::take() {
  Token token = peek();
  if (next_ + 1 < line_.tokens.size()) ++next_;
  return token;
}

bool SdlCursor::at_word(std::string_view word, std::size_t ahead) const {
  return peek(ahead).kind == Token::Kind::word && peek(ahead).text == word;
}

bool SdlCursor::at_words(std::string_view words) const {
  const auto parts = split_words(words);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!at_word(parts[i], i)) return false;
  }
  return !parts.empty();
}

bool SdlCursor::accept(std::string_view word) {
  if (!at_word(word)) return false;
  take();
  return true;
}

bool SdlCursor::accept_words(std::string_view words) {
  if (!at_words(words)) return false;
  for (std::size_t i = split_words(words).size(); i > 0; --i) take();
  return true;
}

bool SdlCursor::accept_sign(std::string_view sign) {
  if (peek().kind != Token::Kind::other || peek().text != sign) return false;
  take();
  return true;
}

void SdlCursor::fail(const Token& token, const std::string& cause,
                     const std::string& remedy) const {
  fail_sdl(text_, file_, place(token), cause, remedy);
}

void SdlCursor::expect_end() const {
  if (!at_end())
    fail(peek(), "nothing more was expected here, found '" + peek().text + "'", end_hint(*this));
}

std::string SdlCursor::rest() const {
  std::string words;
  for (std::size_t i = 0; peek(i).kind != Token::Kind::end; ++i)
    words += (i == 0 ? "" : " ") + peek(i).text;
  return words;
}

}  // namespace scanchor
