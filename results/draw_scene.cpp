#include "results/draw_scene.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include "core/math.hpp"

namespace scanchor {
namespace {

bool is_shell(const Instance& instance) {
  const std::string_view name = class_info(instance.class_id).name;
  return name == "wall" || name == "ceiling";
}

/// A ceiling is a slab: from above it goes as a whole, not only its lower face.
bool is_roof(const Instance& instance, const Eigen::Vector3d& eye) {
  return class_info(instance.class_id).name == "ceiling" && eye.z() > 0.0;
}

bool hangs_on_walls(const Instance& instance) {
  static const std::array<std::string_view, 7> names = {
      "door", "window", "whiteboard", "picture", "curtain", "television", "radiator"};
  const std::string_view name = class_info(instance.class_id).name;
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct Sheet {
  Eigen::Vector3d normal;
  double offset;
  Eigen::AlignedBox3d box;
  double area;
};

/// The planes of a wall or ceiling.
std::vector<Sheet> sheets_of(const Instance& instance) {
  std::vector<Sheet> sheets;
  for (const Part& part : instance.parts) {
    const Eigen::Isometry3d pose = instance.T_world_instance * part.T_instance_part;
    for (const Eigen::Vector3i& t : part.triangles) {
      const Eigen::Vector3d a = pose * part.vertices[std::size_t(t[0])];
      const Eigen::Vector3d b = pose * part.vertices[std::size_t(t[1])];
      const Eigen::Vector3d c = pose * part.vertices[std::size_t(t[2])];
      const Eigen::Vector3d across = (b - a).cross(c - a);
      if (!(across.norm() > 0.0)) continue;
      const Eigen::Vector3d n = across.normalized();
      auto same = std::find_if(sheets.begin(), sheets.end(), [&](const Sheet& s) {
        return s.normal.dot(n) > 0.999 && std::abs(s.offset - n.dot(a)) < 0.01;
      });
      if (same == sheets.end()) same = sheets.insert(same, {n, n.dot(a), {}, 0.0});
      same->box.extend(a);
      same->box.extend(b);
      same->box.extend(c);
      same->area += 0.5 * across.norm();
    }
  }
  return sheets;
}

/// A wall of one face that turns its back to the eye goes as a whole, with the reveals of its doors
/// and windows. Of a slab only the faces that look away go.
bool is_turned_away(const std::vector<Sheet>& sheets, const Eigen::Vector3d& eye) {
  double away = 0.0, towards = 0.0;
  for (const Sheet& sheet : sheets) (sheet.normal.dot(eye) < 0.0 ? away : towards) += sheet.area;
  return away > 2.0 * towards;
}

/// What of walls and ceilings stands between the room and the eye.
struct Hidden {
  std::set<const Instance*> whole;  ///< turned away
  /// Faces that turn their back, without narrow ones: nothing hangs on the reveal of a window.
  std::vector<Sheet> sheets;
};

Hidden hidden_from(const Scene& scene, const Eigen::Vector3d& eye) {
  Hidden hidden;
  for (const Instance& instance : scene.instances) {
    if (!is_shell(instance)) continue;
    const std::vector<Sheet> sheets = sheets_of(instance);
    if (is_turned_away(sheets, eye)) hidden.whole.insert(&instance);
    double all = 0.0;
    for (const Sheet& sheet : sheets) all += sheet.area;
    for (const Sheet& sheet : sheets) {
      if (sheet.normal.dot(eye) < 0.0 && sheet.area > 0.2 * all) hidden.sheets.push_back(sheet);
    }
  }
  return hidden;
}

bool hangs_on_hidden(const Instance& instance, const std::vector<Sheet>& sheets) {
  if (!hangs_on_walls(instance)) return false;
  for (const Sheet& sheet : sheets) {
    double low = 1e300;
    double high = -1e300;
    bool beside = false;
    Eigen::AlignedBox3d reach = sheet.box;
    reach.extend(reach.min() - Eigen::Vector3d::Constant(0.4));
    reach.extend(reach.max() + Eigen::Vector3d::Constant(0.4));
    for (const Part& part : instance.parts) {
      const Eigen::Isometry3d pose = instance.T_world_instance * part.T_instance_part;
      for (const Eigen::Vector3d& v : part.vertices) {
        const Eigen::Vector3d p = pose * v;
        low = std::min(low, sheet.normal.dot(p) - sheet.offset);
        high = std::max(high, sheet.normal.dot(p) - sheet.offset);
        beside = beside || reach.contains(p);
      }
    }
    if (beside && low > -0.6 && high < 0.4) return true;
  }
  return false;
}

Color color_of(const Scene& scene, const Instance& instance, const Part& part, SceneColor by) {
  switch (by) {
    case SceneColor::class_id:
      return color_of_class(instance.class_id);
    case SceneColor::instance:
      return is_shell(instance) || class_info(instance.class_id).name == "floor"
                 ? color_of_class(instance.class_id)
                 : color_of_number(instance.id);
    case SceneColor::material:
      break;
  }
  if (part.material < 0 || std::size_t(part.material) >= scene.materials.size()) {
    return {180, 180, 180};
  }
  const auto& rgb = scene.materials[std::size_t(part.material)].color;
  return {rgb[0], rgb[1], rgb[2]};
}

/// Edges where two faces meet or a sheet ends: those that not exactly two triangles of one face
/// share.
void add_edges(DrawnLines& lines, const Part& part, const std::vector<bool>& drawn,
               const Eigen::Isometry3d& pose) {
  // Vertices may be repeated a face, so edges are matched by place.
  using Key = std::array<double, 3>;
  const auto key = [&](int v) {
    const Eigen::Vector3d& p = part.vertices[std::size_t(v)];
    return Key{p.x(), p.y(), p.z()};
  };
  std::map<std::pair<Key, Key>, std::pair<int, int>> seen;  // count, face or -2 when they differ
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    if (!drawn[t]) continue;
    for (int side = 0; side < 3; ++side) {
      Key a = key(part.triangles[t][side]);
      Key b = key(part.triangles[t][(side + 1) % 3]);
      if (b < a) std::swap(a, b);
      auto& entry = seen.try_emplace({a, b}, 0, part.triangle_face[t]).first->second;
      ++entry.first;
      if (entry.second != part.triangle_face[t]) entry.second = -2;
    }
  }
  for (const auto& [ends, entry] : seen) {
    if (entry.first == 2 && entry.second != -2) continue;
    lines.ends.emplace_back(pose * Eigen::Vector3d(ends.first.data()));
    lines.ends.emplace_back(pose * Eigen::Vector3d(ends.second.data()));
  }
}

}  // namespace

Eigen::Vector3d towards_eye(double azimuth_deg, double elevation_deg) {
  const SinCos a = portable_sincos(radians(azimuth_deg));
  const SinCos e = portable_sincos(radians(elevation_deg));
  return {e.cos * a.cos, e.cos * a.sin, e.sin};
}

Drawing draw_scene(const Scene& scene, const DrawSceneOptions& options) {
  Drawing drawing;
  const bool open = options.towards_eye.squaredNorm() > 0.0;
  const Hidden hidden = open ? hidden_from(scene, options.towards_eye) : Hidden{};
  DrawnMesh mesh;
  DrawnLines edges;
  edges.color = {33, 37, 41, 120};
  edges.width_px = 1.0;
  std::map<ClassId, double> area_of_class;
  for (const Instance& instance : scene.instances) {
    if (open &&
        (is_roof(instance, options.towards_eye) || hangs_on_hidden(instance, hidden.sheets))) {
      continue;
    }
    const bool shell = is_shell(instance);
    if (hidden.whole.contains(&instance)) continue;
    Eigen::AlignedBox3d box;
    for (const Part& part : instance.parts) {
      const Eigen::Isometry3d pose = instance.T_world_instance * part.T_instance_part;
      const Color color = color_of(scene, instance, part, options.color);
      std::vector<bool> drawn(part.triangles.size(), true);
      for (std::size_t t = 0; t < part.triangles.size(); ++t) {
        std::array<Eigen::Vector3d, 3> p;
        for (int k = 0; k < 3; ++k) {
          p[std::size_t(k)] = pose * part.vertices[std::size_t(part.triangles[t][k])];
        }
        const Eigen::Vector3d across = (p[1] - p[0]).cross(p[2] - p[0]);
        if (!(across.norm() > 0.0)) continue;
        const Eigen::Vector3d normal = across.normalized();
        if (open && shell && normal.dot(options.towards_eye) < 0.0) {
          drawn[t] = false;
          continue;
        }
        area_of_class[instance.class_id] += across.norm() / 2.0;
        const int base = int(mesh.vertices.size());
        for (const Eigen::Vector3d& corner : p) {
          mesh.vertices.push_back(corner);
          mesh.normals.push_back(normal);
          mesh.colors.push_back(color);
          box.extend(corner);
        }
        mesh.triangles.emplace_back(base, base + 1, base + 2);
      }
      if (options.edges) add_edges(edges, part, drawn, pose);
    }
    drawing.bounds.extend(box);
    if (options.names && class_info(instance.class_id).thing && !box.isEmpty()) {
      drawing.labels.push_back({{box.center().x(), box.center().y(), box.max().z()},
                                std::string(class_info(instance.class_id).name),
                                color_of_class(instance.class_id),
                                box.volume()});
    }
  }
  drawing.meshes.push_back(std::move(mesh));
  if (!edges.ends.empty()) drawing.lines.push_back(std::move(edges));
  if (options.sensor && !scene.sensor_poses.empty()) {
    const Eigen::Isometry3d& pose = scene.sensor_poses.front();
    DrawnLines mark;
    mark.color = {213, 94, 0};
    mark.width_px = 2.5;
    mark.hidden = true;
    add_box_lines(mark, pose, {0.12, 0.12, 0.12});
    mark.ends.insert(mark.ends.end(), {pose.translation(), pose * Eigen::Vector3d(0.5, 0, 0)});
    drawing.lines.push_back(std::move(mark));
  }
  if (options.color == SceneColor::class_id) {
    std::vector<std::pair<double, ClassId>> order;
    for (const auto& [id, area] : area_of_class) order.emplace_back(-area, id);
    std::sort(order.begin(), order.end());
    for (const auto& [area, id] : order) {
      drawing.legend.push_back({std::string(class_info(id).name), color_of_class(id)});
    }
    drawing.legend_title = "class";
  }
  return drawing;
}

Drawing explode(const std::vector<Drawing>& rooms, double gap) {
  Eigen::AlignedBox3d all;
  for (const Drawing& room : rooms) all.extend(room.bounds);
  Drawing result;
  for (Drawing room : rooms) {
    if (room.bounds.isEmpty()) continue;
    Eigen::Vector3d shift = gap * (room.bounds.center() - all.center());
    shift.z() = 0.0;
    room.move(Eigen::Isometry3d(Eigen::Translation3d(shift)));
    result.add(room);
  }
  return result;
}

}  // namespace scanchor
