#pragma once
// First half of the default method: planes over cells. A cell of the octree whose points are flat
// to within the noise is taken as a whole, as large as it comes, so most points of a room are never
// looked at one by one.

#include <cstdint>
#include <span>
#include <vector>

#include "perception/beam_noise.hpp"
#include "perception/cell_tree.hpp"

namespace scanchor {

/// A plane that is being grown, in the canonical frame.
struct GrownPlane {
  Moments moments;  ///< of its points
  MomentPlane plane;
  double sigma = 0.0;   ///< [m] of its points across it, about its middle
  double height = 0.0;  ///< [m2] noise along the beam times the sensor's distance from the plane
  double least = 0.0;   ///< [m] scatter at the most grazing incidence
};

/// What a plane means to its points, in their own type: a distance counts in the scatter across the
/// plane at the point's own incidence.
struct PlaneReach {
  float a, b, c, offset, height, least;
  explicit PlaneReach(const GrownPlane& grown)
      : a(static_cast<float>(grown.plane.normal.x())),
        b(static_cast<float>(grown.plane.normal.y())),
        c(static_cast<float>(grown.plane.normal.z())),
        offset(static_cast<float>(grown.plane.offset)),
        height(static_cast<float>(grown.height)),
        least(static_cast<float>(grown.least)) {}
  [[nodiscard]] float scatter(float inverse_range) const {
    return std::max(height * inverse_range, least);
  }
  [[nodiscard]] float distance(float x, float y, float z) const {
    return std::abs(a * x + b * y + c * z - offset);
  }
  /// On the side that the normal points to.
  [[nodiscard]] bool above(float x, float y, float z) const {
    return a * x + b * y + c * z > offset;
  }
  /// Within three sigma.
  [[nodiscard]] bool holds(float x, float y, float z, float inverse_range) const {
    return distance(x, y, z) <= 3.0F * scatter(inverse_range);
  }
};

/// Region of each canonical point, -1: none yet.
struct PlaneLabels {
  std::vector<std::int32_t> of_point;
  std::vector<GrownPlane> planes;
};

/// The points of each plane, rising.
class PlaneMembers {
 public:
  explicit PlaneMembers(const PlaneLabels& labels);
  PlaneMembers(const std::vector<std::int32_t>& of_point, std::size_t planes);
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t plane) const {
    return {points_.data() + start_[plane], points_.data() + start_[plane + 1]};
  }

 private:
  template <class Runs>
  void gather(const std::vector<std::int32_t>& of_point, std::size_t planes, const Runs& runs);
  std::vector<std::uint32_t> start_, points_;
};

/// Finds flat cells, joins neighbours that continue each other's plane, and labels their points
/// within 3 sigma of it. `region_of_cell` (one a cell of the tree, -1: none) tells which flat cells
/// went where.
PlaneLabels cell_planes(const CanonicalCloud& cloud, const CellTree& tree, const BeamNoise& noise,
                        std::vector<std::int32_t>& region_of_cell);

/// Least-squares plane of the moments and its scatter, kept within what the noise allows: up to 1.2
/// times the noise, and not below the noise where the incidence is known, not below a quarter where
/// it is not.
GrownPlane grown_plane(const Moments& moments, const BeamNoise& noise);
/// The same where the plane, fit_plane_fast(moments), is known.
GrownPlane grown_plane(const Moments& moments, const MomentPlane& plane, const BeamNoise& noise);

}  // namespace scanchor
