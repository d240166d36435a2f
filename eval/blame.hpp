#pragma once
// Which stage loses what: the truth is put in for one stage after another, and what remains is the
// loss of the stages behind it.

#include <string>
#include <vector>

#include "eval/run.hpp"

namespace scanchor {

enum class PerfectUpTo : std::uint8_t {
  nothing,  ///< the whole pipeline
  scan,     ///< no noise: every point lies on its surface
  planes,   ///< and points are grouped into planes as in the truth
  shapes,   ///< and polygons, rectangles and areas are those of the faces, seen whole
  labels,   ///< and every plane is called what it is: the upper limit of the scores
};
std::string stage_word(PerfectUpTo stage);

/// A scan with every point moved along its ray to where the beam truly hit
/// (PointTruth::true_range). Ghosts and points out of range keep their place.
Scan perfect_scan(const Scan& scan);

/// Planes as in the truth, of at least `plane_min_points` points: fitted as find_planes fits its
/// own. Smaller ones count nowhere, and no pipeline would call them planes.
Surfaces perfect_planes(const Scan& scan, const ScanTruth& truth, const Protocol& protocol);

/// Shapes as in the truth: plane, rectangle, area and polygon of the faces themselves, as if seen
/// whole.
Surfaces perfect_shapes(const Scan& scan, const Scene& scene, const ScanTruth& truth,
                        const Protocol& protocol);

struct BlameRow {
  PerfectUpTo perfect = PerfectUpTo::nothing;
  Score score;
};

struct BlameResult {
  Protocol protocol;
  std::string data;
  std::vector<BlameRow> rows;  ///< nothing, scan, planes, shapes, labels
  /// Loss of each stage in a metric: what its perfection gains over the row before, in the order of
  /// rows from 1 on; the last entry is what no stage can gain (things that the protocol cannot
  /// count as found).
  [[nodiscard]] std::vector<std::pair<std::string, double>> losses(const std::string& metric) const;
};

/// Runs the suite once for each row over the same scenes.
BlameResult blame(const Suite& suite, const PerceiveOptions& perceive, const Ontology& ontology,
                  const ReasonOptions& reason, const RunOptions& options);

/// A table for a terminal or a page: rows, the given metrics, and the loss by stage.
std::string blame_to_markdown(const BlameResult& result, const std::vector<std::string>& metrics);

}  // namespace scanchor
