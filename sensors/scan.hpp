#pragma once
// A scan: points in the order of measurement, and the truth that each of them carries through the
// noise.

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cloud/point_cloud.hpp"

namespace scanchor {

/// Bits of PointTruth::flags.
enum PointFlag : std::uint8_t {
  point_mixed = 1,         ///< the footprint straddled two surfaces and their echoes ran together
  point_ghost = 2,         ///< seen in a mirror: no surface is where the point is
  point_behind_glass = 4,  ///< the beam passed glass on its way
  point_out_of_range = 8,  ///< reported at the maximum range: no surface
};

/// One row a point, as columns; -1: none.
struct PointTruth {
  std::vector<std::int32_t> class_id;
  std::vector<std::int32_t> instance;   ///< Instance::id
  std::vector<std::int32_t> part;       ///< index into the instance's parts
  std::vector<std::int32_t> face;       ///< index into all_faces(scene)
  std::vector<std::int32_t> runner_up;  ///< Instance::id of the second surface in the footprint
  std::vector<std::uint8_t> flags;      ///< PointFlag bits
  std::vector<float> true_range;        ///< [m]
  std::vector<float> incidence;         ///< [rad] between beam and surface normal
  void resize(std::size_t count);
  [[nodiscard]] std::size_t size() const { return class_id.size(); }
};

/// How much of a face the scan could see.
struct FaceVisibility {
  std::int32_t face;        ///< index into all_faces(scene)
  std::int32_t points;      ///< returns whose truth it is
  double visible_fraction;  ///< [0, 1] area of the face reached by at least one beam / area of the
                            ///< face
};

struct Scan {
  PointCloud cloud;  ///< in the sensor's frame at the scan's nominal pose; field "intensity"
  PointTruth truth;  ///< same length as cloud.points
  std::vector<std::int32_t> line;          ///< line of the sweep, a point
  std::vector<std::int32_t> beam;          ///< beam in the line, a point
  std::vector<FaceVisibility> visibility;  ///< faces with at least one point, in order of face
  Eigen::Isometry3d T_world_sensor = Eigen::Isometry3d::Identity();
  std::uint64_t seed = 0;
  std::size_t beams_fired = 0;
};

/// The cloud with the truth as fields: label (class id), instance, part, face, runner_up, flags,
/// true_range, incidence, line, beam.
PointCloud cloud_with_truth(const Scan& scan);
/// The reverse, as far as the fields are there.
Scan scan_from_cloud(const PointCloud& cloud);

}  // namespace scanchor
