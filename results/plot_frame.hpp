#pragma once
// The frame that all plots share: where data goes, axes with ticks, title, legend.

#include "results/plot.hpp"

namespace scanchor {

struct PlotFrame {
  VectorPicture picture;
  double left, top, right, bottom;  ///< [px] of the area for data
  double x_low, x_high, y_low, y_high;
  bool x_log = false;
  [[nodiscard]] double x(double value) const;
  [[nodiscard]] double y(double value) const;
};

/// Ranges must be set (low < high); `legend_px`: room on the right. Ticks are drawn on the sides
/// asked for.
PlotFrame plot_frame(const PlotOptions& options, double legend_px, bool x_ticks = true,
                     bool y_ticks = true, double bottom_px = 46.0, double left_px = 62.0);

/// Widens an empty or degenerate range; the values' own otherwise, with a little air.
void plot_range(const std::vector<double>& values, double& low, double& high);

/// "0.25", "1000", "1e-06": shortest that says it.
std::string plot_number(double value);

}  // namespace scanchor
