#include "eval/truth.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/error.hpp"
#include "core/math.hpp"
#include "eval/evaluate.hpp"

namespace scanchor {
namespace {

struct SeenFace {
  std::int32_t face = -1;
  double visible = 1.0;
  bool planar = true;
  WorldFace world{};
  std::int32_t class_id = unlabelled;
  std::int32_t group = -1;  // index of the plane
};

std::uint8_t flag_mask(const Protocol& protocol) {
  std::uint8_t mask = 0;
  for (const auto& word : protocol.ignore_flags) {
    if (word == "mixed") mask |= point_mixed;
    if (word == "ghost") mask |= point_ghost;
    if (word == "behind_glass") mask |= point_behind_glass;
    if (word == "out_of_range") mask |= point_out_of_range;
  }
  return mask;
}

// Largest separation of two rectangles of one plane along any of their sides: at most their
// distance.
double gap(const WorldFace& a, const WorldFace& b) {
  double largest = 0.0;
  const Eigen::Vector3d across_a = a.normal.cross(a.axis);
  const Eigen::Vector3d across_b = b.normal.cross(b.axis);
  for (const Eigen::Vector3d& axis : {a.axis, across_a, b.axis, across_b}) {
    const double half_a =
        0.5 * (a.size.x() * std::abs(axis.dot(a.axis)) + a.size.y() * std::abs(axis.dot(across_a)));
    const double half_b =
        0.5 * (b.size.x() * std::abs(axis.dot(b.axis)) + b.size.y() * std::abs(axis.dot(across_b)));
    largest = std::max(largest, std::abs(axis.dot(b.center - a.center)) - half_a - half_b);
  }
  return largest;
}

bool one_plane(const SeenFace& a, const SeenFace& b, const Protocol& protocol, double cosine) {
  if (!a.planar || !b.planar || a.world.normal.dot(b.world.normal) < cosine) return false;
  if (std::abs(a.world.normal.dot(b.world.center - a.world.center)) > protocol.plane_merge_offset)
    return false;
  if (std::abs(b.world.normal.dot(b.world.center - a.world.center)) > protocol.plane_merge_offset)
    return false;
  return gap(a.world, b.world) <= protocol.plane_merge_gap;
}

// Planes out of the faces that have points; fills SeenFace::group.
std::vector<PlaneTruth> group_faces(std::vector<SeenFace>& faces, const Scan& scan,
                                    const Scene* scene, const Protocol& protocol) {
  std::vector<std::size_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  if (scene) {
    const double cosine = portable_sincos(radians(protocol.plane_merge_angle_deg)).cos;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      for (std::size_t j = i + 1; j < faces.size(); ++j) {
        if (!one_plane(faces[i], faces[j], protocol, cosine)) continue;
        const std::size_t a = root(i), b = root(j);
        parent[std::max(a, b)] = std::min(a, b);  // the lowest face is the root
      }
    }
  }
  std::vector<PlaneTruth> planes;
  std::vector<double> seen;
  const Eigen::Isometry3d T_sensor_world = scan.T_world_sensor.inverse();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t r = root(i);
    if (r == i) {
      faces[i].group = static_cast<std::int32_t>(planes.size());
      PlaneTruth plane;
      plane.ignored = !faces[i].planar;
      plane.class_id = faces[i].class_id;
      plane.has_geometry = scene != nullptr && faces[i].planar;
      if (plane.has_geometry) {
        plane.normal = T_sensor_world.linear() * faces[i].world.normal;
        plane.offset = plane.normal.dot(T_sensor_world * faces[i].world.center);
        plane.length = faces[i].world.size.x();
        plane.width = faces[i].world.size.y();
      }
      planes.push_back(plane);
      seen.push_back(0.0);
    }
    faces[i].group = faces[r].group;
    auto& plane = planes[static_cast<std::size_t>(faces[i].group)];
    if (!plane.faces.empty()) plane.length = plane.width = 0.0;
    plane.faces.push_back(faces[i].face);
    if (scene) {
      plane.area += faces[i].world.area;
      seen[static_cast<std::size_t>(faces[i].group)] += faces[i].world.area * faces[i].visible;
    }
  }
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (planes[p].area > 0) planes[p].visible_fraction = seen[p] / planes[p].area;
  }
  return planes;
}

