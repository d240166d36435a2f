// Shapes in generated rooms at 1 cm of noise: what planes, shapes and both together cost on one
// core and how much faster two are, how far sizes are off the exact truth, whether the 95 %
// intervals hold it, and whether an edge that is called true is where the thing ends.
//   room_shapes_bench [ROOMS [SEED [FAMILY [FILE]]]]     default 12 office rooms from seed 50
// FILE: one line a surface, for looking into what went wrong.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <optional>
#include <vector>

#include "core/math.hpp"
#include "core/parallel.hpp"
#include "eval/planes.hpp"
#include "eval/region_surfaces.hpp"
#include "eval/run.hpp"
#include "eval/truth.hpp"
#include "perception/perceive.hpp"

namespace scanchor {
namespace {

constexpr int repeats = 5;      // of each timing; the best counts, for others use the machine too
constexpr double whole = 0.9;   // of a face was seen: sizes are compared
constexpr double clean = 0.99;  // of a face was seen: areas are without excuse

double seconds_of(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Lap {
  double cpu = 1e9, wall = 1e9;
};

Lap best_lap(int threads, const std::function<void()>& work) {
  const ThreadLimit limit(threads);
  Lap best;
  for (int i = 0; i < repeats; ++i) {
    const double wall = seconds_of(CLOCK_MONOTONIC), cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    work();
    best.wall = std::min(best.wall, seconds_of(CLOCK_MONOTONIC) - wall);
    best.cpu = std::min(best.cpu, seconds_of(CLOCK_PROCESS_CPUTIME_ID) - cpu);
  }
  return best;
}

double median(std::vector<double> values, double share = 0.5) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(
      values.size() - 1,
      static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5))];
}

/// Errors of one size over many surfaces.
struct Errors {
  std::vector<double> error;
  int held = 0, with = 0, lower_bounds = 0;
  void add(const Measured& m, double truth, double scale = 1.0) {
    error.push_back((m.value - truth) / scale);
    if (m.at_least) ++lower_bounds;
    ++with;
    if (m.low <= truth && (m.at_least || truth <= m.high)) ++held;
  }
  void print(const std::string& name, const char* unit, double factor) const {
    std::vector<double> size;
    double bias = 0.0;
    for (const double e : error) {
      size.push_back(std::abs(e));
      bias += e / static_cast<double>(error.size());
    }
    fmt::print(
        "  {:24} {:5}  median {:6.2f} {}  95 % {:7.2f}  bias {:+6.2f} (median {:+6.2f})  "
        "interval holds {:.3f}, 'at least' {:.2f}\n",
        name, error.size(), factor * median(size), unit, factor * median(size, 0.95), factor * bias,
        factor * median(error), with > 0 ? double(held) / with : 0.0,
        with > 0 ? double(lower_bounds) / with : 0.0);
  }
};

/// A plane of the truth as triangles in the frame of the cloud.
struct TruePlane {
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  [[nodiscard]] bool holds(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
      for (std::size_t k = 0; k < 3; ++k) {
        if ((t[(k + 1) % 3] - t[k]).cross(p - t[k]).dot(normal) < 0.0) return false;
      }
      return true;
    });
  }
};

std::vector<TruePlane> true_planes(const Scene& scene, const Scan& scan, const ScanTruth& truth) {
  const auto faces = all_faces(scene);
  std::vector<TruePlane> planes(truth.planes.size());
  const Eigen::Isometry3d T_sensor_world = scan.T_world_sensor.inverse();
  for (std::size_t p = 0; p < planes.size(); ++p) {
    for (const std::int32_t f : truth.planes[p].faces) {
      const FaceAddress& a = faces[static_cast<std::size_t>(f)];
      const Instance& instance = scene.instances[static_cast<std::size_t>(a.instance)];
      const Part& part = instance.parts[static_cast<std::size_t>(a.part)];
      const Eigen::Isometry3d T = T_sensor_world * instance.T_world_instance * part.T_instance_part;
      for (std::size_t t = 0; t < part.triangles.size(); ++t) {
        if (part.triangle_face[t] != a.face) continue;
        const Eigen::Vector3i& v = part.triangles[t];
        planes[p].triangles.push_back({T * part.vertices[static_cast<std::size_t>(v.x())],
                                       T * part.vertices[static_cast<std::size_t>(v.y())],
                                       T * part.vertices[static_cast<std::size_t>(v.z())]});
      }
    }
  }
  return planes;
}

