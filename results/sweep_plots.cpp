#include "results/sweep_plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "results/score_plots.hpp"

namespace scanchor {
namespace {

PlotLine line_of(const SweepResult& sweep, const std::string& metric, const std::string& name) {
  PlotLine line;
  line.name = name;
  for (const SweepPoint& point : sweep.points) {
    line.x.push_back(point.values.front());
    line.y.push_back(value_of(point.run, metric));
    for (const auto& [known, interval] : point.intervals) {
      if (known != metric) continue;
      line.low.push_back(std::min(interval.low, line.y.back()));
      line.high.push_back(std::max(interval.high, line.y.back()));
    }
  }
  if (line.low.size() != line.y.size()) line.low.clear(), line.high.clear();
  return line;
}

PlotOptions share_axis(const SweepResult& sweep, const std::string& title) {
  PlotOptions options;
  options.width = 760;
  options.title = title;
  options.x_label = sweep.axes.front().option;
  options.y_label = "share (bands: 95 % over scenes)";
  options.y_high = 1.0;
  return options;
}

void require_axes(const SweepResult& sweep, std::size_t count) {
  if (sweep.axes.size() != count || sweep.points.empty())
    fail_data("", "sweep",
              fmt::format("has {} axes and {} points: this picture needs {} axes",
                          sweep.axes.size(), sweep.points.size(), count));
}

}  // namespace

std::string finder_name(const std::string& method) { return method.substr(0, method.find('/')); }

VectorPicture sweep_plot(const SweepResult& sweep) {
  require_axes(sweep, 1);
  std::vector<PlotLine> lines;
  for (const auto& [metric, interval] : sweep.points.front().intervals)
    lines.push_back(line_of(sweep, metric, metric));
  return plot_lines(lines, share_axis(sweep, "Scores over " + sweep.axes.front().option));
}

VectorPicture methods_plot(const std::vector<SweepResult>& sweeps, const std::string& metric) {
  std::vector<PlotLine> lines;
  for (const SweepResult& sweep : sweeps) {
    require_axes(sweep, 1);
    lines.push_back(line_of(sweep, metric, finder_name(sweep.method)));
  }
  return plot_lines(lines, share_axis(sweeps.front(), metric + " by method"));
}

VectorPicture times_plot(const std::vector<SweepResult>& sweeps) {
  std::vector<PlotLine> lines;
  for (const SweepResult& sweep : sweeps) {
    require_axes(sweep, 1);
    const std::string method = sweeps.size() > 1 ? finder_name(sweep.method) + ": " : "";
    PlotLine perceive, reason;
    perceive.name = method + "perception";
    reason.name = method + "reasoning";
    reason.dashed = true;
    for (const SweepPoint& point : sweep.points) {
      const double scans = std::max<double>(1.0, static_cast<double>(point.run.pooled.scans));
      perceive.x.push_back(point.values.front());
      perceive.y.push_back(1000.0 * point.run.times.perceive / scans);
      reason.x.push_back(point.values.front());
      reason.y.push_back(1000.0 * point.run.times.reason / scans);
    }
    lines.push_back(std::move(perceive));
    lines.push_back(std::move(reason));
  }
  PlotOptions options;
  options.width = 760;
  options.title = "Time of a scan over " + sweeps.front().axes.front().option;
  options.x_label = sweeps.front().axes.front().option;
  options.y_label = "ms a scan (other scans ran beside it)";
  return plot_lines(lines, options);
}

VectorPicture sweep_map(const SweepResult& sweep, const std::string& metric) {
  require_axes(sweep, 2);
  PlotMap map;
  map.y = sweep.axes[0].values;
  map.x = sweep.axes[1].values;
  map.value_label = metric;
  map.values.assign(map.y.size(), std::vector<double>(map.x.size(), 0.0));
  for (std::size_t n = 0; n < sweep.points.size(); ++n)
    map.values[n / map.x.size()][n % map.x.size()] = value_of(sweep.points[n].run, metric);
  PlotOptions options;
  options.width = 680;
  options.height = 460;
  options.title = metric + (sweep.method.empty() ? "" : "   (" + sweep.method + ")");
  options.x_label = sweep.axes[1].option;
  options.y_label = sweep.axes[0].option;
  return plot_map(map, options);
}

VectorPicture ranking_plot(const std::vector<EffectCost>& costs, const std::string& metric) {
  std::vector<std::string> names;
  PlotStack loss;
  for (const EffectCost& cost : costs) {
    names.push_back(fmt::format("{} {:.4g} to {:.4g}", cost.option, cost.from, cost.to));
    loss.values.push_back(100.0 * std::max(0.0, cost.before - cost.after));
  }
  PlotOptions options;
  options.width = 680;
  options.height = 460;
  options.title = "What each effect costs, one at a time";
  options.y_label = "loss in " + metric + " [points]";
  return plot_bars(names, {loss}, options);
}

std::vector<std::filesystem::path> write_sweep_plots(const std::filesystem::path& folder,
                                                     const std::vector<SweepResult>& sweeps,
                                                     const std::vector<std::string>& metrics) {
  std::vector<std::filesystem::path> files;
  const SweepResult& first = sweeps.front();
  if (first.axes.size() == 1) {
    files.push_back(write_plot(folder, "scores", sweep_plot(first)));
    files.push_back(write_plot(folder, "times", times_plot(sweeps)));
    for (const auto& metric : metrics) {
      if (sweeps.size() > 1)
        files.push_back(
            write_plot(folder, "methods-" + file_name_of(metric), methods_plot(sweeps, metric)));
    }
  }
  if (first.axes.size() == 2) {
    for (const SweepResult& sweep : sweeps) {
      files.push_back(write_plot(folder, "map-" + file_name_of(finder_name(sweep.method)),
                                 sweep_map(sweep, metrics.front())));
    }
  }
  return files;
}

}  // namespace scanchor
