#include "results/draw_cloud.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/error.hpp"

namespace scanchor {
namespace {

const Field& need(const PointCloud& cloud, std::initializer_list<const char*> names,
                  const char* what) {
  for (const char* name : names) {
    if (const Field* field = cloud.find(name)) return *field;
  }
  std::string known;
  for (const Field& field : cloud.fields) known += (known.empty() ? "" : ", ") + field.name;
  fail_usage(fmt::format("a cloud without the field \"{}\" cannot be coloured by {}",
                         *names.begin(), what),
             known.empty() ? "it has no fields at all" : "it has: " + known);
}

/// Values between which a colour bar runs: nearly all of the data, a few strays aside.
std::pair<double, double> spread(std::vector<double> values, double tail) {
  values.erase(
      std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }),
      values.end());
  if (values.empty()) return {0.0, 1.0};
  const auto at = [&](double share) {
    const auto nth = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  };
  const double low = at(tail);
  const double high = at(1.0 - tail);
  return high > low ? std::make_pair(low, high) : std::make_pair(low - 0.5, low + 0.5);
}

struct Painted {
  std::vector<Color> colors;  // one a point of the cloud
  std::vector<LegendEntry> legend;
  std::string legend_title;
  std::optional<LegendBar> bar;
};

Painted paint_values(const std::vector<double>& values, const std::string& title, ColorMap map,
                     double low, double high) {
  Painted painted;
  painted.colors.reserve(values.size());
  for (const double v : values) painted.colors.push_back(color_map(map, (v - low) / (high - low)));
  painted.bar = LegendBar{title, map, low, high};
  return painted;
}

std::vector<double> column(const Field& field) {
  std::vector<double> values(field.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = field.at(i);
  return values;
}

Painted by_class(const PointCloud& cloud) {
  const Field& field = need(cloud, {"label", "class", "class_id"}, "class");
  Painted painted;
  std::map<ClassId, std::size_t> counts;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const auto id = ClassId(field.at(i));
    ++counts[id];
    painted.colors.push_back(color_of_class(id));
  }
  std::vector<std::pair<std::size_t, ClassId>> order;
  for (const auto& [id, count] : counts) order.emplace_back(count, id);
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  for (const auto& [count, id] : order) {
    painted.legend.push_back({std::string(class_info(id).name), color_of_class(id)});
  }
  painted.legend_title = "class";
  return painted;
}

Painted by_number(const PointCloud& cloud, const char* name) {
  const Field& field = need(cloud, {name}, name);
  Painted painted;
  std::size_t none = 0;
  std::int64_t most = -1;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const auto number = std::int64_t(field.at(i));
    none += number < 0 ? 1 : 0;
    most = std::max(most, number);
    painted.colors.push_back(color_of_number(number));
  }
  if (none > 0) painted.legend.push_back({fmt::format("no {}", name), color_of_number(-1)});
  return painted;
}

Painted by_flags(const PointCloud& cloud) {
  const Field& field = need(cloud, {"flags"}, "flags");
  static const struct {
    int bit;
    const char* name;
    Color color;
  } kinds[] = {{point_out_of_range, "out of range", {240, 228, 66}},
               {point_ghost, "ghost (mirror)", {213, 94, 0}},
               {point_mixed, "mixed", {0, 114, 178}},
               {point_behind_glass, "behind glass", {0, 158, 115}}};
  Painted painted;
  std::array<std::size_t, 4> counts{};
  for (std::size_t i = 0; i < field.size(); ++i) {
    Color color{190, 195, 200};
    for (std::size_t k = 0; k < counts.size(); ++k) {
      if ((int(field.at(i)) & kinds[k].bit) == 0) continue;
      color = kinds[k].color;
      ++counts[k];
      break;
    }
    painted.colors.push_back(color);
  }
  painted.legend.push_back({"plain return", {190, 195, 200}});
  for (std::size_t k = 0; k < counts.size(); ++k) {
    painted.legend.push_back({fmt::format("{}: {}", kinds[k].name, counts[k]), kinds[k].color});
  }
  painted.legend_title = "points";
  return painted;
}

Painted paint_cloud(const PointCloud& cloud, CloudColor by) {
  switch (by) {
    case CloudColor::class_id:
      return by_class(cloud);
    case CloudColor::instance:
      return by_number(cloud, "instance");
    case CloudColor::plane:
      return by_number(cloud, "plane");
    case CloudColor::flags:
      return by_flags(cloud);
    case CloudColor::intensity: {
      std::vector<double> values = column(need(cloud, {"intensity"}, "intensity"));
      const auto [low, high] = spread(values, 0.01);
      return paint_values(values, "intensity", ColorMap::viridis, low, high);
    }
    case CloudColor::range_error: {
      const Field& truth = need(cloud, {"true_range"}, "range error");
      const Eigen::Vector3d sensor = cloud.sensor_poses.empty()
                                         ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                                         : cloud.sensor_poses.front().translation();
      std::vector<double> values(cloud.size());
      std::vector<double> sizes(cloud.size());
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = 1e3 * ((cloud.points[i] - sensor).norm() - truth.at(i));
        sizes[i] = std::abs(values[i]);
      }
      const double most = std::max(spread(sizes, 0.02).second, 1e-6);
      return paint_values(values, "range error [mm]", ColorMap::balance, -most, most);
    }
    case CloudColor::height: {
      std::vector<double> values(cloud.size());
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = cloud.points[i].z();
      const auto [low, high] = spread(values, 0.002);
      for (double& v : values) v -= low;
      return paint_values(values, "height [m]", ColorMap::viridis, 0.0, high - low);
    }
    case CloudColor::plain:
      break;
  }
  Painted painted;
  painted.colors.assign(cloud.size(), {52, 73, 94});
  return painted;
}

}  // namespace

