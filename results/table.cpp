#include "results/table.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace scanchor {
namespace {

constexpr int column_gap = 2;
constexpr int least_text = 8;  // no column is cut below this

bool is_number(const std::string& text) {
  if (text.empty() || text == "-" || text == "–") return true;
  const std::size_t digits = std::size_t(
      std::count_if(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }));
  const char first = text[0] == '+' || text[0] == '-' || text[0] == '<' ? text[1] : text[0];
  return digits > 0 && (first == '.' || (first >= '0' && first <= '9')) &&
         2 * digits + 2 >= text.size();
}

/// The first `width` columns of the text, with an ellipsis if something was cut.
std::string cut(const std::string& text, int width) {
  if (display_width(text) <= width) return text;
  std::string result;
  int used = 0;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t next = i + 1;
    while (next < text.size() && (static_cast<unsigned char>(text[next]) >> 6) == 2) ++next;
    if (++used >= width) break;
    result.append(text, i, next - i);
    i = next;
  }
  return result + "…";
}

std::string padded(const std::string& text, int width, bool right) {
  const std::string blanks(std::size_t(std::max(0, width - display_width(text))), ' ');
  return right ? blanks + text : text + blanks;
}

}  // namespace

int display_width(const std::string& text) {
  // Continuation bytes take no column; the characters we print are all one wide.
  return int(std::count_if(text.begin(), text.end(),
                           [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

Table::Table(std::vector<std::string> header, std::vector<TableAlign> align)
    : header_(std::move(header)), align_(std::move(align)) {
  align_.resize(header_.size(), TableAlign::automatic);
}

void Table::add_row(std::vector<TableCell> cells) {
  assert(cells.size() <= header_.size());
  cells.resize(header_.size());
  rows_.push_back(std::move(cells));
}

void Table::add_rule() { rules_.push_back(rows_.size()); }

std::string Table::to_text(const TableOptions& options) const {
  const std::size_t columns = header_.size();
  std::vector<int> width(columns);
  std::vector<bool> right(columns);
  std::vector<bool> may_cut(columns);
  for (std::size_t c = 0; c < columns; ++c) {
    bool numbers = !rows_.empty();
    width[c] = display_width(header_[c]);
    for (const auto& row : rows_) {
      width[c] = std::max(width[c], display_width(row[c].text));
      numbers = numbers && is_number(row[c].text);
    }
    right[c] = align_[c] == TableAlign::right || (align_[c] == TableAlign::automatic && numbers);
    may_cut[c] = !numbers;
  }
  const auto total = [&] {
    int sum = options.indent + column_gap * int(columns == 0 ? 0 : columns - 1);
    for (const int w : width) sum += w;
    return sum;
  };
  while (total() > options.width) {
    std::size_t widest = columns;
    for (std::size_t c = 0; c < columns; ++c) {
      if (may_cut[c] && width[c] > least_text && (widest == columns || width[c] > width[widest])) {
        widest = c;
      }
    }
    if (widest == columns) break;  // Numbers are never cut.
    --width[widest];
  }
  const std::string indent(std::size_t(options.indent), ' ');
  const auto line = [&](const std::vector<TableCell>& cells) {
    std::string text = indent;
    for (std::size_t c = 0; c < columns; ++c) {
      const std::string cell = padded(cut(cells[c].text, width[c]), width[c], right[c]);
      text +=
          (c > 0 ? std::string(column_gap, ' ') : "") + colored(cell, cells[c].tone, options.color);
    }
    if (!options.color) text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string rule = indent;
  for (int i = 0; i < total() - options.indent; ++i) rule += "─";
  rule = colored(rule, CellTone::faint, options.color) + "\n";
  std::string text = line({header_.begin(), header_.end()}) + rule;
  if (options.color) {
    std::vector<TableCell> strong;
    for (const std::string& name : header_) strong.emplace_back(name, CellTone::strong);
    text = line(strong) + rule;
  }
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (std::find(rules_.begin(), rules_.end(), r) != rules_.end() && r > 0) text += rule;
    text += line(rows_[r]);
  }
  return text;
}

std::string Table::to_markdown() const {
  const auto line = [&](const auto& cells, const auto& text_of) {
    std::string text = "|";
    for (const auto& cell : cells) {
      std::string words = text_of(cell);
      for (std::size_t at = 0; (at = words.find('|', at)) != std::string::npos; at += 2) {
        words.insert(at, "\\");
      }
      text += " " + words + " |";
    }
    return text + "\n";
  };
  std::string text = line(header_, [](const std::string& s) { return s; }) + "|";
  for (std::size_t c = 0; c < header_.size(); ++c) {
    const bool numbers =
        !rows_.empty() && std::all_of(rows_.begin(), rows_.end(),
                                      [&](const auto& row) { return is_number(row[c].text); });
    text += align_[c] == TableAlign::right || (align_[c] == TableAlign::automatic && numbers)
                ? "---:|"
                : "---|";
  }
  text += "\n";
  for (const auto& row : rows_) text += line(row, [](const TableCell& cell) { return cell.text; });
  return text;
}

bool wants_color(std::FILE* stream) {
  const char* no_color = std::getenv("NO_COLOR");
  if (no_color != nullptr && *no_color != '\0') return false;
  const char* term = std::getenv("TERM");
  if (term == nullptr || std::strcmp(term, "dumb") == 0) return false;
  return isatty(fileno(stream)) == 1;
}

int terminal_width(std::FILE* stream) {
  winsize size{};
  if (isatty(fileno(stream)) == 1 && ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 &&
      size.ws_col > 0) {
    return std::clamp(int(size.ws_col), 40, 120);
  }
  return 80;
}

std::string colored(const std::string& text, CellTone tone, bool color) {
  if (!color || tone == CellTone::plain) return text;
  const char* code = "";
  switch (tone) {
    case CellTone::good:
      code = "32";
      break;
    case CellTone::fair:
      code = "33";
      break;
    case CellTone::bad:
      code = "31";
      break;
    case CellTone::faint:
      code = "2";
      break;
    case CellTone::strong:
      code = "1";
      break;
    case CellTone::plain:
      break;
  }
  return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

std::string fraction_text(double value, int digits) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

CellTone tone_of(double value, double good, double fair) {
  if (std::isnan(value)) return CellTone::faint;
  return value >= good ? CellTone::good : value >= fair ? CellTone::fair : CellTone::bad;
}

}  // namespace scanchor
