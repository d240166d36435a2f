#include "results/figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/file.hpp"
#include "core/math.hpp"
#include "perception/alpha_shape.hpp"
#include "perception/perceive.hpp"
#include "results/draw_svg.hpp"
#include "results/paint.hpp"
#include "results/pictures.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/generator.hpp"
#include "scenes/shell.hpp"
#include "sensors/tilting_lidar.hpp"
#include "sim/settle.hpp"

namespace scanchor {
namespace {

constexpr std::uint64_t seed = 7;

Eigen::Isometry3d pose_at(double x, double y, double z, double yaw_deg) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(Eigen::Vector3d(x, y, z));
  T.rotate(Eigen::AngleAxisd(radians(yaw_deg), Eigen::Vector3d::UnitZ()));
  return T;
}

void put(Scene& scene, const FurnitureRequest& request, const Eigen::Isometry3d& T_world_thing) {
  Instance thing = make_furniture(scene, request);
  thing.id = next_id(scene);
  thing.T_world_instance = T_world_thing;
  scene.instances.push_back(std::move(thing));
}

/// A desk with two monitors at the back wall of an otherwise empty room.
Scene monitor_scene() {
  Scene scene;
  scene.name = "two monitors";
  add_plain_room(scene, {4.0, 3.4, 2.6});
  put(scene, {"desk", "four legs", seed, {{"width", 1.6}, {"depth", 0.8}, {"height", 0.72}}, 0.0},
      pose_at(2.0, 2.9, 0.0, 0.0));
  for (const double side : {-1.0, 1.0}) {
    put(scene, {"monitor", "", seed, {{"diagonal_inch", 24.0}}, 0.0},
        pose_at(2.0 + 0.36 * side, 3.0, 0.725, -12.0 * side));
  }
  scene.sensor_poses.push_back(pose_at(2.0, 1.1, 1.25, 90.0));
  return scene;
}

Scene shelf_scene() {
  Scene scene;
  scene.name = "shelf";
  add_plain_room(scene, {4.0, 3.4, 2.6});
  put(scene, {"shelf", "", seed, {{"boards", 5.0}}, 0.0}, pose_at(2.0, 3.15, 0.0, 0.0));
  scene.sensor_poses.push_back(pose_at(2.0, 1.0, 1.2, 90.0));
  return scene;
}

Scan scan_of(const Scene& scene, double sigma) {
  LidarOptions lidar = lidar_preset("paper");
  lidar.range_sigma = sigma;
  return scan_room(World(scene), scene.sensor_poses.at(0), lidar, seed);
}

/// The part of the cloud around a thing, a hand's breadth wider than the thing itself.
PointCloud around(const PointCloud& cloud, const Eigen::AlignedBox3d& box) {
  PointCloud part;
  for (const Eigen::Vector3d& p : cloud.points) {
    if (box.contains(p)) part.points.push_back(p);
  }
  return part;
}

Scene office_scene() {
  RoomOptions options;
  Scene scene = generate_room(options, seed);
  settle(scene, {});
  return scene;
}

Surface const* monitor_like(const Surfaces& surfaces, std::size_t skip) {
  for (const Surface& surface : surfaces.surfaces) {
    const bool upright = std::abs(surface.plane.normal.z()) < 0.3;
    const double e = surface.rectangle.length.value;
    if (!upright || e < 0.35 || e > 0.8 || surface.rectangle.width.value < 0.2) continue;
    if (skip-- == 0) return &surface;
  }
  return nullptr;
}

/// Points of the desk's top, in its plane: the monitors' feet throw shadows on it, so its shape has
/// bays.
std::vector<Eigen::Vector2d> sample_points(const Surfaces& surfaces, const PointCloud& cloud) {
  std::vector<Eigen::Vector2d> points;
  for (const Surface& surface : surfaces.surfaces) {
    const double e = surface.rectangle.length.value;
    if (std::abs(surface.plane.normal.z()) < 0.9 || e < 1.3 || e > 1.9) continue;
    const Eigen::Isometry3d T = surface.T_cloud_surface.inverse();
    const SinCos turn = portable_sincos(-surface.rectangle.angle);
    for (const std::uint32_t i : surface.inliers) {
      const Eigen::Vector2d p = (T * cloud.points[i]).head<2>();
      points.emplace_back(turn.cos * p.x() - turn.sin * p.y(), turn.sin * p.x() + turn.cos * p.y());
    }
    break;
  }
  return points;
}

}  // namespace

