#pragma once
// The scene as rays see it: Embree finds the primitive, we compute where it was hit, in double
// precision, so that the result is the same on every processor.

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scenes/scene.hpp"

namespace scanchor {

inline constexpr std::uint32_t no_hit = 0xffffffffU;

struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< unit
};

/// Many rays as columns, which is how packets want them. Borrows the columns.
struct RayColumns {
  const double *origin_x, *origin_y, *origin_z;           ///< [m]
  const double *direction_x, *direction_y, *direction_z;  ///< unit
  std::size_t count;
};

struct Hit {
  std::uint32_t triangle = no_hit;  ///< index into World's triangles
  double range = 0.0;               ///< [m] along the ray to the plane of the triangle
};

/// What a triangle belongs to.
struct TriangleTruth {
  std::int32_t instance;  ///< index into Scene::instances
  std::int32_t part;      ///< index into Instance::parts
  std::int32_t face;      ///< index into all_faces(scene)
  std::int32_t material;  ///< index into Scene::materials
};

struct WorldOptions {
  std::string embree_isa;     ///< "", "sse2", "avx", "avx2", "avx512": for tests of determinism
  int packet_width = 16;      ///< 1, 4, 8 or 16
  bool high_quality = false;  ///< slower build, faster rays: pays from about ten scans of one scene
};

/// The plane of a triangle: normal . x = offset. All triangles of a planar face carry the same
/// bits, so a range does not depend on which of them was hit.
struct TrianglePlane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, outwards
  double offset = 0.0;                               ///< [m]
};

/// All that a beam needs to know about the triangle it met, in one cache line.
struct SurfaceRecord {
  TrianglePlane plane;
  double reflectance;  ///< of the material
  std::int32_t class_id;
  std::int32_t instance_id;  ///< Instance::id
  std::int32_t part;         ///< index into Instance::parts
  std::int32_t face;         ///< index into World::faces()
  std::int32_t material;     ///< index into Scene::materials
  bool plain;  ///< what it mirrors or transmits is beneath notice beside what it scatters
               ///< (world.cpp)
};

/// A piece of the outline of a face, or an edge of a curved one: where a beam's footprint can
/// straddle two surfaces.
struct FaceEdge {
  Eigen::Vector3d from, to;  ///< [m] world
};

/// Immutable after construction; const members may be called from any thread.
///
/// Determinism: Embree chooses the triangle in single precision with a code path that depends on
/// the processor; the range is computed here in double precision from the triangle's plane. Where
/// no two parallel faces overlap within a millimetre (a property that scenes/ tests) the same
/// triangle is found on every processor, and the range has the same bits.
class World {
 public:
  explicit World(const Scene& scene, const WorldOptions& options = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Nearest hit of each ray beyond `minimum_range`. hits.size() must equal rays.size().
  /// Neighbouring rays should be neighbours in the span: they travel in packets.
  void trace(std::span<const Ray> rays, std::span<Hit> hits, double minimum_range = 1e-4) const;
  /// The same on columns: triangle[i] is no_hit where nothing was hit, and range[i] is then 0.
  void trace(const RayColumns& rays, std::uint32_t* triangle, double* range,
             double minimum_range = 1e-4) const;

  [[nodiscard]] const std::vector<TriangleTruth>& triangles() const;
  [[nodiscard]] const Eigen::Vector3d& normal(
      std::uint32_t triangle) const;  ///< unit, outwards, world frame
  [[nodiscard]] const TrianglePlane& plane(std::uint32_t triangle) const;
  /// One a triangle, in the order of triangles().
  [[nodiscard]] const std::vector<SurfaceRecord>& surfaces() const;
  /// Corner 0, 1 or 2 of a triangle [m], world frame.
  [[nodiscard]] const Eigen::Vector3d& corner(std::uint32_t triangle, int index) const;
  /// Range to the triangle's plane along a ray, kept between the nearest and the farthest corner (a
  /// plane seen edge-on has no well-conditioned intersection).
  [[nodiscard]] double range_to(std::uint32_t triangle, const Eigen::Vector3d& origin,
                                const Eigen::Vector3d& direction) const;
  /// Outlines of planar faces, and all edges of curved ones. Computed once, on the first call.
  [[nodiscard]] const std::vector<FaceEdge>& outline() const;
  [[nodiscard]] const std::vector<FaceAddress>& faces() const;  ///< as all_faces(scene)
  [[nodiscard]] const Scene& scene() const;                     ///< a copy that the world keeps

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanchor
