#include "eval/geometry.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

double mean_of(const FixedSum& sum, std::int64_t count) {
  return count > 0 ? sum.value() / static_cast<double>(count) : 0.0;
}

void compare(ErrorStats& stats, const Measured& measured, double truth) {
  stats.add(measured.value - truth);
  if (measured.high <= measured.low && !measured.at_least) return;
  stats.add_interval(measured.low <= truth && (measured.at_least || truth <= measured.high));
}

}  // namespace

void ErrorStats::add(double error) {
  if (!std::isfinite(error)) return;
  const double size = std::abs(error);
  ++count;
  absolute.add(size);
  squared.add(size * size);
  signed_sum.add(error);
  const double place = size > 0 ? std::floor(20.0 * std::log10(size)) : -140.0;
  ++histogram[static_cast<std::int32_t>(std::clamp(place, -140.0, 60.0))];
}

void ErrorStats::add_interval(bool holds) {
  ++with_interval;
  covered += holds ? 1 : 0;
}

void ErrorStats::add(const ErrorStats& other) {
  count += other.count;
  absolute.add(other.absolute);
  squared.add(other.squared);
  signed_sum.add(other.signed_sum);
  for (const auto& [bin, n] : other.histogram) histogram[bin] += n;
  with_interval += other.with_interval;
  covered += other.covered;
}

double ErrorStats::mean() const { return mean_of(absolute, count); }
double ErrorStats::bias() const { return mean_of(signed_sum, count); }
double ErrorStats::rms() const { return std::sqrt(mean_of(squared, count)); }
double ErrorStats::coverage() const {
  return with_interval > 0 ? static_cast<double>(covered) / static_cast<double>(with_interval)
                           : 0.0;
}

double ErrorStats::quantile(double share) const {
  if (count == 0) return 0.0;
  const double wanted = share * static_cast<double>(count);
  std::int64_t below = 0;
  for (const auto& [bin, n] : histogram) {
    below += n;
    if (static_cast<double>(below) >= wanted) return std::pow(10.0, (bin + 1) / 20.0);
  }
  return std::pow(10.0, (histogram.rbegin()->first + 1) / 20.0);
}

void GeometryScore::add(const GeometryScore& other) {
  normal_deg.add(other.normal_deg);
  offset.add(other.offset);
  length.add(other.length);
  width.add(other.width);
  area.add(other.area);
  elevation.add(other.elevation);
  group_center.add(other.group_center);
  group_size.add(other.group_size);
}

GeometryScore score_geometry(const ScanTruth& truth, const PlaneMatch& match,
                             const Surfaces& surfaces, const Scan& scan, const Protocol& protocol) {
  GeometryScore score;
  for (std::size_t t = 0; t < truth.planes.size(); ++t) {
    const PlaneTruth& plane = truth.planes[t];
    const std::int32_t region = t < match.region_of_truth.size() ? match.region_of_truth[t] : -1;
    if (region < 0 || !plane.has_geometry ||
        static_cast<std::size_t>(region) >= surfaces.surfaces.size())
      continue;
    const Surface& surface = surfaces.surfaces[static_cast<std::size_t>(region)];
    const double cosine = std::abs(surface.plane.normal.dot(plane.normal));
    // asin of the cross product keeps its digits where acos of nearly 1 has none.
    const double sine = surface.plane.normal.cross(plane.normal).norm();
    score.normal_deg.add(degrees(std::atan2(sine, cosine)));
    const double off = plane.normal.dot(surface.plane.centroid) - plane.offset;
    score.offset.add(off);
    if (surface.plane.centroid_sigma > 0) {
      score.offset.add_interval(std::abs(off) <=
                                normal_quantile(0.975) * surface.plane.centroid_sigma);
    }
    const Eigen::Vector3d up = scan.T_world_sensor.linear() * plane.normal;
    if (std::abs(up.z()) > 0.999) score.elevation.add(off * (up.z() > 0 ? 1.0 : -1.0));
    if (plane.faces.size() != 1 || plane.visible_fraction < protocol.full_view ||
        surface.polygons.empty())
      continue;
    compare(score.length, surface.rectangle.length, plane.length);
    compare(score.width, surface.rectangle.width, plane.width);
    compare(score.area, surface.area, plane.area);
  }
  return score;
}

void score_groups(const ObjectSummary& summary, const Labelling& labelling, const Scan& scan,
                  const Scene& scene, GeometryScore& score) {
  for (const auto& thing : summary.things) {
    if (thing.claim < 0 || thing.instance < 0) continue;
    const auto entity_id = static_cast<std::size_t>(
        std::max(summary.claims[static_cast<std::size_t>(thing.claim)].instance, 0));
    if (entity_id >= labelling.entities.size() || labelling.entities[entity_id].members.empty())
      continue;
    const Entity& entity = labelling.entities[entity_id];
    for (const auto& instance : scene.instances) {
      if (instance.id != thing.instance) continue;
      Eigen::AlignedBox3d box;
      for (const auto& part : instance.parts) {
        for (const auto& vertex : part.vertices) box.extend(part.T_instance_part * vertex);
      }
      if (box.isEmpty()) continue;
      const Eigen::Vector3d center =
          scan.T_world_sensor.inverse() * (instance.T_world_instance * box.center());
      score.group_center.add((entity.center - center).norm());
      score.group_size.add(entity.size.maxCoeff() - box.sizes().maxCoeff());
    }
  }
}

}  // namespace scanchor
