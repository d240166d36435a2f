#include "cloud/text_lines.hpp"

namespace scanchor {

std::string_view next_token(std::string_view& rest, char extra, char extra2) {
  const auto between = [=](char c) {
    return c == ' ' || c == '\t' || c == '\r' || (extra != '\0' && c == extra) ||
           (extra2 != '\0' && c == extra2);
  };
  std::size_t begin = 0;
  while (begin < rest.size() && between(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !between(rest[end])) ++end;
  const std::string_view token = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return token;
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  ++line_;
  return true;
}

std::string line_place(std::size_t line) { return "line " + std::to_string(line); }

}  // namespace scanchor
