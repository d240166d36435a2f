// What relations hold between: faces and things, made ready to be measured.

#include <cmath>
#include <limits>

#include "core/math.hpp"
#include "core/polygons.hpp"
#include "scenes/relations.hpp"
#include "scenes/truth.hpp"

namespace scanchor {
namespace {

/// What follows from the rest.
void finish(RelationBody& body, const RelationTolerances& tolerances) {
  body.grown = dilated(body.footprint, tolerances.footprint_dilation);
  for (const OrientedBox& box : body.boxes) body.bounds.extend(bounds_of(box));
  for (const WorldFace& face : body.level_faces) {
    const Eigen::Vector3d side = face.normal.cross(face.axis);
    Ring2 corners;
    for (const auto& [u, v] :
         {std::pair{-0.5, -0.5}, std::pair{0.5, -0.5}, std::pair{0.5, 0.5}, std::pair{-0.5, 0.5}}) {
      corners.push_back(
          (face.center + u * face.size.x() * face.axis + v * face.size.y() * side).head<2>());
    }
    body.level_shadows.push_back(
        dilated(convex_hull(std::move(corners)), tolerances.footprint_dilation));
  }
}

}  // namespace

RelationBody face_body(const Scene& scene, const FaceAddress& address,
                       const RelationTolerances& tolerances) {
  RelationBody body;
  const Instance& instance = scene.instances[static_cast<std::size_t>(address.instance)];
  const Part& part = instance.parts[static_cast<std::size_t>(address.part)];
  const Eigen::Isometry3d T = instance.T_world_instance * part.T_instance_part;
  body.face = world_face(scene, address);
  body.has_face = part.faces[static_cast<std::size_t>(address.face)].planar;
  body.center = body.face.center;
  OrientedBox flat;
  flat.center = body.face.center;
  flat.axes.col(0) = body.face.axis;
  flat.axes.col(1) = body.face.normal.cross(body.face.axis);
  flat.axes.col(2) = body.face.normal;
  flat.half = {0.5 * body.face.size.x(), 0.5 * body.face.size.y(), 0.0};
  body.boxes.push_back(flat);
  Ring2 points;
  body.z_low = std::numeric_limits<double>::infinity();
  body.z_high = -body.z_low;
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    if (part.triangle_face[t] != address.face) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = T * part.vertices[static_cast<std::size_t>(part.triangles[t][k])];
      points.push_back(p.head<2>());
      body.z_low = std::min(body.z_low, p.z());
      body.z_high = std::max(body.z_high, p.z());
    }
  }
  body.footprint = convex_hull(std::move(points));
  const bool upright =
      std::abs(body.face.normal.z()) < portable_sincos(radians(tolerances.angle_deg)).sin;
  if (upright) body.footprint = dilated(body.footprint, tolerances.upright_footprint);
  if (std::abs(body.face.normal.z()) >= portable_sincos(radians(tolerances.angle_deg)).cos)
    body.level_faces.push_back(body.face);
  finish(body, tolerances);
  return body;
}

RelationBody instance_body(const Scene& scene, std::size_t index,
                           const RelationTolerances& tolerances) {
  RelationBody body;
  const Instance& instance = scene.instances[index];
  body.boxes = part_boxes(instance);
  const Eigen::AlignedBox3d bounds = world_bounds(instance);
  body.center = bounds.center();
  body.z_low = bounds.min().z();
  body.z_high = bounds.max().z();
  Ring2 points;
  double largest = 0.0;
  const double cos_level = portable_sincos(radians(tolerances.angle_deg)).cos;
  for (std::size_t p = 0; p < instance.parts.size(); ++p) {
    const Part& part = instance.parts[p];
    const Eigen::Isometry3d T = instance.T_world_instance * part.T_instance_part;
    for (const auto& v : part.vertices) points.push_back((T * v).head<2>());
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      if (!part.faces[f].planar) continue;
      const WorldFace face =
          world_face(scene, {static_cast<std::int32_t>(index), static_cast<std::int32_t>(p),
                             static_cast<std::int32_t>(f)});
      if (face.area > largest) {
        largest = face.area;
        body.face = face;
        body.has_face = true;
      }
      if (face.normal.z() >= cos_level && face.size.y() > 0.05) body.level_faces.push_back(face);
    }
  }
  body.footprint = convex_hull(std::move(points));
  if (area_of(body.footprint) < 1e-4)
    body.footprint = dilated(body.footprint, tolerances.upright_footprint);
  finish(body, tolerances);
  return body;
}

}  // namespace scanchor
