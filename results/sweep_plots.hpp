#pragma once
// The pictures of a sweep: curves over one option, maps over two, and which effect costs most.

#include <filesystem>
#include <string>
#include <vector>

#include "eval/sweep.hpp"
#include "results/plot.hpp"

namespace scanchor {

/// A method by the name of its perception.
std::string finder_name(const std::string& method);

/// All metrics of one method over the only axis, each with its 95 % interval.
VectorPicture sweep_plot(const SweepResult& sweep);
/// One metric of several methods over the only axis.
VectorPicture methods_plot(const std::vector<SweepResult>& sweeps, const std::string& metric);
/// Milliseconds a scan of each method's perception and reasoning over the only axis: how it scales
/// with the beams of the scanner, say. The only plot of a sweep that differs from run to run.
VectorPicture times_plot(const std::vector<SweepResult>& sweeps);
/// One metric over two axes; the first goes upwards.
VectorPicture sweep_map(const SweepResult& sweep, const std::string& metric);
/// What each effect costs at its largest, in points of the metric.
VectorPicture ranking_plot(const std::vector<EffectCost>& costs, const std::string& metric);

/// Those that the axes allow, as SVG and PNG; one axis: "scores" of the first method, "times" and,
/// with several methods, one file a metric; two axes: one map a method of the first metric. Points
/// that belong to other shards must not be missing. Returns the SVG files.
std::vector<std::filesystem::path> write_sweep_plots(const std::filesystem::path& folder,
                                                     const std::vector<SweepResult>& sweeps,
                                                     const std::vector<std::string>& metrics);

}  // namespace scanchor
