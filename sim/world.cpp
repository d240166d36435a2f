#include "sim/world.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>
#include <tuple>

#include "core/error.hpp"
#include "sim/edge_guard.hpp"
#include "sim/embree_compat.hpp"
#include "sim/embree_device.hpp"

namespace scanchor {
namespace {

template <int width>
struct Packet;
template <>
struct Packet<4> {
  using Type = RTCRayHit4;
};
template <>
struct Packet<8> {
  using Type = RTCRayHit8;
};
template <>
struct Packet<16> {
  using Type = RTCRayHit16;
};

/// Whether all corners of a triangle lie in a plane, to a tenth of a micrometre.
bool lies_in(const TrianglePlane& plane, const Eigen::Vector3d* corners) {
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(plane.normal.dot(corners[i]) - plane.offset) > 1e-7) return false;
  }
  return true;
}

/// Gloss whose mirror image is at most a twentieth of what the surface scatters by itself is matt
/// to a scanner: the image comes as a second, weaker echo. Without this rule every varnished board
/// would be a mirror.
bool is_plain(const Material& material) {
  return material.transmittance == 0.0 &&
         material.specular * material.specular <= 0.05 * material.reflectance;
}

}  // namespace

struct World::Impl {
  Scene scene;
  WorldOptions options;
  std::vector<FaceAddress> faces;
  std::vector<TriangleTruth> truth;
  std::vector<Eigen::Vector3d> corners;   // three a triangle
  std::vector<SurfaceRecord> surfaces;    // one a triangle
  std::vector<bool> planar;               // one a triangle: its face is planar
  std::vector<std::uint32_t> part_begin;  // first triangle of each part
  std::unique_ptr<EdgeGuard> guard;
  RTCScene embree = nullptr;
  mutable std::once_flag outline_once;
  mutable std::vector<FaceEdge> outline;

  ~Impl() {
    if (embree != nullptr) rtcReleaseScene(embree);
  }

  void collect();
  void share_planes();
  void build();
  void find_outline() const;
  [[nodiscard]] double range(std::uint32_t t, double ox, double oy, double oz, double dx, double dy,
                             double dz) const;
  [[nodiscard]] std::uint32_t decide(const RayColumns& rays, std::size_t k, double tnear) const {
    return guard->nearest({rays.origin_x[k], rays.origin_y[k], rays.origin_z[k]},
                          {rays.direction_x[k], rays.direction_y[k], rays.direction_z[k]}, tnear);
  }
  template <int width>
  void trace_packets(const RayColumns& rays, std::uint32_t* triangle, float tnear) const;
  void trace_single(const RayColumns& rays, std::uint32_t* triangle, float tnear) const;
};

void World::Impl::collect() {
  faces = all_faces(scene);
  std::int32_t first_face = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    for (std::size_t p = 0; p < instance.parts.size(); ++p) {
      const Part& part = instance.parts[p];
      const Eigen::Isometry3d T_world_part = instance.T_world_instance * part.T_instance_part;
      part_begin.push_back(static_cast<std::uint32_t>(truth.size()));
      for (std::size_t t = 0; t < part.triangles.size(); ++t) {
        const std::int32_t face = part.triangle_face[t];
        for (int c = 0; c < 3; ++c) {
          corners.push_back(T_world_part *
                            part.vertices[static_cast<std::size_t>(part.triangles[t][c])]);
        }
        truth.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(p),
                         first_face + face, part.material});
        const auto& material = scene.materials[static_cast<std::size_t>(part.material)];
        surfaces.push_back({{},
                            material.reflectance,
                            instance.class_id,
                            instance.id,
                            static_cast<std::int32_t>(p),
                            first_face + face,
                            part.material,
                            is_plain(material)});
        planar.push_back(part.faces[static_cast<std::size_t>(face)].planar);
      }
      first_face += static_cast<std::int32_t>(part.faces.size());
    }
  }
}