Figure figure_shelf() {
  const Scene scene = shelf_scene();
  const Scan scan = scan_of(scene, 0.005);
  PointCloud world;
  for (const Eigen::Vector3d& p : scan.cloud.points)
    world.points.push_back(scan.T_world_sensor * p);
  const PointCloud part =
      around(world, {Eigen::Vector3d(0.9, 2.3, -0.02), Eigen::Vector3d(3.1, 3.6, 2.5)});
  PictureOptions options;
  options.azimuth_deg = -108.0;
  options.elevation_deg = 14.0;
  options.title = "A shelf, scanned";
  Figure figure;
  figure.name = "figure-1-shelf";
  figure.caption = fmt::format(
      "The cloud of a shelf with five boards, {} points of a simulated tilting LIDAR with 5 mm "
      "range "
      "noise (paper, Fig. 1).",
      part.size());
  figure.image = picture_of_cloud(part, options, CloudColor::height);
  return figure;
}

Figure figure_alpha_shape() {
  const Scan scan = scan_of(monitor_scene(), 0.005);
  const Surfaces surfaces = perceive(scan.cloud, {});
  const std::vector<Eigen::Vector2d> points = sample_points(surfaces, scan.cloud);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : points) box.extend(p);
  VectorPicture picture{1280, 300, {}};
  const double panel = 300.0;
  const double scale = box.isEmpty() ? 1.0 : panel / std::max(box.sizes().maxCoeff(), 1e-6);
  const Triangulation triangulation = delaunay(points);
  const double spacing = median_spacing(points, triangulation);
  const auto at = [&](const Eigen::Vector2d& p, double left) {
    return Eigen::Vector2d(left + scale * (p.x() - box.center().x()) + panel / 2,
                           170.0 - scale * (p.y() - box.center().y()));
  };
  const std::vector<std::pair<std::string, double>> steps = {
      {"points", 0.0}, {"α too small", 1.5 * spacing}, {"α fits", 4.0 * spacing}, {"α → ∞", 1e3}};
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const double left = 10.0 + 318.0 * double(s);
    const auto& [name, radius] = steps[s];
    std::string title = name;
    if (s == 1 || s == 2) title += fmt::format(" ({:.0f} mm)", 1e3 * radius);
    picture.text(left + panel / 2, 30.0, title, 15.0, ink, TextAnchor::middle, FontWeight::bold);
    if (radius > 0.0) {
      for (const Polygon& polygon : alpha_shape(points, triangulation, radius)) {
        VectorShape shape;
        std::vector<Ring> rings = {polygon.outer};
        rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
        for (const Ring& ring : rings) {
          Path path;
          for (const Eigen::Vector2d& p : ring) path.push_back(at(p, left));
          shape.paths.push_back(std::move(path));
        }
        shape.fill = with_alpha(palette(0), 50);
        shape.stroke = palette(0);
        shape.width = 1.6;
        picture.items.emplace_back(std::move(shape));
      }
    }
    for (const Eigen::Vector2d& p : points)
      picture.disc(at(p, left), 1.3, s == 0 ? ink : faint_ink);
  }
  Figure figure;
  figure.name = "figure-3-alpha-shape";
  figure.caption = fmt::format(
      "{} points of a desk top and their alpha shape for three radii: with one near the spacing of "
      "the "
      "points ({:.0f} mm) it falls apart, with an infinite one it is the convex hull (paper, Fig. "
      "3).",
      points.size(), 1e3 * spacing);
  figure.vector = picture;
  figure.image = to_image(picture);
  return figure;
}

