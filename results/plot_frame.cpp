#include "results/plot_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace scanchor {
namespace {

constexpr double tick_size = 11.5;

std::vector<double> log_ticks(double low, double high) {
  std::vector<double> ticks;
  for (int power = int(std::floor(std::log10(low))); power <= int(std::ceil(std::log10(high)));
       ++power) {
    for (const double step : {1.0, 2.0, 5.0}) {
      const double tick = step * std::pow(10.0, power);
      if (tick >= low * 0.999 && tick <= high * 1.001) ticks.push_back(tick);
    }
  }
  return ticks;
}

}  // namespace

std::vector<double> plot_ticks(double low, double high, int count) {
  std::vector<double> ticks;
  if (!(high > low) || count < 1) return ticks;
  const double rough = (high - low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * 0.999) {
      step = factor * power;
      break;
    }
  }
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0) {
    ticks.push_back(k * step);
  }
  return ticks;
}

std::string plot_number(double value) {
  if (std::abs(value) < 1e-12) return "0";
  return fmt::format("{:.4g}", value);
}

void plot_range(const std::vector<double>& values, double& low, double& high) {
  low = 1e300;
  high = -1e300;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  if (low > high) {
    low = 0.0;
    high = 1.0;
  }
  if (!(high > low)) {
    const double half = std::max(0.5, 0.1 * std::abs(low));
    low -= half;
    high += half;
  }
}

double PlotFrame::x(double value) const {
  const double t = x_log ? std::log(value / x_low) / std::log(x_high / x_low)
                         : (value - x_low) / (x_high - x_low);
  return left + t * (right - left);
}

double PlotFrame::y(double value) const {
  return bottom - (value - y_low) / (y_high - y_low) * (bottom - top);
}

PlotFrame plot_frame(const PlotOptions& options, double legend_px, bool x_ticks, bool y_ticks,
                     double bottom_px, double left_px) {
  if (options.x_log && !(options.x_low > 0.0)) {
    fail_data("", options.title, "a logarithmic axis cannot begin at 0 or below");
  }
  PlotFrame frame;
  frame.picture.width = options.width;
  frame.picture.height = options.height;
  frame.left = left_px;
  frame.right = options.width - 18.0 - legend_px;
  frame.top = options.title.empty() ? 16.0 : 40.0;
  frame.bottom = options.height - bottom_px;
  frame.x_low = options.x_low;
  frame.x_high = options.x_high;
  frame.y_low = options.y_low;
  frame.y_high = options.y_high;
  frame.x_log = options.x_log;
  VectorPicture& p = frame.picture;
  if (!options.title.empty()) {
    p.text(14.0, 24.0, fit_text(options.title, options.width - 28.0, 15.0, FontWeight::bold), 15.0,
           ink, TextAnchor::start, FontWeight::bold);
  }
  if (x_ticks) {
    const int count = std::max(2, int((frame.right - frame.left) / 70.0));
    for (const double tick : options.x_log ? log_ticks(frame.x_low, frame.x_high)
                                           : plot_ticks(frame.x_low, frame.x_high, count)) {
      const double at = frame.x(tick);
      p.line({at, frame.top}, {at, frame.bottom}, grid_line);
      p.text(at, frame.bottom + 17.0, plot_number(tick), tick_size, ink, TextAnchor::middle);
    }
  }
  if (y_ticks) {
    const int count = std::max(2, int((frame.bottom - frame.top) / 48.0));
    for (const double tick : plot_ticks(frame.y_low, frame.y_high, count)) {
      const double at = frame.y(tick);
      p.line({frame.left, at}, {frame.right, at}, grid_line);
      p.text(frame.left - 8.0, at + 4.0, plot_number(tick), tick_size, ink, TextAnchor::end);
    }
  }
  p.stroke_rectangle(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top,
                     faint_ink);
  if (!options.x_label.empty()) {
    p.text((frame.left + frame.right) / 2, options.height - 10.0, options.x_label, 12.5, ink,
           TextAnchor::middle);
  }
  if (!options.y_label.empty()) {
    VectorText label{{17.0, (frame.top + frame.bottom) / 2},
                     options.y_label,
                     12.5,
                     ink,
                     TextAnchor::middle,
                     FontWeight::regular,
                     90.0};
    p.items.emplace_back(std::move(label));
  }
  return frame;
}

}  // namespace scanchor