/// Gives all triangles of a planar face the plane of its largest triangle, which is the best
/// conditioned one.
void World::Impl::share_planes() {
  std::vector<double> largest(faces.size(), 0.0);
  std::vector<std::size_t> chosen(faces.size(), 0);
  for (std::size_t t = 0; t < truth.size(); ++t) {
    const Eigen::Vector3d* c = &corners[3 * t];
    const Eigen::Vector3d cross = (c[1] - c[0]).cross(c[2] - c[0]);
    const double length = std::sqrt(cross.squaredNorm());
    const Eigen::Vector3d normal =
        length > 0.0 ? Eigen::Vector3d(cross / length) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
    surfaces[t].plane = {normal, normal.dot(c[0])};
    const auto face = static_cast<std::size_t>(truth[t].face);
    if (length > largest[face]) {
      largest[face] = length;
      chosen[face] = t;
    }
  }
  for (std::size_t t = 0; t < truth.size(); ++t) {
    const std::size_t best = chosen[static_cast<std::size_t>(truth[t].face)];
    const TrianglePlane& plane = surfaces[best].plane;
    if (planar[t] && best != t && lies_in(plane, &corners[3 * t])) surfaces[t].plane = plane;
  }
}

void World::Impl::build() {
  RTCDevice embree_device = device(options.embree_isa);
  embree = rtcNewScene(embree_device);
  rtcSetSceneBuildQuality(embree,
                          options.high_quality ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
  // Robust: without it a ray can slip between two triangles that share an edge, and a closed room
  // leaks.
  rtcSetSceneFlags(embree, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(embree_device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t count = truth.size();
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * count));
  auto* indices = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), count));
  guard = std::make_unique<EdgeGuard>(corners, part_begin);
  for (std::size_t t = 0; t < count; ++t) {
    Eigen::Vector3f three[3];
    guard->with_rim(t, three);
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t v = 3 * t + c;
      for (int axis = 0; axis < 3; ++axis)
        vertices[3 * v + static_cast<std::size_t>(axis)] = three[c][axis];
      indices[v] = static_cast<unsigned int>(v);
    }
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(embree, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(embree);
}

/// Embree replaces components below 1e-18 by +1e-18 before it inverts them, but sorts rays into
/// octants by the sign they came with: one component of -8e-19 (a beam at 90 degrees, times a small
/// tilt) made it lose the whole packet. Zero has no such contradiction.
static inline float ray_component(double d) {
  return std::fabs(d) < 1e-15 ? 0.0F : static_cast<float>(d);
}

double World::Impl::range(std::uint32_t t, double ox, double oy, double oz, double dx, double dy,
                          double dz) const {
  const TrianglePlane& p = surfaces[t].plane;
  const double slope = p.normal.x() * dx + p.normal.y() * dy + p.normal.z() * dz;
  const double height = p.offset - (p.normal.x() * ox + p.normal.y() * oy + p.normal.z() * oz);
  if (std::fabs(slope) > 1e-3) return height / slope;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (int c = 0; c < 3; ++c) {
    const Eigen::Vector3d& v = corners[3 * std::size_t{t} + static_cast<std::size_t>(c)];
    const double along = (v.x() - ox) * dx + (v.y() - oy) * dy + (v.z() - oz) * dz;
    low = std::min(low, along);
    high = std::max(high, along);
  }
  return slope == 0.0 ? 0.5 * (low + high) : std::clamp(height / slope, low, high);
}

