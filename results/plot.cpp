#include "results/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "results/plot_frame.hpp"

namespace scanchor {
namespace {

constexpr double plot_legend_size = 12.0;

// Three digits: what stands beside a cell need not be exact.
std::string map_number(double value) { return fmt::format("{:.3g}", value); }

double widest(const std::vector<std::string>& names) {
  double width = 0.0;
  for (const std::string& name : names) width = std::max(width, text_width(name, plot_legend_size));
  return width;
}

void legend(PlotFrame& frame, const std::vector<std::string>& names, bool squares) {
  double y = frame.top + 12.0;
  for (std::size_t i = 0; i < names.size(); ++i, y += 19.0) {
    const double x = frame.right + 14.0;
    if (squares) {
      frame.picture.fill_rectangle(x, y - 10.0, 13.0, 13.0, palette(i), 2.0);
    } else {
      frame.picture.line({x, y - 4.0}, {x + 16.0, y - 4.0}, palette(i), 2.5);
    }
    frame.picture.text(x + 22.0, y, names[i], plot_legend_size);
  }
}

void check(const PlotLine& line) {
  const std::size_t n = line.x.size();
  if (line.y.size() != n || (!line.low.empty() && line.low.size() != n) ||
      line.low.size() != line.high.size()) {
    fail_data("", "curve '" + line.name + "'", "its columns have different lengths");
  }
}

void set_ranges(const std::vector<PlotLine>& lines, PlotOptions& o) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const PlotLine& line : lines) {
    check(line);
    xs.insert(xs.end(), line.x.begin(), line.x.end());
    for (const auto* column : {&line.y, &line.low, &line.high}) {
      ys.insert(ys.end(), column->begin(), column->end());
    }
  }
  if (o.x_low == o.x_high) plot_range(xs, o.x_low, o.x_high);
  if (o.y_low == o.y_high) {
    plot_range(ys, o.y_low, o.y_high);
    const double air = 0.05 * (o.y_high - o.y_low);
    o.y_low -= air;
    o.y_high += air;
  }
}

}  // namespace

VectorPicture plot_lines(const std::vector<PlotLine>& lines, const PlotOptions& options) {
  PlotOptions o = options;
  set_ranges(lines, o);
  std::vector<std::string> names;
  for (const PlotLine& line : lines) names.push_back(line.name);
  const bool named = lines.size() > 1 || (lines.size() == 1 && !lines[0].name.empty());
  PlotFrame frame = plot_frame(o, named ? widest(names) + 44.0 : 0.0);
  // Bands below all curves.
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const PlotLine& line = lines[i];
    VectorShape band;
    band.fill = with_alpha(palette(i), 46);
    Path back;
    Path ring;
    for (std::size_t k = 0; k < line.low.size(); ++k) {
      if (!std::isfinite(line.low[k]) || !std::isfinite(line.high[k])) continue;
      ring.emplace_back(frame.x(line.x[k]), frame.y(line.high[k]));
      back.emplace_back(frame.x(line.x[k]), frame.y(line.low[k]));
    }
    ring.insert(ring.end(), back.rbegin(), back.rend());
    if (ring.size() < 3) continue;
    band.paths.push_back(std::move(ring));
    frame.picture.items.emplace_back(std::move(band));
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const PlotLine& line = lines[i];
    Path piece;
    const auto flush = [&] {
      if (piece.size() > 1) {
        frame.picture.polyline(piece, palette(i), 2.0,
                               line.dashed ? std::vector<double>{6, 4} : std::vector<double>{});
      }
      piece.clear();
    };
    for (std::size_t k = 0; k < line.x.size(); ++k) {
      if (!std::isfinite(line.y[k]) || !std::isfinite(line.x[k])) {
        flush();
        continue;
      }
      piece.emplace_back(frame.x(line.x[k]), frame.y(line.y[k]));
      if (line.points) frame.picture.disc(piece.back(), 3.4, palette(i));
    }
    flush();
  }
  if (named) legend(frame, names, false);
  return frame.picture;
}

