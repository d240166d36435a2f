#include "eval/blame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "eval/region_surfaces.hpp"
#include "eval/truth.hpp"

namespace scanchor {
namespace {

// A frame with z along the normal, origin at the centroid.
Eigen::Isometry3d frame_of(const Eigen::Vector3d& normal, const Eigen::Vector3d& axis,
                           const Eigen::Vector3d& origin) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  Eigen::Vector3d x = axis - normal * normal.dot(axis);
  if (x.norm() < 1e-9) x = normal.unitOrthogonal();
  x.normalize();
  T.linear() << x, normal.cross(x), normal;
  T.translation() = origin;
  return T;
}

// Which plane of the truth each surface is, by any of its points: surfaces of the truth's own
// regions hold points of one plane only.
std::vector<std::int32_t> planes_of_surfaces(const Surfaces& surfaces, const ScanTruth& truth) {
  std::vector<std::int32_t> planes;
  for (const auto& surface : surfaces.surfaces)
    planes.push_back(truth.plane[surface.inliers.front()]);
  return planes;
}

Measured exactly(double value) { return {value, value, value, false}; }

double metric_or_zero(const Score& score, const Protocol& protocol, const std::string& name) {
  for (const auto& [known, value] : metrics(score, protocol)) {
    if (known == name) return value;
  }
  return 0.0;
}

std::string fixed(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", 100.0 * value);
  return text;
}

}  // namespace

std::string stage_word(PerfectUpTo stage) {
  switch (stage) {
    case PerfectUpTo::nothing:
      return "pipeline";
    case PerfectUpTo::scan:
      return "perfect scan";
    case PerfectUpTo::planes:
      return "perfect planes";
    case PerfectUpTo::shapes:
      return "perfect shapes";
    case PerfectUpTo::labels:
      break;
  }
  return "perfect labels";
}

Scan perfect_scan(const Scan& scan) {
  Scan perfect = scan;
  for (std::size_t i = 0; i < scan.truth.true_range.size() && i < scan.cloud.size(); ++i) {
    const double range = scan.cloud.points[i].norm();
    const double wanted = static_cast<double>(scan.truth.true_range[i]);
    const bool elsewhere = i < scan.truth.flags.size() &&
                           (scan.truth.flags[i] & (point_ghost | point_out_of_range)) != 0;
    if (elsewhere || !(range > 0) || !(wanted > 0) || !std::isfinite(range)) continue;
    perfect.cloud.points[i] = scan.cloud.points[i] * (wanted / range);
  }
  return perfect;
}

Surfaces perfect_planes(const Scan& scan, const ScanTruth& truth, const Protocol& protocol) {
  return surfaces_of_regions(scan.cloud, PerceiveOptions{}, [&](const PointCloud&, double) {
    std::vector<std::int32_t> regions = truth.plane;
    for (auto& plane : regions) {
      if (plane < 0) continue;
      const PlaneTruth& there = truth.planes[static_cast<std::size_t>(plane)];
      const bool curved = !there.has_geometry && there.ignored;
      if (there.points < protocol.plane_min_points || curved) plane = -1;
    }
    return regions;
  });
}

Surfaces perfect_shapes(const Scan& scan, const Scene& scene, const ScanTruth& truth,
                        const Protocol& protocol) {
  Surfaces surfaces = perfect_planes(scan, truth, protocol);
  const auto plane_of_surface = planes_of_surfaces(surfaces, truth);
  const auto addresses = all_faces(scene);
  const Eigen::Isometry3d T_cloud_world = scan.T_world_sensor.inverse();
  for (auto& surface : surfaces.surfaces) {
    const PlaneTruth& plane = truth.planes[static_cast<std::size_t>(
        plane_of_surface[static_cast<std::size_t>(surface.id)])];
    if (!plane.has_geometry) continue;
    // The frame of the largest face; the rectangles of all faces give the outline.
    WorldFace largest{};
    std::vector<WorldFace> faces;
    for (const auto id : plane.faces) {
      faces.push_back(world_face(scene, addresses[static_cast<std::size_t>(id)]));
      if (faces.size() == 1 || faces.back().area > largest.area) largest = faces.back();
    }
    Eigen::Vector3d normal = plane.normal;
    if (normal.dot(-surface.plane.centroid) < 0) normal = -normal;
    surface.plane.normal = normal;
    const Eigen::Vector3d center = T_cloud_world * largest.center;
    surface.plane.centroid = center;
    surface.plane.offset = normal.dot(center);
    surface.T_cloud_surface = frame_of(normal, T_cloud_world.linear() * largest.axis, center);
    surface.polygons.clear();
    Eigen::AlignedBox2d box;
    double area = 0;
    for (const auto& face : faces) {
      const Eigen::Vector3d across = face.normal.cross(face.axis);
      Polygon polygon;
      for (const auto& [s, t] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        const Eigen::Vector3d corner =
            face.center + s * face.size.x() * face.axis + t * face.size.y() * across;
        const Eigen::Vector3d local = surface.T_cloud_surface.inverse() * (T_cloud_world * corner);
        polygon.outer.emplace_back(local.head<2>());
        box.extend(polygon.outer.back());
      }
      const auto& r = polygon.outer;
      const double turn =
          (r[1] - r[0]).x() * (r[2] - r[1]).y() - (r[1] - r[0]).y() * (r[2] - r[1]).x();
      if (turn < 0) std::reverse(polygon.outer.begin(), polygon.outer.end());
      polygon.outer_kind.assign(4, EdgeKind::true_edge);
      surface.polygons.push_back(std::move(polygon));
      area += face.area;
    }
    std::stable_sort(surface.polygons.begin(), surface.polygons.end(),
                     [](const Polygon& a, const Polygon& b) { return a.area() > b.area(); });
    const Eigen::Vector2d size = box.sizes();
    const bool along_x = size.x() >= size.y();
    surface.rectangle.center = box.center();
    surface.rectangle.angle = along_x ? 0.0 : 0.5 * 3.14159265358979323846;
    surface.rectangle.length = exactly(size.maxCoeff());
    surface.rectangle.width = exactly(size.minCoeff());
    surface.area = exactly(area);
    surface.rectangularness = std::min(1.0, area / std::max(size.x() * size.y(), 1e-12));
    surface.is_rectangle = surface.rectangularness > 0.8;
    const double ratio = size.minCoeff() / std::max(size.maxCoeff(), 1e-12);
    surface.eccentricity = std::sqrt(std::max(0.0, 1.0 - ratio * ratio));
    surface.occluded_outline = 0.0;
    surface.confidence = 1.0;
  }
  return surfaces;
}