template <int width>
void World::Impl::trace_packets(const RayColumns& rays, std::uint32_t* triangle,
                                float tnear) const {
  using Type = typename Packet<width>::Type;
  embree::Query coherent(true), incoherent(false);
  alignas(64) Type packet{};  // lanes beyond the end must hold numbers too
  alignas(64) int valid[width];
  for (int i = 0; i < width; ++i) {  // what Embree only reads
    packet.ray.tnear[i] = tnear;
    packet.ray.time[i] = 0.0F;
    packet.ray.mask[i] = 0xffffffffU;
    packet.ray.id[i] = 0;
    packet.ray.flags[i] = 0;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    valid[i] = -1;
  }
  // Of a full packet the number of rays is known to the compiler, and the conversions become
  // vectors.
  const auto fill = [&](std::size_t first, int n) {
    for (int i = 0; i < n; ++i) {
      const std::size_t k = first + static_cast<std::size_t>(i);
      packet.ray.org_x[i] = static_cast<float>(rays.origin_x[k]);
      packet.ray.org_y[i] = static_cast<float>(rays.origin_y[k]);
      packet.ray.org_z[i] = static_cast<float>(rays.origin_z[k]);
      packet.ray.dir_x[i] = ray_component(rays.direction_x[k]);
      packet.ray.dir_y[i] = ray_component(rays.direction_y[k]);
      packet.ray.dir_z[i] = ray_component(rays.direction_z[k]);
    }
  };
  for (std::size_t first = 0; first < rays.count; first += width) {
    const int n = static_cast<int>(std::min<std::size_t>(width, rays.count - first));
    if (n == width) {
      fill(first, width);
    } else {
      fill(first, n);
      for (int i = n; i < width; ++i) valid[i] = 0;
    }
    for (int i = 0; i < width; ++i) {
      packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    // The frustum of a coherent packet is built for rays from one point. With several origins,
    // whether a ray that passes close to an edge is culled was seen to depend on its neighbours in
    // the packet.
    bool one_origin = true;
    for (int i = 0; i < n; ++i) {
      one_origin = one_origin && packet.ray.org_x[i] == packet.ray.org_x[0] &&
                   packet.ray.org_y[i] == packet.ray.org_y[0] &&
                   packet.ray.org_z[i] == packet.ray.org_z[0];
    }
    embree::intersect(valid, embree, one_origin ? coherent : incoherent, packet);
    // An untouched primID is RTC_INVALID_GEOMETRY_ID, which is our no_hit.
    for (int i = 0; i < n; ++i) {
      const std::size_t k = first + static_cast<std::size_t>(i);
      const std::uint32_t t = packet.hit.primID[i];
      triangle[k] = t;
      if (t != no_hit && guard->on_rim(t, packet.hit.u[i], packet.hit.v[i]))
        triangle[k] = decide(rays, k, tnear);
    }
  }
}

void World::Impl::trace_single(const RayColumns& rays, std::uint32_t* triangle, float tnear) const {
  embree::Query query(false);
  for (std::size_t k = 0; k < rays.count; ++k) {
    RTCRayHit one{};
    one.ray.org_x = static_cast<float>(rays.origin_x[k]);
    one.ray.org_y = static_cast<float>(rays.origin_y[k]);
    one.ray.org_z = static_cast<float>(rays.origin_z[k]);
    one.ray.dir_x = ray_component(rays.direction_x[k]);
    one.ray.dir_y = ray_component(rays.direction_y[k]);
    one.ray.dir_z = ray_component(rays.direction_z[k]);
    one.ray.tnear = tnear;
    one.ray.tfar = std::numeric_limits<float>::infinity();
    one.ray.mask = 0xffffffffU;
    one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    one.hit.primID = RTC_INVALID_GEOMETRY_ID;
    one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(embree, query, one);
    triangle[k] = one.hit.primID;
    if (one.hit.primID != no_hit && guard->on_rim(one.hit.primID, one.hit.u, one.hit.v))
      triangle[k] = decide(rays, k, tnear);
  }
}

void World::Impl::find_outline() const {
  // Two triangles of one planar face that share an edge have it in opposite directions: such a pair
  // is inside the face.
  using Key = std::tuple<std::int32_t, double, double, double, double, double, double>;
  const auto key = [](std::int32_t face, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return Key(face, a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
  };
  std::vector<Key> directed;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (planar[t]) {
        directed.push_back(key(truth[t].face, corners[3 * t + c], corners[3 * t + (c + 1) % 3]));
      }
    }
  }
  std::sort(directed.begin(), directed.end());
  for (std::size_t t = 0; t < truth.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d& from = corners[3 * t + c];
      const Eigen::Vector3d& to = corners[3 * t + (c + 1) % 3];
      if (planar[t] &&
          std::binary_search(directed.begin(), directed.end(), key(truth[t].face, to, from))) {
        continue;
      }
      outline.push_back({from, to});
    }
  }
}

