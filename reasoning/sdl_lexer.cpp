#include "reasoning/sdl_lexer.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "core/error.hpp"
#include "reasoning/sdl_parser.hpp"

namespace scanchor {

void fail_sdl(const std::string& text, const std::string& file, SourcePlace place,
              const std::string& cause, const std::string& remedy) {
  std::size_t begin = 0;
  for (int line = 1; line < place.line && begin < text.size(); ++line) {
    const std::size_t end = text.find('\n', begin);
    begin = end == std::string::npos ? text.size() : end + 1;
  }
  std::string line = text.substr(begin, text.find('\n', begin) - begin);
  while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
  std::replace(line.begin(), line.end(), '\t', ' ');
  std::string message =
      file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " + cause;
  if (!remedy.empty()) message += "; " + remedy;
  message += "\n  " + line + "\n  " + std::string(std::max(0, place.column - 1), ' ') + "^";
  throw Error(ExitCode::bad_data, message);
}

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '/' ||
         c == '\'' || static_cast<unsigned char>(c) >= 0x80;
}

Token scan_number(std::string_view line, std::size_t& i) {
  Token token;
  token.kind = Token::Kind::number;
  const std::size_t begin = i;
  while (i < line.size() && is_digit(line[i])) ++i;
  if (i + 1 < line.size() && line[i] == '.' && is_digit(line[i + 1])) {
    ++i;
    while (i < line.size() && is_digit(line[i])) ++i;
  }
  token.text = std::string(line.substr(begin, i - begin));
  token.value = std::strtod(token.text.c_str(), nullptr);
  return token;
}

}  // namespace

Line scan_line(std::string_view line, int number) {
  Line result;
  result.number = number;
  std::size_t i = 0;
  while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) {
    result.indent += line[i] == '\t' ? 4 : 1;
    ++i;
  }
  while (i < line.size()) {
    const char c = line[i];
    if (c == ' ' || c == '\t' || c == '\r') {
      ++i;
      continue;
    }
    if (c == '#') {
      std::string comment(line.substr(i + 1));
      while (!comment.empty() && std::isspace(static_cast<unsigned char>(comment.back())) != 0)
        comment.pop_back();
      if (!comment.empty() && comment.front() == ' ') comment.erase(0, 1);
      result.comment = comment;
      result.has_comment = true;
      break;
    }
    Token token;
    const int column = static_cast<int>(i) + 1;
    if (is_digit(c)) {
      token = scan_number(line, i);
    } else if (line.substr(i, 2) == "..") {
      token.kind = Token::Kind::dots;
      token.text = "..";
      i += 2;
    } else if (is_word(c)) {
      const std::size_t begin = i;
      while (i < line.size() && is_word(line[i])) ++i;
      token.kind = Token::Kind::word;
      token.text = std::string(line.substr(begin, i - begin));
    } else {
      token.kind = c == ','   ? Token::Kind::comma
                   : c == ':' ? Token::Kind::colon
                              : Token::Kind::other;
      token.text = std::string(1, c);
      ++i;
    }
    token.column = column;
    result.tokens.push_back(std::move(token));
  }
  Token end;
  end.column = result.tokens.empty() ? static_cast<int>(line.size()) + 1
                                     : result.tokens.back().column +
                                           static_cast<int>(result.tokens.back().text.size());
  result.tokens.push_back(end);
  return result;
}

std::vector<std::string> split_words(std::string_view words) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < words.size();) {
    const std::size_t end = std::min(words.find(' ', i), words.size());
    result.emplace_back(words.substr(i, end - i));
    i = end + 1;
  }
  return result;
}

}  // namespace scanchor
