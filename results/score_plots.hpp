#pragma once
// The pictures of a score: whether probabilities hold, what is taken for what, how planes fare as
// the tolerance rises.

#include <filesystem>
#include <string>
#include <vector>

#include "eval/score.hpp"
#include "results/plot.hpp"

namespace scanchor {

/// Non-empty bins with Wilson's 95 % interval (JASA 22, 1927), which also holds for few labels and
/// shares of 0 and 1.
std::vector<ReliabilityPoint> reliability_points(const LabelScore& labels);

/// Stated probability against the share that was right.
VectorPicture reliability_plot(const LabelScore& labels, const std::string& title);
/// Share of wrong labels as labels are taken by falling probability.
VectorPicture risk_plot(const LabelScore& labels, const std::string& title);
/// Points: rows are what they are, columns what they are called, the last one "(not named)"; the
/// classes with most points.
VectorPicture confusion_plot(const PointScore& points, const std::string& title,
                             std::size_t most_classes = 14);
/// Hoover's classes of the planes over the tolerance.
VectorPicture planes_plot(const PlaneScore& planes, const Protocol& protocol,
                          const std::string& title);

/// All of them as SVG and PNG; those without anything to show are left out. Returns the SVG files.
std::vector<std::filesystem::path> write_score_plots(const std::filesystem::path& folder,
                                                     const Score& score, const Protocol& protocol,
                                                     const std::string& name);

/// The name as a part of a file's name: letters, digits, dots and dashes.
std::string file_name_of(const std::string& name);

/// NAME.svg and NAME.png in a folder, which is made. Returns the SVG file.
std::filesystem::path write_plot(const std::filesystem::path& folder, const std::string& name,
                                 const VectorPicture& picture);

}  // namespace scanchor