/// Metres of outline by what is claimed and what is so.
struct EdgeTable {
  // Rows: true_edge, occlusion, view_limit, unknown; columns: ends here, goes on, beyond the end.
  std::array<std::array<double, 3>, 4> length{};
  void add(const Surface& surface, const PlaneTruth& plane, const TruePlane& faces,
           double spacing) {
    constexpr double step = 0.02;
    for (const Polygon& polygon : surface.polygons) {
      const std::size_t n = polygon.outer.size();
      for (std::size_t i = 0; i < n && polygon.outer_kind.size() == n; ++i) {
        const Eigen::Vector2d from = polygon.outer[i], along = polygon.outer[(i + 1) % n] - from;
        const double whole_length = along.norm();
        if (whole_length == 0.0) continue;
        const int pieces = std::max(1, static_cast<int>(whole_length / step));
        const Eigen::Vector2d out(along.y() / whole_length, -along.x() / whole_length);
        for (int k = 0; k < pieces; ++k) {
          const Eigen::Vector2d p = from + along * ((k + 0.5) / pieces);
          const auto place = [&](const Eigen::Vector2d& q) -> Eigen::Vector3d {
            const Eigen::Vector3d x = surface.T_cloud_surface * Eigen::Vector3d(q.x(), q.y(), 0.0);
            return x - (plane.normal.dot(x) - plane.offset) * plane.normal;
          };
          // The rays' own resolution here: what lies within 1.5 spacings is the same place.
          const Eigen::Vector3d x = place(p);
          const double cosine = std::max(0.05, std::abs(plane.normal.dot(x)) / x.norm());
          const double reach = std::max(0.015, 1.5 * spacing * x.norm() / cosine);
          const bool inside = faces.holds(place(p - reach * out), plane.normal);
          const bool outside = !faces.holds(place(p + reach * out), plane.normal);
          const std::size_t so = outside ? (inside ? 0 : 2) : 1;
          length[static_cast<std::size_t>(polygon.outer_kind[i])][so] += whole_length / pieces;
        }
      }
    }
  }
  void print() const {
    fmt::print("  metres of outline          the thing ends here   goes on   ended before\n");
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& row = length[k];
      const double sum = row[0] + row[1] + row[2];
      if (sum == 0.0) continue;
      fmt::print("  {:24} {:9.1f} ({:.2f})  {:7.1f} ({:.2f})  {:6.1f} ({:.2f})\n",
                 edge_kind_name(static_cast<EdgeKind>(k)), row[0], row[0] / sum, row[1],
                 row[1] / sum, row[2], row[2] / sum);
    }
  }
};

/// Everything that is held against the truth, for one source of planes.
struct Result {
  Errors length, width, area, length_all, width_all, area_all;  // seen whole; all matched
  Errors monitor, clean_area;
  EdgeTable edges;
  int rectangles = 0, faces = 0;

  void print(const std::string& title) const {
    fmt::print("{}\n", title);
    length.print("longer side", "mm", 1e3);
    width.print("shorter side", "mm", 1e3);
    area.print("area, of the true", "%", 1e2);
    monitor.print("monitor, both sides", "mm", 1e3);
    clean_area.print("clean rectangle, area", "%", 1e2);
    length_all.print("longer side, any view", "mm", 1e3);
    width_all.print("shorter side, any view", "mm", 1e3);
    area_all.print("area, any view", "%", 1e2);
    edges.print();
  }
};

struct Case {
  const Scan& scan;
  const Scene& scene;
  const ScanTruth& truth;
  const std::vector<TruePlane>& faces;
  std::string name;
};

void compare(const Case& c, const char* source, const Surfaces& surfaces, Result& result,
             std::ofstream* list) {
  PlaneMatch match;
  score_planes(c.truth.plane, c.truth.ignored_planes, surfaces.plane_of_point, Protocol{}, &match);
  const auto addresses = all_faces(c.scene);
  const double spacing =
      std::sqrt(radians(180.0) * radians(90.0) / static_cast<double>(c.scan.beams_fired));
  for (std::size_t t = 0; t < c.truth.planes.size(); ++t) {
    const PlaneTruth& plane = c.truth.planes[t];
    const std::int32_t region = match.region_of_truth[t];
    if (region < 0 || !plane.has_geometry || plane.ignored) continue;
    const Surface& s = surfaces.surfaces[static_cast<std::size_t>(region)];
    if (s.polygons.empty()) continue;
    result.edges.add(s, plane, c.faces[t], spacing);
    if (plane.faces.size() != 1 || plane.width <= 0.0) continue;
    const FaceAddress& a = addresses[static_cast<std::size_t>(plane.faces.front())];
    const Instance& instance = c.scene.instances[static_cast<std::size_t>(a.instance)];
    const Part& part = instance.parts[static_cast<std::size_t>(a.part)];
    const bool is_rectangle = plane.area > 0.98 * plane.length * plane.width;
    result.length_all.add(s.rectangle.length, plane.length);
    result.width_all.add(s.rectangle.width, plane.width);
    result.area_all.add(s.area, plane.area, plane.area);
    if (plane.visible_fraction >= whole) {
      if (is_rectangle) {
        result.length.add(s.rectangle.length, plane.length);
        result.width.add(s.rectangle.width, plane.width);
      }
      result.area.add(s.area, plane.area, plane.area);
      if (class_info(plane.class_id).name == "monitor" && is_rectangle && plane.width > 0.15) {
        result.monitor.add(s.rectangle.length, plane.length);
        result.monitor.add(s.rectangle.width, plane.width);
      }
    }
    if (plane.visible_fraction >= clean && is_rectangle)
      result.clean_area.add(s.area, plane.area, plane.area);
    if (list == nullptr) continue;
    const Eigen::Vector3d middle = s.plane.centroid;
    const double cosine = std::abs(s.plane.normal.dot(middle)) / middle.norm();
    *list << fmt::format(
        "{},{},{},{},{},{},{:.3f},{:.4f},{:.4f},{:.5f},{:.4f},{:.4f},{:.4f},{},{:.4f},{:.4f},{:.4f}"
        ","
        "{},{:.5f},{:.5f},{:.5f},{},{:.2f},{:.3f},{:.2f},{},{:.3f}\n",
        c.name, source, region, class_info(plane.class_id).name, part.name,
        part.faces[static_cast<std::size_t>(a.face)].name, plane.visible_fraction, plane.length,
        plane.width, plane.area, s.rectangle.length.value, s.rectangle.length.low,
        s.rectangle.length.high, int(s.rectangle.length.at_least), s.rectangle.width.value,
        s.rectangle.width.low, s.rectangle.width.high, int(s.rectangle.width.at_least),
        s.area.value, s.area.low, s.area.high, int(s.area.at_least), middle.norm(), cosine,
        s.rectangularness, s.inlier_count, s.occluded_outline);
  }
}

