#include "results/score_plots.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "core/file.hpp"
#include "results/image.hpp"
#include "results/paint.hpp"

namespace scanchor {
namespace {

PlotOptions titled(const std::string& what, const std::string& of) {
  PlotOptions options;
  options.title = of.empty() ? what : what + "   (" + of + ")";
  return options;
}

}  // namespace

std::vector<ReliabilityPoint> reliability_points(const LabelScore& labels) {
  std::vector<ReliabilityPoint> points;
  for (const ReliabilityBin& bin : labels.reliability) {
    if (bin.count == 0) continue;
    const double n = double(bin.count);
    const double right = double(bin.right) / n;
    const double z = 1.959963984540054;
    const double middle = (right + z * z / (2 * n)) / (1 + z * z / n);
    const double half =
        z / (1 + z * z / n) * std::sqrt(right * (1 - right) / n + z * z / (4 * n * n));
    points.push_back({bin.probability.value() / n, right, middle - half, middle + half, n});
  }
  return points;
}

VectorPicture reliability_plot(const LabelScore& labels, const std::string& title) {
  PlotOptions options = titled("Do stated probabilities hold?", title);
  options.x_label = "stated probability";
  options.y_label = "share that was right";
  options.width = 560;
  options.height = 480;
  return plot_reliability(reliability_points(labels), options);
}

VectorPicture risk_plot(const LabelScore& labels, const std::string& title) {
  PlotLine line;
  line.points = false;
  for (const RiskPoint& point : risk_coverage(labels)) {
    line.x.push_back(point.coverage);
    line.y.push_back(point.risk);
  }
  PlotOptions options = titled("Wrong labels among the surest", title);
  options.x_label = "share of the things that are labelled, surest first";
  options.y_label = "share of these labels that is wrong";
  options.y_high = line.y.empty() ? 1.0 : 1.1 * *std::max_element(line.y.begin(), line.y.end());
  if (options.y_high <= 0.0) options.y_high = 1.0;
  options.x_high = 1.0;
  return plot_lines({line}, options);
}

VectorPicture confusion_plot(const PointScore& points, const std::string& title,
                             std::size_t most_classes) {
  std::vector<std::pair<std::int64_t, std::size_t>> size;
  for (std::size_t c = 0; c < points.classes; ++c) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < points.classes; ++k) sum += points.at(c, k);
    if (sum > 0) size.emplace_back(-sum, c);
  }
  std::sort(size.begin(), size.end());
  if (size.size() > most_classes) size.resize(most_classes);
  std::vector<std::string> names;
  std::vector<std::vector<double>> counts;
  for (const auto& [sum, truth] : size) {
    names.emplace_back(class_info(static_cast<ClassId>(truth)).name);
    counts.emplace_back();
    for (const auto& [other, said] : size) counts.back().push_back(double(points.at(truth, said)));
    counts.back().push_back(double(points.at(truth, 0)));
  }
  // What was not named is a column; nothing is "not named" in truth, so its row stays empty.
  names.emplace_back("(not named)");
  counts.emplace_back(names.size(), 0.0);
  PlotOptions options = titled("What is taken for what, by points", title);
  options.x_label = "called";
  options.y_label = "is";
  options.width = options.height = int(220 + 36 * names.size());
  return plot_confusion(names, counts, options);
}

VectorPicture planes_plot(const PlaneScore& planes, const Protocol& protocol,
                          const std::string& title) {
  const auto line = [&](const std::string& name, std::int64_t HooverCounts::*member,
                        std::int64_t whole) {
    PlotLine one;
    one.name = name;
    for (std::size_t i = 0; i < planes.hoover.size(); ++i) {
      one.x.push_back(protocol.plane_tolerances[i]);
      one.y.push_back(whole > 0 ? double(planes.hoover[i].*member) / double(whole) : 0.0);
    }
    return one;
  };
  PlotOptions options = titled("Planes by Hoover's classes", title);
  options.x_label = "tolerance: share of points that must agree";
  options.y_label = "share of true planes (noise: of found regions)";
  options.y_high = 1.0;
  return plot_lines({line("correct", &HooverCounts::correct, planes.truths),
                     line("in pieces", &HooverCounts::truth_over, planes.truths),
                     line("run together", &HooverCounts::truth_under, planes.truths),
                     line("missed", &HooverCounts::missed, planes.truths),
                     line("noise", &HooverCounts::noise, planes.regions)},
                    options);
}

std::filesystem::path write_plot(const std::filesystem::path& folder, const std::string& name,
                                 const VectorPicture& picture) {
  make_folder(folder);
  const std::filesystem::path svg = folder / (name + ".svg");
  write_svg(svg, picture);
  Image image = blank_image(picture.width, picture.height);
  paint(picture, image);
  write_png(folder / (name + ".png"), image);
  return svg;
}

std::vector<std::filesystem::path> write_score_plots(const std::filesystem::path& folder,
                                                     const Score& score, const Protocol& protocol,
                                                     const std::string& name) {
  std::vector<std::filesystem::path> files;
  if (!reliability_points(score.labels).empty()) {
    files.push_back(write_plot(folder, "reliability", reliability_plot(score.labels, name)));
    files.push_back(write_plot(folder, "risk", risk_plot(score.labels, name)));
  }
  if (score.points.classes > 0)
    files.push_back(write_plot(folder, "confusion", confusion_plot(score.points, name)));
  if (score.planes.truths > 0)
    files.push_back(write_plot(folder, "planes", planes_plot(score.planes, protocol, name)));
  return files;
}

std::string file_name_of(const std::string& name) {
  std::string file;
  for (const char c : name) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    file += plain ? c : '-';
  }
  return file;
}

}  // namespace scanchor
