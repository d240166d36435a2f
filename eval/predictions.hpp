#pragma once
// Anybody's predictions, read from files. Nothing is scored silently: what does not fit is an error
// that names file, place and cause.

#include <filesystem>
#include <string>
#include <vector>

#include "eval/evaluate.hpp"
#include "sensors/dataset.hpp"

namespace scanchor {

struct PredictionOptions {
  /// Fields of PCD and PLY files.
  std::string label_field = "label", instance_field = "instance", plane_field = "plane",
              confidence_field = "confidence";
  /// {their number, ours}: applied to labels as they are read. Empty: the numbers are those of the
  /// class list.
  std::vector<std::pair<std::int32_t, std::int32_t>> label_map;
};

/// A map from somebody's label numbers to classes: YAML "labels: {52: \"desk\", ...}" as in
/// semantic-kitti.yaml, or "52: desk". Throws Error(bad_data) with file and line for a name that is
/// no class (did you mean), a number twice.
std::vector<std::pair<std::int32_t, std::int32_t>> read_label_map(
    const std::filesystem::path& path);

/// Reads one prediction by the ending:
/// * .label: SemanticKITTI, one uint32 a point, class in the lower 16 bits, instance in the upper
/// 16 (0: none);
/// * .pcd, .ply: fields named in the options; `label` is a must, the others may be absent;
/// * .json: our labels.json with "points" of each object given as indices, or rows: {"label":
/// [...], "instance": [...], ...}. `points`: how many the scan has. Throws Error(bad_data): fewer
/// or more rows (which and how many), NaN or fractions where whole numbers belong, a label that is
/// in neither map nor class list (is the label map another one?), a confidence outside 0 .. 1, a
/// point claimed by two objects, an object id twice.
PointPrediction read_prediction(const std::filesystem::path& path, std::size_t points,
                                const PredictionOptions& options = {},
                                const PointCloud* scan = nullptr);
/// The same for a known scan: the positions in a PLY or PCD file must be those of its points, in
/// its order; a file whose positions are all zero has none.
PointPrediction read_prediction(const std::filesystem::path& path, const PointCloud& scan,
                                const PredictionOptions& options = {});

/// The file of one scan in a folder of predictions.
struct PredictionFile {
  std::string sequence, scan;
  std::size_t sequence_index = 0, scan_index = 0;  ///< in Dataset
  std::filesystem::path path;
};

struct PredictionFolder {
  std::vector<PredictionFile> files;  ///< in the order of the data set
  std::vector<std::string> missing;   ///< scans without a prediction: "00/000003"
};

/// Pairs `folder` with a data set: sequences/NN/predictions/NNNNNN.label (SemanticKITTI), or
/// NN/NNNNNN.{label,ply,pcd,json}, or, for a data set with one sequence, NNNNNN.* itself. `split`:
/// only that part; empty: all. Throws Error(bad_data): no prediction at all, predictions for scans
/// that the data set does not have, two predictions for one scan, `folder` holds truth (labels/ of
/// a data set): swapped arguments.
PredictionFolder find_predictions(const std::filesystem::path& folder, const Dataset& dataset,
                                  const std::string& split = "");

/// Writes rows as SemanticKITTI .label, or PLY fields beside the points. Instances are numbered
/// from 1 in the order of their appearance.
void write_prediction_label(const std::filesystem::path& path, const PointPrediction& prediction);

}  // namespace scanchor