double typical_spacing(const PointCloud& cloud) {
  Eigen::AlignedBox3d box;
  std::size_t count = 0;
  for (const Eigen::Vector3d& p : cloud.points) {
    if (!p.allFinite()) continue;
    box.extend(p);
    ++count;
  }
  if (count < 2) return 0.0;
  const double cell = std::max(0.05, box.sizes().maxCoeff() / 1e6);
  const std::size_t step = 1 + count / 400000;
  std::vector<std::array<std::int32_t, 3>> cells;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    if (!cloud.points[i].allFinite()) continue;
    const Eigen::Vector3d place = (cloud.points[i] - box.min()) / cell;
    cells.push_back({std::int32_t(place.x()), std::int32_t(place.y()), std::int32_t(place.z())});
  }
  std::sort(cells.begin(), cells.end());
  const auto occupied = std::unique(cells.begin(), cells.end()) - cells.begin();
  return cell * std::sqrt(double(occupied) / double(count));
}

Drawing draw_cloud(const PointCloud& cloud, const DrawCloudOptions& options) {
  Painted painted = paint_cloud(cloud, options.color);
  const bool open =
      options.towards_eye.squaredNorm() > 0.0 && options.sheet_normals.size() == cloud.size();
  Drawing drawing;
  DrawnPoints group;
  group.size_px = options.point_px;
  group.size_m =
      options.point_m < 0.0 ? std::min(1.25 * typical_spacing(cloud), 0.05) : options.point_m;
  group.positions.reserve(cloud.size());
  group.colors.reserve(cloud.size());
  std::size_t not_finite = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud.points[i].allFinite()) {
      ++not_finite;
      continue;
    }
    if (open && options.sheet_normals[i].dot(options.towards_eye) < -0.02) continue;
    group.positions.push_back(cloud.points[i]);
    group.colors.push_back(painted.colors[i]);
    drawing.bounds.extend(cloud.points[i]);
  }
  drawing.points.push_back(std::move(group));
  drawing.legend = std::move(painted.legend);
  drawing.legend_title = std::move(painted.legend_title);
  drawing.legend_bar = std::move(painted.bar);
  if (not_finite > 0) {
    drawing.subtitle = fmt::format("{} points without a position left out", not_finite);
  }
  return drawing;
}

PointCloud with_planes(const PointCloud& cloud, const Surfaces& surfaces) {
  if (surfaces.plane_of_point.size() != cloud.size()) {
    fail_data("", "",
              fmt::format("the surfaces belong to {} points, the cloud has {}",
                          surfaces.plane_of_point.size(), cloud.size()));
  }
  PointCloud result = cloud;
  result.set({"plane", surfaces.plane_of_point});
  return result;
}

std::vector<Eigen::Vector3d> sheets_of_surfaces(const Surfaces& surfaces, double least_area) {
  std::vector<Eigen::Vector3d> result(surfaces.plane_of_point.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::int32_t plane = surfaces.plane_of_point[i];
    if (plane < 0) continue;
    const Surface& surface = surfaces.surfaces[std::size_t(plane)];
    if (surface.area.value >= least_area) result[i] = surface.plane.normal;
  }
  return result;
}

std::vector<Eigen::Vector3d> sheets_of_scan(const Scan& scan, const Scene& scene) {
  const std::vector<FaceAddress> faces = all_faces(scene);
  const Eigen::Matrix3d R_sensor_world = scan.T_world_sensor.linear().transpose();
  std::vector<Eigen::Vector3d> normal_of_face(faces.size(), Eigen::Vector3d::Zero());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const ClassId id = scene.instances[std::size_t(faces[f].instance)].class_id;
    const auto name = class_info(id).name;
    if (name == "wall" || name == "floor" || name == "ceiling") {
      normal_of_face[f] = R_sensor_world * world_face(scene, faces[f]).normal;
    }
  }
  std::vector<Eigen::Vector3d> result(scan.truth.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::int32_t face = scan.truth.face[i];
    if (face >= 0 && std::size_t(face) < faces.size())
      result[i] = normal_of_face[std::size_t(face)];
  }
  return result;
}

}  // namespace scanchor
