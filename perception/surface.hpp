#pragma once
// What perception makes of a cloud: planar surfaces with their shape and their uncertainty.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace scanchor {

/// n . x = offset with |n| = 1, and its uncertainty (reasoning.md section 2.2).
struct Plane {
  Eigen::Vector3d normal =
      Eigen::Vector3d::UnitZ();  ///< unit; towards the sensor where its position is known
  double offset = 0.0;           ///< [m]
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< [m] of the inliers
  double residual_sigma = 0.0;  ///< [m] standard deviation of the inliers across the plane
  Eigen::Matrix3d normal_covariance =
      Eigen::Matrix3d::Zero();  ///< [rad2], rank 2, along the plane's axes
  double centroid_sigma = 0.0;  ///< [m] of the offset at the centroid
};

/// A ring of a polygon, simple, not repeating the first vertex. Outer rings run counter-clockwise,
/// holes clockwise, seen against the normal. Coordinates in the surface's own frame
/// (`T_cloud_surface`), metres.
using Ring = std::vector<Eigen::Vector2d>;
/// [m2] signed: positive counter-clockwise, negative clockwise.
double ring_area(const Ring& ring);

/// What lies beyond a piece of the outline.
enum class EdgeKind : std::uint8_t { true_edge, occlusion, view_limit, unknown };
/// "true_edge", "occlusion", "view_limit", "unknown".
std::string_view edge_kind_name(EdgeKind kind);

struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
  std::vector<EdgeKind>
      outer_kind;  ///< edge i runs from outer[i] to outer[i+1]; empty: not examined
  [[nodiscard]] double area() const;  ///< [m2] holes taken off
};

/// A measured number with a 95 % interval. `at_least`: the outline ends in a shadow, the true value
/// may be larger.
struct Measured {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
  bool at_least = false;
};

struct FittedRectangle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m] in the surface's frame
  double angle = 0.0;  ///< [rad] of the longer side against the frame's x axis
  Measured length;     ///< [m] longer side = the paper's E
  Measured width;      ///< [m] shorter side
};

/// One planar surface. Frame of the surface: origin at the plane's centroid, z along the normal.
struct Surface {
  std::int32_t id = 0;  ///< its index in Surfaces::surfaces
  Plane plane;
  Eigen::Isometry3d T_cloud_surface = Eigen::Isometry3d::Identity();
  std::vector<std::uint32_t>
      inliers;  ///< indices of points, rising; empty if read from a file that left them out
  std::size_t inlier_count = 0;  ///< their number, also where the list itself was left out
  std::vector<Polygon>
      polygons;  ///< pieces, largest first; at least one for three points that are not on a line
  FittedRectangle rectangle;
  Measured area;  ///< [m2] A of the paper: of the polygons, strays taken off
  double rectangularness =
      0.0;  ///< R in [0, 1]: area of the polygons / area of the fitted rectangle, of which
            ///< the default method leaves out what lies in a shadow
  bool is_rectangle =
      false;  ///< the paper's binary decision: four lines meeting at about 90 degrees
  double eccentricity = 0.0;  ///< [0, 1) of the inliers' ellipse
  double occluded_outline =
      0.0;  ///< [0, 1] share of the outline that borders a shadow or the end of the view
  double confidence = 1.0;  ///< [0, 1] that this is one planar surface (curved things score low)
};

/// Points that are no surface and were set aside, counted by cause.
struct SetAside {
  std::size_t not_finite = 0;
  std::size_t out_of_range = 0;  ///< returns at the sensor's maximum range
  std::size_t scanner_body = 0;  ///< returns from the scanner's own body
};

/// All surfaces of a cloud.
struct Surfaces {
  std::vector<Surface>
      surfaces;  ///< in order of falling number of inliers, ties by lowest point index
  std::vector<std::int32_t>
      plane_of_point;  ///< one a point of the input: index of its surface, -1: none
  SetAside set_aside;
  double noise_sigma = 0.0;                       ///< [m] given or estimated
  double point_spacing = 0.0;                     ///< [m] median distance to the nearest neighbour
  std::vector<Eigen::Vector3d> sensor_positions;  ///< as used, in the cloud's frame
};

/// surfaces.json (docs/reference/surfaces-format.md): everything but the inliers, of which only the
/// number is kept unless asked.
nlohmann::ordered_json surfaces_to_json(const Surfaces& surfaces, bool with_inliers);
Surfaces surfaces_from_json(const nlohmann::ordered_json& json, const std::string& file);
void write_surfaces(const std::filesystem::path& path, const Surfaces& surfaces,
                    bool with_inliers = true);
Surfaces read_surfaces(const std::filesystem::path& path);

}  // namespace scanchor
