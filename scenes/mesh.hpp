#pragma once
// Parts that are no boxes: prisms, surfaces of revolution, capsules, cushions, and panels with
// openings. All return closed meshes (but `panel_part` without a back) with measured faces, in
// metres, in the frame of the instance.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace scanchor {

/// A simple polygon, counter-clockwise in the x-y plane, drawn up from z0 to z1. Faces: "top",
/// "bottom", "side 1".. (planar).
Part prism_part(const std::string& name, int material, const std::vector<Eigen::Vector2d>& outline,
                double z0, double z1,
                const Eigen::Isometry3d& T_instance_part = Eigen::Isometry3d::Identity());

/// (radius, z) pairs from bottom to top turned about z. Faces: "bottom" and "top" discs where the
/// ends have a radius, "ring k" for level steps, "wall" (curved) for the rest. A radius of 0 is
/// allowed at the ends. A profile that ends where it began makes a ring without discs; it runs
/// counter-clockwise seen with r to the right and z up.
Part lathe_part(const std::string& name, int material, const std::vector<Eigen::Vector2d>& profile,
                int segments,
                const Eigen::Isometry3d& T_instance_part = Eigen::Isometry3d::Identity());

/// Cylinder between two points. Faces: "bottom" (at p0), "top", "wall".
Part cylinder_part(const std::string& name, int material, const Eigen::Vector3d& p0,
                   const Eigen::Vector3d& p1, double radius, int segments = 12);

/// Tapered capsule between two points with half spheres of radius r0 and r1; one curved face
/// "wall".
Part capsule_part(const std::string& name, int material, const Eigen::Vector3d& p0,
                  const Eigen::Vector3d& p1, double r0, double r1, int segments = 10);

/// Superellipsoid (Barr, "Superquadrics and angle-preserving transformations", 1981) that fills a
/// box: exponent 1 is an ellipsoid, towards 0 a box with ever tighter edges. One curved face
/// "skin".
Part cushion_part(const std::string& name, int material, const Eigen::Vector3d& center,
                  const Eigen::Vector3d& size, double exponent = 0.35, int segments = 12);

/// A box between two corners that is turned by a rotation about its own centre; faces as box_part.
Part turned_box_part(const std::string& name, int material, const Eigen::Vector3d& center,
                     const Eigen::Vector3d& size, const Eigen::Matrix3d& rotation);

/// A rectangular opening of a panel, in the panel's x-z plane.
struct Opening {
  Eigen::Vector2d low, high;  ///< [m] corners
  double depth =
      -1.0;  ///< [m] of its reveals; negative: the panel's; 0: none (somebody else owns them)
};
/// A panel in the x-z plane from (0, 0, 0) to (width, depth, height) with rectangular openings that
/// do not touch each other. Faces: "front" (-y); with `closed` also "back" (+y) and the outer
/// sides; and four reveals "opening k left|right|sill|lintel". A closed panel's reveals have its
/// own depth. An opening whose low z is 0 has no sill and reaches the panel's lower edge.
Part panel_part(const std::string& name, int material, double width, double height, double depth,
                const std::vector<Opening>& openings, bool closed,
                const Eigen::Isometry3d& T_instance_part = Eigen::Isometry3d::Identity());

}  // namespace scanchor
