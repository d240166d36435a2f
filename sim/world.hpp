#pragma once
// The scene as rays see it: Embree finds the primitive, we compute where it was hit, in double precision, so that the result is
// the same on every processor.

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

/// Immutable after construction; const members may be called from any thread.
class World {
 public:
  explicit World(const Scene& scene, const WorldOptions& options = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Nearest hit of each ray beyond `minimum_range`. hits.size() must equal rays.size(). Neighbouring rays should be neighbours in
  /// the span: they travel in packets.
  void trace(std::span<const Ray> rays, std::span<Hit> hits, double minimum_range = 1e-4) const;

  [[nodiscard]] const std::vector<TriangleTruth>& triangles() const;
  [[nodiscard]] const Eigen::Vector3d& normal(std::uint32_t triangle) const;  ///< unit, outwards, world frame
  [[nodiscard]] const std::vector<FaceAddress>& faces() const;                ///< as all_faces(scene)
  [[nodiscard]] const Scene& scene() const;  ///< a copy that the world keeps

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanchor
