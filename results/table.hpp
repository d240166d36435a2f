#pragma once
// Tables for a terminal: they fit 80 columns, numbers stand under each other, colour only where it
// is wanted.

#include <cstdio>
#include <string>
#include <vector>

namespace scanchor {

enum class TableAlign {
  automatic,
  left,
  right
};  ///< automatic: right if all cells of the column are numbers

/// What a cell's number means, for its colour.
enum class CellTone { plain, good, fair, bad, faint, strong };

struct TableCell {
  std::string text;
  CellTone tone = CellTone::plain;
  TableCell(std::string words = "", CellTone how = CellTone::plain)  // NOLINT: a string is a cell
      : text(std::move(words)), tone(how) {}
  TableCell(const char* words) : text(words) {}  // NOLINT: so is a literal
};

struct TableOptions {
  int width = 80;  ///< columns; the widest text column is cut with an ellipsis until the table fits
  bool color = false;  ///< ANSI colours; see wants_color()
  int indent = 0;
};

class Table {
 public:
  explicit Table(std::vector<std::string> header, std::vector<TableAlign> align = {});
  /// Missing cells at the end are empty; more cells than the header has are an error of the caller
  /// (assert).
  void add_row(std::vector<TableCell> cells);
  /// A thin line before the next row.
  void add_rule();
  [[nodiscard]] std::size_t rows() const { return rows_.size(); }
  /// Lines that end with a newline each.
  [[nodiscard]] std::string to_text(const TableOptions& options = {}) const;
  /// The same as GitHub-flavoured Markdown.
  [[nodiscard]] std::string to_markdown() const;

 private:
  std::vector<std::string> header_;
  std::vector<TableAlign> align_;
  std::vector<std::vector<TableCell>> rows_;
  std::vector<std::size_t> rules_;  // before which rows
};

/// Whether the stream is a terminal that shows colours: not with NO_COLOR set
/// (https://no-color.org), TERM=dumb, or a pipe.
bool wants_color(std::FILE* stream);
/// Columns of the terminal behind the stream, at most 120; 80 where it is none.
int terminal_width(std::FILE* stream);
/// The words in the tone's colour, if colour is wanted.
std::string colored(const std::string& text, CellTone tone, bool color);
/// Columns that UTF-8 text takes.
int display_width(const std::string& text);

/// A fraction as a table shows it, "0.873"; "-" for NaN.
std::string fraction_text(double value, int digits = 3);
/// Good from `good`, fair from `fair`, else bad.
CellTone tone_of(double value, double good, double fair);

}  // namespace scanchor
