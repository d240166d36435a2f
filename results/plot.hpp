#pragma once
// Plots for files: lines with intervals, maps, reliability diagrams, confusion matrices, bars. Each
// gives a VectorPicture, so the same plot goes to SVG (write_svg) and to pixels (to_image). The
// report draws its own, which answer to the mouse.

#include <string>
#include <vector>

#include "results/vector.hpp"

namespace scanchor {

struct PlotOptions {
  int width = 640;
  int height = 400;
  std::string title;
  std::string x_label;  ///< with its unit: "range noise [mm]"
  std::string y_label;
  double x_low = 0.0, x_high = 0.0;  ///< low == high: from the data
  double y_low = 0.0, y_high = 0.0;
  bool x_log = false;
};

/// A curve; `low` and `high` (empty or as long as `y`) bound its interval. NaN leaves a gap.
struct PlotLine {
  std::string name;
  std::vector<double> x, y;
  std::vector<double> low, high;
  bool points = true;
  bool dashed = false;
};

/// Curves in the palette's colours with a legend. Throws Error(bad_data) where columns differ in
/// length.
VectorPicture plot_lines(const std::vector<PlotLine>& lines, const PlotOptions& options);

/// A function of two parameters as coloured cells: values[row][column], row 0 at the bottom.
struct PlotMap {
  std::vector<double> x, y;                 ///< of columns and rows
  std::vector<std::vector<double>> values;  ///< NaN: no cell
  std::string value_label;
  double low = 0.0, high = 0.0;  ///< of the colours; equal: from the data
};
VectorPicture plot_map(const PlotMap& map, const PlotOptions& options);

/// Bars, each a stack of parts. names[i] stands under bar i.
struct PlotStack {
  std::string name;
  std::vector<double> values;  ///< one a bar
};
VectorPicture plot_bars(const std::vector<std::string>& names, const std::vector<PlotStack>& stacks,
                        const PlotOptions& options);

/// Stated probability against the share that was right, with the ideal diagonal and the count of
/// each bin.
struct ReliabilityPoint {
  double stated, right, low, high;
  double count;
};
VectorPicture plot_reliability(const std::vector<ReliabilityPoint>& points, PlotOptions options);

/// Shares of each row; counts[truth][said].
VectorPicture plot_confusion(const std::vector<std::string>& names,
                             const std::vector<std::vector<double>>& counts, PlotOptions options);

/// Round numbers that cover [low, high] with about `count` steps, all inside.
std::vector<double> plot_ticks(double low, double high, int count);

}  // namespace scanchor