World::World(const Scene& scene, const WorldOptions& options) : impl_(std::make_unique<Impl>()) {
  if (options.packet_width != 1 && options.packet_width != 4 && options.packet_width != 8 &&
      options.packet_width != 16) {
    fail_usage("packet width " + std::to_string(options.packet_width) + " is none",
               "use 1, 4, 8 or 16");
  }
  impl_->scene = scene;
  impl_->options = options;
  const FlushDenormals flush;
  impl_->collect();
  impl_->share_planes();
  impl_->build();
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::trace(const RayColumns& rays, std::uint32_t* triangle, double* range,
                  double minimum_range) const {
  const FlushDenormals flush;
  const auto tnear = static_cast<float>(minimum_range);
  switch (impl_->options.packet_width) {
    case 1:
      impl_->trace_single(rays, triangle, tnear);
      break;
    case 4:
      impl_->trace_packets<4>(rays, triangle, tnear);
      break;
    case 8:
      impl_->trace_packets<8>(rays, triangle, tnear);
      break;
    default:
      impl_->trace_packets<16>(rays, triangle, tnear);
      break;
  }
  for (std::size_t k = 0; k < rays.count; ++k) {
    range[k] = triangle[k] == no_hit
                   ? 0.0
                   : impl_->range(triangle[k], rays.origin_x[k], rays.origin_y[k], rays.origin_z[k],
                                  rays.direction_x[k], rays.direction_y[k], rays.direction_z[k]);
  }
}

void World::trace(std::span<const Ray> rays, std::span<Hit> hits, double minimum_range) const {
  assert(rays.size() == hits.size());
  constexpr std::size_t block = 256;
  double columns[6][block];
  double range[block];
  std::uint32_t triangle[block];
  for (std::size_t first = 0; first < rays.size(); first += block) {
    const std::size_t n = std::min(block, rays.size() - first);
    for (std::size_t i = 0; i < n; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        columns[axis][i] = rays[first + i].origin[axis];
        columns[3 + axis][i] = rays[first + i].direction[axis];
      }
    }
    trace({columns[0], columns[1], columns[2], columns[3], columns[4], columns[5], n}, triangle,
          range, minimum_range);
    for (std::size_t i = 0; i < n; ++i) hits[first + i] = {triangle[i], range[i]};
  }
}

const std::vector<TriangleTruth>& World::triangles() const { return impl_->truth; }
const Eigen::Vector3d& World::normal(std::uint32_t triangle) const {
  return impl_->surfaces[triangle].plane.normal;
}
const TrianglePlane& World::plane(std::uint32_t triangle) const {
  return impl_->surfaces[triangle].plane;
}
const std::vector<SurfaceRecord>& World::surfaces() const { return impl_->surfaces; }
const Eigen::Vector3d& World::corner(std::uint32_t triangle, int index) const {
  return impl_->corners[3 * std::size_t{triangle} + static_cast<std::size_t>(index)];
}
double World::range_to(std::uint32_t triangle, const Eigen::Vector3d& origin,
                       const Eigen::Vector3d& direction) const {
  return impl_->range(triangle, origin.x(), origin.y(), origin.z(), direction.x(), direction.y(),
                      direction.z());
}
const std::vector<FaceEdge>& World::outline() const {
  std::call_once(impl_->outline_once, [this] { impl_->find_outline(); });
  return impl_->outline;
}
const std::vector<FaceAddress>& World::faces() const { return impl_->faces; }
const Scene& World::scene() const { return impl_->scene; }

}  // namespace scanchor
