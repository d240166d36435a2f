#include "scenes/placer.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/pose.hpp"

namespace scanchor {
namespace {

constexpr double least_gap =
    0.00101;  // [m] between parts of different things: 1 mm, and what rounding may take of it
constexpr double lift = 0.003;  // [m] that loose things start above their support

bool carries(const std::string& part) {
  for (const char* name : {"top", "board", "body", "deck", "worktop", "shelf", "platform",
                           "lower board", "tray", "plinth top"}) {
    if (part.rfind(name, 0) == 0) return true;
  }
  return false;
}

bool has_tied_faces(const Instance& thing) {
  Scene alone;
  alone.instances.push_back(thing);
  return !close_parallel_faces(alone, least_gap).empty();
}

}  // namespace

Placer::Placer(Scene& scene, const RoomShell& room, const RoomOptions& options,
               SequentialRandom& random)
    : scene_(scene), room_(room), options_(options), random_(random) {
  made_ = static_cast<std::uint64_t>(random.below(1U << 30));
  for (const auto& instance : scene.instances) {
    if (instance.kind != "floor" && instance.kind != "wall" && instance.kind != "ceiling")
      remember(instance);
  }
}

Instance Placer::make(const std::string& kind, const std::string& variant,
                      const Parameters& parameters) {
  FurnitureRequest request;
  request.kind = kind;
  request.variant = variant;
  request.parameters = parameters;
  request.unusual = options_.unusual_sizes;
  request.seed = stream_seed(scene_.seed, kind, made_++);
  Instance thing = make_furniture(scene_, request);
  // Leaves grow where they like; once in some hundred plants two lie in one plane.
  while (kind == "plant" && has_tied_faces(thing)) {
    request.seed = stream_seed(request.seed, kind);
    thing = make_furniture(scene_, request);
  }
  return thing;
}

double Placer::jitter() {
  return radians(options_.out_of_square_deg) * std::clamp(random_.normal(), -2.5, 2.5);
}

void Placer::remember(const Instance& instance) {
  for (const auto& box : part_boxes(instance)) solids_.push_back({box, bounds_of(box)});
}

bool Placer::fits(const Instance& instance, bool heed_zones) const {
  const auto boxes = part_boxes(instance);
  const Eigen::AlignedBox3d inside(
      Eigen::Vector3d(room_.low.x() + least_gap, room_.low.y() + least_gap, -1e-9),
      Eigen::Vector3d(room_.high.x() - least_gap, room_.high.y() - least_gap,
                      room_.height - least_gap));
  for (const auto& box : boxes) {
    const Eigen::AlignedBox3d bounds = bounds_of(box);
    if (!inside.contains(bounds)) return false;
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(least_gap);
    const Eigen::AlignedBox3d grown(bounds.min() - reach, bounds.max() + reach);
    for (const auto& solid : solids_) {
      if (grown.intersects(solid.bounds) && boxes_near(box, solid.box, least_gap)) return false;
    }
    if (!heed_zones) continue;
    for (const auto& zone : zones_) {
      if (boxes_near(box, zone, 0.0)) return false;
    }
  }
  return true;
}

std::optional<std::size_t> Placer::put(Instance instance, const Eigen::Isometry3d& pose,
                                       bool heed_zones) {
  instance.T_world_instance = pose;
  if (!fits(instance, heed_zones)) return std::nullopt;
  instance.id = next_id(scene_);
  remember(instance);
  scene_.instances.push_back(std::move(instance));
  return scene_.instances.size() - 1;
}

std::optional<std::size_t> Placer::put_at_wall(const Instance& instance, Side side, double share,
                                               double gap) {
  const Eigen::Isometry3d frame = side_frame(room_, side);
  // Turned in the frame of the side: its back is +y there, as in the thing's own frame.
  const Eigen::Matrix3d turn = rotation_about(2, jitter());
  Eigen::AlignedBox3d bounds;
  for (const auto& part : instance.parts) {
    for (const auto& v : part.vertices) bounds.extend(turn * (part.T_instance_part * v));
  }
  const double room_for = side_length(room_, side) - bounds.sizes().x() - 2 * gap;
  if (room_for < 0) return std::nullopt;
  const Eigen::Vector3d at(gap - bounds.min().x() + share * room_for, -gap - bounds.max().y(), 0);
  return put(instance, frame * pose_at(at, turn));
}

std::optional<std::size_t> Placer::put_at_some_wall(const Instance& instance,
                                                    const std::vector<Side>& sides, double use,
                                                    int tries) {
  for (int i = 0; i < tries; ++i) {
    const Side side = sides[static_cast<std::size_t>(i) % sides.size()];
    // Corners first: that is where people push things.
    const double u = random_.uniform();
    const double share = u < 0.25 ? 0.0 : u < 0.5 ? 1.0 : random_.uniform();
    const double gap = random_.uniform(0.008, 0.05);
    if (const auto placed = put_at_wall(instance, side, share, gap)) {
      if (use > 0) keep_front_free(*placed, use);
      return placed;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> Placer::put_somewhere(const Instance& instance, int tries,
                                                 double wall_gap) {
  for (int i = 0; i < tries; ++i) {
    const double x = random_.uniform(room_.low.x() + wall_gap, room_.high.x() - wall_gap);
    const double y = random_.uniform(room_.low.y() + wall_gap, room_.high.y() - wall_gap);
    const double z = instance.loose ? lift : 0.0;
    if (const auto placed = put(instance, pose_at({x, y, z}, random_.uniform(-pi, pi))))
      return placed;
  }
  return std::nullopt;
}

std::optional<std::size_t> Placer::put_on(const SupportSurface& surface, Instance instance,
                                          const Eigen::Vector2d& at, double yaw) {
  const Eigen::Isometry3d base = scene_.instances[surface.instance].T_world_instance;
  const double z = surface.center.z() + (instance.loose ? lift : 0.0);
  // What touches the surface must lie on it: the rest may hang over.
  const Eigen::Matrix3d turn = rotation_about(2, yaw);
  const double foot = local_bounds(instance).min().z() + 0.02;
  for (const auto& part : instance.parts) {
    for (const auto& v : part.vertices) {
      const Eigen::Vector3d p = part.T_instance_part * v;
      if (p.z() > foot) continue;
      const Eigen::Vector2d reach = (turn * p).head<2>() + at;
      if (std::abs(reach.x()) > surface.half.x() || std::abs(reach.y()) > surface.half.y())
        return std::nullopt;
    }
  }
  return put(std::move(instance),
             base * pose_at({surface.center.x() + at.x(), surface.center.y() + at.y(), z}, yaw),
             false);
}

std::optional<std::size_t> Placer::put_somewhere_on(const SupportSurface& surface,
                                                    const Instance& instance, double yaw,
                                                    double spread, int tries) {
  for (int i = 0; i < tries; ++i) {
    const double turn = yaw + spread * random_.uniform(-1.0, 1.0);
    const Eigen::Matrix3d rotation = rotation_about(2, turn);
    Eigen::AlignedBox3d bounds;
    for (const auto& part : instance.parts) {
      for (const auto& v : part.vertices) bounds.extend(rotation * (part.T_instance_part * v));
    }
    if (bounds.max().z() + lift + 0.01 > surface.clearance) return std::nullopt;
    const Eigen::Vector2d low =
        -surface.half - bounds.min().head<2>() + Eigen::Vector2d::Constant(0.008);
    const Eigen::Vector2d high =
        surface.half - bounds.max().head<2>() - Eigen::Vector2d::Constant(0.008);
    const double x = random_.uniform();
    const double y = random_.uniform();
    if ((high - low).minCoeff() < 0) continue;
    const Eigen::Vector2d at(low.x() + x * (high.x() - low.x()),
                             low.y() + y * (high.y() - low.y()));
    if (const auto placed = put_on(surface, instance, at, turn)) return placed;
  }
  return std::nullopt;
}

std::optional<std::size_t> Placer::hang(const Instance& instance, Side side, double along,
                                        double z) {
  return put(instance, side_frame(room_, side) * pose_at({along, 0, z}), false);
}

std::vector<SupportSurface> Placer::surfaces(std::size_t index) const {
  const Instance& instance = scene_.instances[index];
  std::vector<SupportSurface> result;
  for (std::size_t p = 0; p < instance.parts.size(); ++p) {
    const Part& part = instance.parts[p];
    if (!carries(part.name)) continue;
    for (const auto& face : part.faces) {
      if (!face.planar || (part.T_instance_part.linear() * face.normal).z() < 0.999 ||
          face.size.y() < 0.12)
        continue;
      SupportSurface surface;
      surface.instance = index;
      surface.part = part.name;
      surface.center = part.T_instance_part * face.center;
      const bool x_longer = std::abs((part.T_instance_part.linear() * face.axis).x()) > 0.5;
      surface.half = 0.5 * (x_longer ? face.size : Eigen::Vector2d(face.size.y(), face.size.x()));
      // A round top carries what fits on its inscribed square.
      if (face.area < 0.9 * face.size.x() * face.size.y()) {
        surface.half *= face.area > 0.7 * face.size.x() * face.size.y() ? 0.7 : 0.45;
      }
      surface.clearance = 2.0;
      for (std::size_t q = 0; q < instance.parts.size(); ++q) {
        if (q == p) continue;
        Eigen::AlignedBox3d other;
        for (const auto& v : instance.parts[q].vertices)
          other.extend(instance.parts[q].T_instance_part * v);
        if (other.isEmpty() || other.min().z() < surface.center.z() - 1e-6) continue;
        const bool over = other.min().x() < surface.center.x() + 0.8 * surface.half.x() &&
                          other.max().x() > surface.center.x() - 0.8 * surface.half.x() &&
                          other.min().y() < surface.center.y() + 0.8 * surface.half.y() &&
                          other.max().y() > surface.center.y() - 0.8 * surface.half.y();
        if (over)
          surface.clearance = std::min(surface.clearance, other.min().z() - surface.center.z());
      }
      result.push_back(surface);
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.center.z() < b.center.z(); });
  return result;
}

void Placer::keep_free(const Eigen::Isometry3d& frame, const Eigen::Vector2d& low,
                       const Eigen::Vector2d& high) {
  const Eigen::Vector2d middle = 0.5 * (low + high);
  const Eigen::Vector2d half = 0.5 * (high - low);
  zones_.push_back({frame * Eigen::Vector3d(middle.x(), middle.y(), 1.0),
                    frame.linear(),
                    {half.x(), half.y(), 0.98}});
}

void Placer::keep_front_free(std::size_t index, double depth) {
  const Instance& instance = scene_.instances[index];
  const Eigen::AlignedBox3d bounds = local_bounds(instance);
  keep_free(instance.T_world_instance, {bounds.min().x(), bounds.min().y() - depth},
            {bounds.max().x(), bounds.min().y() - 0.001});
}

}  // namespace scanchor
