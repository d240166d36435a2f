#pragma once
// The truth of a scan as the scores use it: what counts, what could not be seen, which planes a
// scan can tell apart.

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "eval/protocol.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor {

/// A planar face of the scene, or several that lie in one plane and touch. In the frame of the
/// cloud.
struct PlaneTruth {
  std::vector<std::int32_t> faces;  ///< indices into all_faces(scene), rising
  std::int64_t points = 0;
  double visible_fraction = 1.0;  ///< [0, 1] of its area; 1 where nothing is known
  bool ignored = false;           ///< too few points or too little seen, or curved
  bool has_geometry = false;      ///< the scene was there; otherwise the values below mean nothing
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< unit, outwards
  double offset = 0.0;                                ///< [m] normal . x
  double length = 0.0,
         width = 0.0;  ///< [m] of the smallest rectangle; only for a single face, else 0
  double area = 0.0;   ///< [m2]
  std::int32_t class_id = unlabelled;
};

/// A thing or a piece of stuff of which the scan has points.
struct ThingTruth {
  std::int32_t instance = -1;  ///< Instance::id
  std::int32_t class_id = unlabelled;
  std::string name;               ///< "desk 12"
  std::int64_t points = 0;        ///< that count
  double visible_fraction = 1.0;  ///< [0, 1] of the best seen of its large faces
  bool ignored = false;
};

struct ScanTruth {
  std::vector<std::int32_t> class_id;  ///< one a point; unlabelled: no truth
  std::vector<std::int32_t> instance;  ///< -1: none
  std::vector<std::int32_t> plane;     ///< index into planes; -1: none
  std::vector<PlaneTruth> planes;
  std::vector<ThingTruth> things;               ///< in rising order of instance
  std::vector<std::int32_t> ignored_instances;  ///< rising
  std::vector<char> ignored_planes;             ///< one a plane
  [[nodiscard]] std::size_t size() const { return class_id.size(); }
};

/// `scene` may be null (a data set without its scenes): then planes are faces, nothing is known of
/// visible area and geometry. Throws Error(bad_data) where scan and scene do not belong together.
ScanTruth truth_of(const Scan& scan, const Scene* scene, const Protocol& protocol);

/// What a perfect pipeline would answer, for tests, for stage blame, and as the upper limit of
/// every score.
struct PointPrediction;
PointPrediction perfect_prediction(const ScanTruth& truth);

}  // namespace scanchor