std::vector<SeenFace> seen_faces(const Scan& scan, const Scene* scene) {
  std::vector<std::int32_t> ids;
  for (const auto face : scan.truth.face) {
    if (face >= 0) ids.push_back(face);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::map<std::int32_t, double> visible;
  for (const auto& entry : scan.visibility) visible[entry.face] = entry.visible_fraction;
  std::vector<FaceAddress> addresses;
  if (scene) addresses = all_faces(*scene);
  std::vector<SeenFace> faces;
  for (const auto id : ids) {
    SeenFace face;
    face.face = id;
    if (const auto found = visible.find(id); found != visible.end()) face.visible = found->second;
    if (scene) {
      if (static_cast<std::size_t>(id) >= addresses.size()) {
        fail_data("scan", "",
                  "names face " + std::to_string(id) + ", the scene has " +
                      std::to_string(addresses.size()),
                  "scan and scene do not belong together");
      }
      const auto& address = addresses[static_cast<std::size_t>(id)];
      const auto& instance = scene->instances[static_cast<std::size_t>(address.instance)];
      face.planar = instance.parts[static_cast<std::size_t>(address.part)]
                        .faces[static_cast<std::size_t>(address.face)]
                        .planar;
      face.class_id = instance.class_id;
      if (face.planar) face.world = world_face(*scene, address);
    }
    faces.push_back(face);
  }
  return faces;
}

// How much was seen of the best seen of an instance's large faces. No visibility: 1.
std::map<std::int32_t, double> instance_visibility(const Scan& scan, const Scene& scene,
                                                   const Protocol& protocol) {
  std::map<std::int32_t, double> best;
  if (scan.visibility.empty()) return best;
  std::map<std::int32_t, double> visible;
  for (const auto& entry : scan.visibility) {
    if (static_cast<double>(entry.points) >= protocol.min_face_points)
      visible[entry.face] = entry.visible_fraction;
  }
  std::map<std::int32_t, double> largest;
  const auto addresses = all_faces(scene);
  const auto face_of = [&](const FaceAddress& a) -> const Face& {
    return scene.instances[static_cast<std::size_t>(a.instance)]
        .parts[static_cast<std::size_t>(a.part)]
        .faces[static_cast<std::size_t>(a.face)];
  };
  for (const auto& address : addresses) {
    double& area = largest[address.instance];
    area = std::max(area, face_of(address).area);
  }
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    const auto found = visible.find(static_cast<std::int32_t>(i));
    if (found == visible.end()) continue;
    if (face_of(addresses[i]).area < protocol.large_face * largest[addresses[i].instance]) continue;
    double& value = best[scene.instances[static_cast<std::size_t>(addresses[i].instance)].id];
    value = std::max(value, found->second);
  }
  for (const auto& instance : scene.instances) best.try_emplace(instance.id, 0.0);
  return best;
}

}  // namespace

ScanTruth truth_of(const Scan& scan, const Scene* scene, const Protocol& protocol) {
  const std::size_t count = scan.truth.size();
  if (count != scan.cloud.size() && !scan.cloud.points.empty()) {
    fail_data("scan", "",
              "has " + std::to_string(scan.cloud.size()) + " points and truth of " +
                  std::to_string(count));
  }
  const std::uint8_t mask = flag_mask(protocol);
  const bool has_face = scan.truth.face.size() == count;
  const bool has_instance = scan.truth.instance.size() == count;
  const bool has_flags = scan.truth.flags.size() == count;

  ScanTruth truth;
  truth.class_id.assign(count, unlabelled);
  truth.instance.assign(count, -1);
  truth.plane.assign(count, -1);
  auto faces = has_face ? seen_faces(scan, scene) : std::vector<SeenFace>{};
  truth.planes = group_faces(faces, scan, scene, protocol);
  std::map<std::int32_t, ThingTruth> things;
  std::map<std::int32_t, std::int32_t> group_of;
  for (const auto& face : faces) group_of[face.face] = face.group;
  for (std::size_t i = 0; i < count; ++i) {
    if (has_flags && (scan.truth.flags[i] & mask) != 0) continue;
    truth.class_id[i] = std::max(scan.truth.class_id[i], unlabelled);
    if (has_instance) truth.instance[i] = scan.truth.instance[i];
    if (has_face && scan.truth.face[i] >= 0) {
      truth.plane[i] = group_of[scan.truth.face[i]];
      auto& plane = truth.planes[static_cast<std::size_t>(truth.plane[i])];
      ++plane.points;
      if (plane.class_id == unlabelled) plane.class_id = truth.class_id[i];
    }
    if (truth.instance[i] >= 0 && truth.class_id[i] != unlabelled) {
      auto& thing = things[truth.instance[i]];
      thing.instance = truth.instance[i];
      thing.class_id = truth.class_id[i];
      ++thing.points;
    }
  }
  for (auto& plane : truth.planes) {
    plane.ignored = plane.ignored || plane.points < protocol.plane_min_points ||
                    plane.visible_fraction < protocol.plane_min_visible;
    truth.ignored_planes.push_back(plane.ignored ? 1 : 0);
  }
  const auto visibility =
      scene ? instance_visibility(scan, *scene, protocol) : std::map<std::int32_t, double>{};
  for (auto& [id, thing] : things) {
    if (const auto found = visibility.find(id); found != visibility.end())
      thing.visible_fraction = found->second;
    thing.name = std::string(class_info(thing.class_id).name) + " " + std::to_string(id);
    const bool unseen = thing.visible_fraction < protocol.min_visible;
    thing.ignored = unseen || thing.points < protocol.min_points;
    if (unseen) truth.ignored_instances.push_back(id);
    truth.things.push_back(thing);
  }
  return truth;
}

PointPrediction perfect_prediction(const ScanTruth& truth) {
  PointPrediction prediction;
  prediction.class_id = truth.class_id;
  prediction.instance = truth.instance;
  prediction.plane = truth.plane;
  return prediction;
}

}  // namespace scanchor