VectorPicture plot_map(const PlotMap& map, const PlotOptions& options) {
  if (map.values.size() != map.y.size() || map.x.empty() || map.y.empty()) {
    fail_data("", options.title, "a map needs one row of values for each y");
  }
  std::vector<double> all;
  for (const auto& row : map.values) {
    if (row.size() != map.x.size()) {
      fail_data("", options.title,
                "a row of the map has another number of values than there are x");
    }
    all.insert(all.end(), row.begin(), row.end());
  }
  double low = map.low;
  double high = map.high;
  if (low == high) plot_range(all, low, high);
  PlotOptions o = options;
  o.x_low = o.y_low = 0.0;
  o.x_high = double(map.x.size());
  o.y_high = double(map.y.size());
  o.x_log = false;
  std::vector<std::string> rows;
  for (const double y : map.y) rows.push_back(map_number(y));
  PlotFrame frame = plot_frame(o, 84.0, false, false, 46.0, std::max(62.0, widest(rows) + 46.0));
  VectorPicture& p = frame.picture;
  const double w = frame.x(1) - frame.x(0);
  const double h = frame.y(0) - frame.y(1);
  for (std::size_t r = 0; r < map.y.size(); ++r) {
    for (std::size_t c = 0; c < map.x.size(); ++c) {
      const double value = map.values[r][c];
      if (!std::isfinite(value)) continue;
      const Color color = color_map(ColorMap::cividis, (value - low) / (high - low));
      const double x = frame.x(double(c));
      const double y = frame.y(double(r) + 1);
      p.fill_rectangle(x, y, w, h, color);
      if (w > 34.0 && h > 16.0) {
        p.text(x + w / 2, y + h / 2 + 4.0, fmt::format("{:.2f}", value), 11.0, readable_on(color),
               TextAnchor::middle);
      }
    }
    p.text(frame.left - 8.0, frame.y(double(r) + 0.5) + 4.0, rows[r], 11.5, ink, TextAnchor::end);
  }
  const std::size_t every = 1 + std::size_t(46.0 / std::max(w, 1.0));
  for (std::size_t c = 0; c < map.x.size(); c += every) {
    p.text(frame.x(double(c) + 0.5), frame.bottom + 17.0, map_number(map.x[c]), 11.5, ink,
           TextAnchor::middle);
  }
  for (int i = 0; i < 50; ++i) {
    const double from = frame.bottom - (frame.bottom - frame.top) * (i + 1) / 50.0;
    p.fill_rectangle(frame.right + 16.0, from, 14.0, (frame.bottom - frame.top) / 50.0 + 0.5,
                     color_map(ColorMap::cividis, (i + 0.5) / 50.0));
  }
  for (int i = 0; i <= 4; ++i) {
    p.text(frame.right + 35.0, frame.bottom - (frame.bottom - frame.top) * i / 4.0 + 4.0,
           map_number(low + (high - low) * i / 4.0), 11.0);
  }
  p.text(frame.right + 16.0, frame.top - 7.0, map.value_label, 11.5);
  return p;
}

VectorPicture plot_bars(const std::vector<std::string>& names, const std::vector<PlotStack>& stacks,
                        const PlotOptions& options) {
  std::vector<double> sums(names.size(), 0.0);
  std::vector<std::string> parts;
  for (const PlotStack& stack : stacks) {
    if (stack.values.size() != names.size()) {
      fail_data("", "'" + stack.name + "'", "needs one value for each bar");
    }
    for (std::size_t i = 0; i < names.size(); ++i) sums[i] += std::max(0.0, stack.values[i]);
    parts.push_back(stack.name);
  }
  PlotOptions o = options;
  o.x_low = 0.0;
  o.x_high = std::max<double>(1.0, double(names.size()));
  o.x_log = false;
  if (o.y_low == o.y_high) {
    const double most = sums.empty() ? 0.0 : *std::max_element(sums.begin(), sums.end());
    o.y_low = 0.0;
    o.y_high = most > 0.0 ? 1.08 * most : 1.0;
  }
  double name_width = 0.0;
  for (const std::string& name : names) name_width = std::max(name_width, text_width(name, 11.5));
  const double room = (options.width - 80.0) / std::max<double>(1.0, double(names.size()));
  const bool turned = name_width > room - 6.0;
  const bool many = stacks.size() > 1;
  PlotFrame frame = plot_frame(o, many ? widest(parts) + 44.0 : 0.0, false, true,
                               turned ? name_width * 0.71 + 46.0 : 46.0);
  const double w = frame.x(1) - frame.x(0);
  for (std::size_t i = 0; i < names.size(); ++i) {
    double base = 0.0;
    for (std::size_t s = 0; s < stacks.size(); ++s) {
      const double value = stacks[s].values[i];
      if (!(value > 0.0)) continue;
      frame.picture.fill_rectangle(frame.x(double(i)) + 0.15 * w, frame.y(base + value), 0.7 * w,
                                   frame.y(base) - frame.y(base + value), palette(s));
      base += value;
    }
    VectorText name{{frame.x(double(i) + 0.5), frame.bottom + 17.0},
                    names[i],
                    11.5,
                    ink,
                    turned ? TextAnchor::end : TextAnchor::middle,
                    FontWeight::regular,
                    turned ? 45.0 : 0.0};
    frame.picture.items.emplace_back(std::move(name));
  }
  if (many) legend(frame, parts, true);
  return frame.picture;
}

