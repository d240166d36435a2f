#include "perception/outline_contacts.hpp"

#include <algorithm>

namespace scanchor {

std::vector<char> goes_on_behind(const Surfaces& surfaces, const OutlineSamples& samples,
                                 double gate) {
  const Eigen::Isometry3d& T = samples.T_cloud_plane;
  const Eigen::Vector3d sensor = T * samples.chart.sensor;
  std::vector<char> result(surfaces.surfaces.size(), 0);
  std::vector<char> asked(surfaces.surfaces.size(), 0);
  std::vector<Eigen::Vector2d> inside;
  for (const OutlineSample& s : samples.samples) {
    if (s.kind == SampleKind::inside) inside.push_back(s.plane);
  }
  constexpr double share = 0.02;  // of the surface; less may be points that it claimed wrongly
  const auto enough =
      static_cast<std::size_t>(std::max(3.0, share * static_cast<double>(inside.size())));
  for (const OutlineSample& s : samples.samples) {
    if (s.kind != SampleKind::blocked) continue;
    const std::int32_t other = surfaces.plane_of_point[s.point];
    if (other < 0 || asked[static_cast<std::size_t>(other)]) continue;
    asked[static_cast<std::size_t>(other)] = 1;
    const Plane& plane = surfaces.surfaces[static_cast<std::size_t>(other)].plane;
    const double side = plane.normal.dot(sensor) >= plane.offset ? 1.0 : -1.0;
    // In the frame of this surface: side * (a . x - b) is the height over the other plane.
    const Eigen::Vector3d a = T.linear().transpose() * plane.normal;
    const double b = plane.offset - plane.normal.dot(T.translation());
    std::size_t behind = 0;
    for (std::size_t k = 0; k < inside.size() && behind <= enough; ++k)
      behind += side * (a.x() * inside[k].x() + a.y() * inside[k].y() - b) < -3.0 * gate;
    result[static_cast<std::size_t>(other)] = behind > enough;
  }
  return result;
}

}  // namespace scanchor