Figure figure_office_cloud() {
  const Scene scene = office_scene();
  const Scan scan = scan_of(scene, 0.01);
  PictureOptions options;
  options.title = "An office, scanned";
  Figure figure;
  figure.name = "figure-5-office-cloud";
  figure.caption = fmt::format(
      "A generated office, {} points in one sweep of 180 by 90 degrees with 1 cm range noise; near "
      "walls and the ceiling are left out (paper, Fig. 5).",
      scan.cloud.size());
  figure.image = picture_of_scan(scene, scan, options, CloudColor::height);
  return figure;
}

Figure figure_office_planes() {
  const Scene scene = office_scene();
  const Scan scan = scan_of(scene, 0.01);
  const Surfaces surfaces = perceive(scan.cloud, {});
  DrawSurfacesOptions how;
  how.rectangles = false;
  how.towards_eye = scan.T_world_sensor.linear().transpose() * towards_eye(-122.0, 42.0);
  Drawing drawing = draw_surfaces(surfaces, how);
  drawing.move(scan.T_world_sensor);
  drawing.title = "Its planar surfaces";
  const RenderOptions options;
  const View view = framed_view(drawing, options);
  Figure figure;
  figure.name = "figure-6-office-planes";
  figure.caption = fmt::format(
      "The {} planar surfaces found in the cloud of Fig. 5, each with its polygon; outlines that "
      "border "
      "a shadow in vermilion (paper, Fig. 6).",
      surfaces.surfaces.size());
  figure.image = render(drawing, view, options);
  figure.vector = draw_outlines(drawing, view, options);
  return figure;
}

Figure figure_monitors() {
  const Scan scan = scan_of(monitor_scene(), 0.005);
  const Surfaces surfaces = perceive(scan.cloud, {});
  Surfaces monitors;
  PointCloud points;
  for (std::size_t k = 0; k < 2; ++k) {
    const Surface* found = monitor_like(surfaces, k);
    if (found == nullptr) break;
    monitors.surfaces.push_back(*found);
    for (const std::uint32_t i : found->inliers) points.points.push_back(scan.cloud.points[i]);
  }
  DrawSurfacesOptions how;
  how.features = true;
  Drawing drawing = draw_surfaces(monitors, how);
  DrawCloudOptions dots;
  dots.color = CloudColor::plain;
  dots.point_m = 0.0;
  drawing.add(draw_cloud(points, dots));
  drawing.move(scan.T_world_sensor);
  drawing.title = "Two monitors: polygon, rectangle, A, E and R";
  const RenderOptions options;
  const View view = framed_view(drawing, options, ViewKind::perspective, -90.0, 18.0);
  Figure figure;
  figure.name = "figure-7-monitors";
  figure.caption =
      "Two monitors of 24 inches: the polygon of the points, the fitted rectangle (dashed) with "
      "its 95 % "
      "interval (thin), and the paper's A, E and R (paper, Fig. 7).";
  figure.image = render(drawing, view, options);
  figure.vector = draw_outlines(drawing, view, options);
  return figure;
}

std::vector<std::filesystem::path> write_figures(const std::filesystem::path& folder) {
  make_folder(folder);
  std::vector<std::filesystem::path> files;
  for (Figure (*make)() : {figure_shelf, figure_alpha_shape, figure_office_cloud,
                           figure_office_planes, figure_monitors}) {
    const Figure figure = make();
    files.push_back(folder / (figure.name + ".png"));
    write_png(files.back(), figure.image);
    if (!figure.vector.items.empty()) {
      files.push_back(folder / (figure.name + ".svg"));
      write_svg(files.back(), figure.vector);
    }
    files.push_back(folder / (figure.name + ".txt"));
    write_file(files.back(), figure.caption + "\n");
  }
  return files;
}

}  // namespace scanchor