BlameResult blame(const Suite& suite, const PerceiveOptions& perceive_options,
                  const Ontology& ontology, const ReasonOptions& reason_options,
                  const RunOptions& options) {
  const auto tasks = tasks_of(suite, options);
  if (tasks.empty())
    throw Error(ExitCode::nothing_measured,
                "suite " + suite.name + " has no scene in part '" + options.split + "'");
  const Method method = own_method(perceive_options, ontology, reason_options);
  constexpr PerfectUpTo stages[] = {PerfectUpTo::nothing, PerfectUpTo::scan, PerfectUpTo::planes,
                                    PerfectUpTo::shapes, PerfectUpTo::labels};
  std::vector<std::vector<Score>> scores(tasks.size(), std::vector<Score>(std::size(stages)));
  const ThreadLimit limit(options.threads);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_blocks(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const MadeScene made = make_scene(tasks[t], suite.scans);
      for (const Scan& scan : made.scans) {
        const Scan clean = perfect_scan(scan);
        const ScanTruth truth = truth_of(clean, &made.scene, options.protocol);
        for (std::size_t s = 0; s < std::size(stages); ++s) {
          ScanAnswer answer;
          answer.described = method.described;
          MethodAnswer said;
          if (stages[s] == PerfectUpTo::nothing) said = method.answer(scan, tasks[t].name);
          if (stages[s] == PerfectUpTo::scan) said = method.answer(clean, tasks[t].name);
          if (stages[s] == PerfectUpTo::planes) {
            said.surfaces = perfect_planes(clean, truth, options.protocol);
            find_shapes(clean.cloud, perceive_options, *said.surfaces);
          }
          if (stages[s] == PerfectUpTo::shapes)
            said.surfaces = perfect_shapes(clean, made.scene, truth, options.protocol);
          if (stages[s] == PerfectUpTo::labels) {
            answer.points = perfect_prediction(truth);
          } else {
            if (!said.labelling) {
              said.labelling = reason(*said.surfaces, ontology, reason_options);
              said.points = predict_points(*said.surfaces, *said.labelling);
            }
            answer.points = std::move(said.points);
            answer.surfaces = &*said.surfaces;
            answer.labelling = &*said.labelling;
          }
          scores[t][s].add(score_scan(stages[s] == PerfectUpTo::nothing ? scan : clean, &made.scene,
                                      answer, options.protocol));
        }
      }
      const std::lock_guard lock(mutex);
      ++done;
      if (options.progress) options.progress(done, tasks.size());
    }
  });
  BlameResult result;
  result.protocol = options.protocol;
  result.data = data_stamp(suite, options.split);
  for (std::size_t s = 0; s < std::size(stages); ++s) {
    BlameRow row;
    row.perfect = stages[s];
    for (const auto& scene : scores) row.score.add(scene[s]);
    result.rows.push_back(std::move(row));
  }
  return result;
}

std::vector<std::pair<std::string, double>> BlameResult::losses(const std::string& metric) const {
  constexpr const char* names[] = {"sensor", "planes", "shapes", "reasoning"};
  std::vector<std::pair<std::string, double>> list;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    list.emplace_back(names[i - 1], metric_or_zero(rows[i].score, protocol, metric) -
                                        metric_or_zero(rows[i - 1].score, protocol, metric));
  }
  if (!rows.empty())
    list.emplace_back("limit", 1.0 - metric_or_zero(rows.back().score, protocol, metric));
  return list;
}

std::string blame_to_markdown(const BlameResult& result, const std::vector<std::string>& names) {
  std::string text = "| truth put in |";
  std::string rule = "| --- |";
  for (const auto& name : names) text += " " + name + " |", rule += " ---: |";
  text += "\n" + rule + "\n";
  for (const auto& row : result.rows) {
    text += "| " + stage_word(row.perfect) + " |";
    for (const auto& name : names)
      text += " " + fixed(metric_or_zero(row.score, result.protocol, name)) + " |";
    text += "\n";
  }
  for (std::size_t stage = 0; stage < 5 && !names.empty(); ++stage) {
    const auto first = result.losses(names.front());
    if (stage >= first.size()) break;
    text += "| loss: " + first[stage].first + " |";
    for (const auto& name : names) text += " " + fixed(result.losses(name)[stage].second) + " |";
    text += "\n";
  }
  return text;
}

}  // namespace scanchor