VectorPicture plot_reliability(const std::vector<ReliabilityPoint>& points, PlotOptions options) {
  options.x_low = options.y_low = 0.0;
  options.x_high = options.y_high = 1.0;
  options.x_log = false;
  if (options.x_label.empty()) options.x_label = "stated probability";
  if (options.y_label.empty()) options.y_label = "share that was right";
  PlotFrame frame = plot_frame(options, 0.0);
  VectorPicture& p = frame.picture;
  p.line({frame.x(0), frame.y(0)}, {frame.x(1), frame.y(1)}, faint_ink, 1.2, {5, 5});
  Path path;
  for (const ReliabilityPoint& point : points) {
    const double x = frame.x(point.stated);
    p.line({x, frame.y(point.low)}, {x, frame.y(point.high)}, palette(0), 1.6);
    path.emplace_back(x, frame.y(point.right));
  }
  p.polyline(path, palette(0), 2.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    p.disc(path[i], 3.8, palette(0));
    p.text(path[i].x() + 6.0, path[i].y() + 14.0, plot_number(points[i].count), 10.5, faint_ink);
  }
  return p;
}

VectorPicture plot_confusion(const std::vector<std::string>& names,
                             const std::vector<std::vector<double>>& counts, PlotOptions options) {
  if (counts.size() != names.size()) {
    fail_data("", options.title, "a confusion matrix needs a row for each name");
  }
  const double n = std::max<double>(1.0, double(names.size()));
  options.x_low = options.y_low = 0.0;
  options.x_high = options.y_high = n;
  options.x_log = false;
  const double name_width = widest(names);
  PlotFrame frame =
      plot_frame(options, 0.0, false, false, name_width * 0.71 + 46.0, name_width + 44.0);
  VectorPicture& p = frame.picture;
  const double w = frame.x(1) - frame.x(0);
  const double h = frame.y(0) - frame.y(1);
  for (std::size_t t = 0; t < names.size(); ++t) {
    if (counts[t].size() != names.size()) {
      fail_data("", options.title, "a row of the confusion matrix is not as long as the names");
    }
    double sum = 0.0;
    for (const double count : counts[t]) sum += count;
    const double y = frame.y(n - double(t));
    for (std::size_t s = 0; s < names.size() && sum > 0.0; ++s) {
      const double share = counts[t][s] / sum;
      if (share <= 0.0) continue;
      const Color color = mix(paper_white, s == t ? palette(0) : palette(5), 0.06 + 0.94 * share);
      p.fill_rectangle(frame.x(double(s)), y, w, h, color);
      if (w > 22.0 && h > 12.0 && share >= 0.005) {
        p.text(frame.x(double(s) + 0.5), y + h / 2 + 4.0, fmt::format("{:.0f}", 100.0 * share),
               10.5, readable_on(color), TextAnchor::middle);
      }
    }
    p.text(frame.left - 8.0, y + h / 2 + 4.0, names[t], plot_legend_size, ink, TextAnchor::end);
    VectorText name{{frame.x(double(t) + 0.5) + 4.0, frame.bottom + 14.0},
                    names[t],
                    plot_legend_size,
                    ink,
                    TextAnchor::end,
                    FontWeight::regular,
                    45.0};
    p.items.emplace_back(std::move(name));
  }
  return p;
}

}  // namespace scanchor