int run(int rooms, std::uint64_t seed, const std::string& family, const char* file) {
  Suite suite;
  suite.name = "demo";
  suite.scenes = rooms;
  suite.seed = seed;
  suite.families = {{family, 1.0}};
  std::optional<std::ofstream> list;
  if (file != nullptr) {
    list.emplace(file);
    *list << "room,planes,surface,class,part,face,visible,tl,tw,ta,l,ll,lh,lal,w,wl,wh,wal,a,al,ah,"
             "aal,range,cosine,R,points,hidden\n";
  }
  const PerceiveOptions options;
  Result found, given;
  std::vector<double> planes_cpu, shapes_cpu, both_cpu, count;
  double planes_speedup = 0.0, shapes_speedup = 0.0, both_speedup = 0.0;
  for (const auto& task : scene_tasks(suite)) {
    const MadeScene made = make_scene(task, 1);
    const Scan& scan = made.scans.front();
    const ScanTruth truth = truth_of(scan, &made.scene, Protocol{});
    const auto faces = true_planes(made.scene, scan, truth);
    const Case c{scan, made.scene, truth, faces, task.name};

    Surfaces surfaces;
    const auto plane = [&] { surfaces = find_planes(scan.cloud, options); };
    const Lap planes_one = best_lap(1, plane), planes_two = best_lap(2, plane);
    const auto shape = [&] { find_shapes(scan.cloud, options, surfaces); };
    const Lap shapes_one = best_lap(1, shape), shapes_two = best_lap(2, shape);
    planes_cpu.push_back(1e3 * planes_one.cpu);
    shapes_cpu.push_back(1e3 * shapes_one.cpu);
    both_cpu.push_back(planes_cpu.back() + shapes_cpu.back());
    planes_speedup += planes_one.wall / planes_two.wall / rooms;
    shapes_speedup += shapes_one.wall / shapes_two.wall / rooms;
    both_speedup +=
        (planes_one.wall + shapes_one.wall) / (planes_two.wall + shapes_two.wall) / rooms;
    count.push_back(static_cast<double>(surfaces.surfaces.size()));
    compare(c, "found", surfaces, found, list ? &*list : nullptr);

    Surfaces exact = surfaces_of_regions(scan.cloud, options,
                                         [&](const PointCloud&, double) { return truth.plane; });
    find_shapes(scan.cloud, options, exact);
    compare(c, "given", exact, given, list ? &*list : nullptr);
  }
  fmt::print(
      "{} rooms ({}, seed {}), median of {:.0f} surfaces, CPU on one core: planes {:.1f} ms, "
      "shapes {:.1f} ms, both {:.1f} ms (most {:.1f}); on two cores {:.2f}, {:.2f} and {:.2f} "
      "times "
      "faster by the clock\n",
      rooms, family, seed, median(count), median(planes_cpu), median(shapes_cpu), median(both_cpu),
      median(both_cpu, 1.0), planes_speedup, shapes_speedup, both_speedup);
  found.print("Planes as found");
  given.print("Planes of the truth (points by their face): what shapes alone get wrong");
  return 0;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  const int rooms = argc > 1 ? std::atoi(argv[1]) : 12;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 50;
  if (rooms <= 0) {
    fmt::print(stderr, "room_shapes_bench [ROOMS [SEED [FAMILY [FILE]]]]\n");
    return 2;
  }
  return scanchor::run(rooms, seed, argc > 3 ? argv[3] : "office", argc > 4 ? argv[4] : nullptr);
}
