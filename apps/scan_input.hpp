#pragma once
// A scan named on the command line: read, checked, and put through the stages. Shared by label,
// segment and explain.

#include <filesystem>
#include <string>

#include "apps/command.hpp"
#include "cloud/point_cloud.hpp"
#include "perception/perceive.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/reason.hpp"

namespace scanchor::apps {

struct ScanArguments {
  Common common;
  std::string scan;             ///< file
  std::string sensor = "auto";  ///< "x,y,z", "none", or "auto": what the file says
  std::string ontology = "office";
  PerceiveOptions perceive;
  ReasonOptions reason;
};

/// Adds the positional SCAN and --sensor, --noise, --method; with `reasoning` also --up, --ontology
/// and --mode.
void add_scan_arguments(CLI::App& verb, ScanArguments& arguments, bool reasoning);

/// Applies --set, reads the scan and sets the sensor position. Throws Error.
PointCloud load_scan(ScanArguments& arguments);
/// Throws Error(nothing_measured) for a cloud without a finite point.
void require_finite(const PointCloud& cloud, const std::string& file);

/// Throws Error(nothing_measured) with one line when there is no surface to go on with.
void require_surfaces(const ScanArguments& arguments, const PointCloud& cloud,
                      const Surfaces& surfaces);

/// Writes the input's points in the input's order, its own fields kept, with `plane` and, where
/// given, `label` and `instance` (int32, -1: none). `label` numbers the classes of the labelling's
/// own list, in "classes" of labels.json.
void write_labelled_points(const std::filesystem::path& path, const PointCloud& cloud,
                           const Surfaces& surfaces, const Labelling* labelling);

/// Number of inliers of each surface, as labelling_to_json takes it.
std::vector<std::size_t> inlier_counts(const Surfaces& surfaces);

/// The classes that occur in a labelling, sorted by name: index = number in the field `label`.
std::vector<std::string> label_names(const Labelling& labelling);

}  // namespace scanchor::apps
