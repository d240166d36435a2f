#include "tests/eval/support/small_scan.hpp"

#include <algorithm>

namespace scanchor {
namespace {

Instance box_instance(std::int32_t id, const char* name, const Eigen::Vector3d& center,
                      const Eigen::Vector3d& size) {
  Instance instance;
  instance.id = id;
  instance.class_id = *find_class(name);
  instance.kind = name;
  instance.parts = {box_part("body", 0, Eigen::Vector3d::Zero(), size)};
  instance.T_world_instance.translation() = center;
  return instance;
}

}  // namespace

SmallScan small_scan() {
  SmallScan made;
  made.scene.name = "small";
  made.scene.materials.resize(1);
  made.scene.instances = {box_instance(1, "floor", {0, 0, -0.05}, {6, 6, 0.1}),
                          box_instance(2, "desk", {-1, 0, 0.36}, {1.6, 0.8, 0.72}),
                          box_instance(3, "cabinet", {1, 0.5, 0.5}, {0.8, 0.4, 1.0}),
                          box_instance(4, "cup", {-1, 0, 0.76}, {0.08, 0.08, 0.08})};
  Scan& scan = made.scan;
  scan.T_world_sensor.translation() = Eigen::Vector3d(0, -2, 1.5);
  scan.T_world_sensor.linear() =
      Eigen::AngleAxisd(0.5 * 3.14159265358979323846, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  scan.cloud.sensor_poses = {Eigen::Isometry3d::Identity()};
  const auto faces = all_faces(made.scene);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const WorldFace face = world_face(made.scene, faces[f]);
    const Instance& instance = made.scene.instances[static_cast<std::size_t>(faces[f].instance)];
    if (face.normal.dot(scan.T_world_sensor.translation() - face.center) <= 0) continue;
    const Eigen::Vector3d across = face.normal.cross(face.axis);
    const double step = 0.04;
    std::int32_t count = 0;
    for (double s = -0.5 * face.size.x() + 0.5 * step; s < 0.5 * face.size.x(); s += step) {
      for (double t = -0.5 * face.size.y() + 0.5 * step; t < 0.5 * face.size.y(); t += step) {
        const Eigen::Vector3d p = face.center + s * face.axis + t * across;
        scan.cloud.points.push_back(scan.T_world_sensor.inverse() * p);
        scan.truth.class_id.push_back(instance.class_id);
        scan.truth.instance.push_back(instance.id);
        scan.truth.part.push_back(faces[f].part);
        scan.truth.face.push_back(static_cast<std::int32_t>(f));
        scan.truth.runner_up.push_back(-1);
        scan.truth.flags.push_back(0);
        scan.truth.true_range.push_back(static_cast<float>(scan.cloud.points.back().norm()));
        scan.truth.incidence.push_back(0.0F);
        ++count;
      }
    }
    if (count > 0) scan.visibility.push_back({static_cast<std::int32_t>(f), count, 1.0});
  }
  return made;
}

Surfaces true_surfaces(const Scan& scan, const ScanTruth& truth) {
  Surfaces surfaces;
  std::vector<std::size_t> order;
  std::vector<std::vector<std::uint32_t>> inliers(truth.planes.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth.plane[i] >= 0)
      inliers[static_cast<std::size_t>(truth.plane[i])].push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t p = 0; p < inliers.size(); ++p) order.push_back(p);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return inliers[a].size() > inliers[b].size(); });
  surfaces.plane_of_point.assign(truth.size(), -1);
  for (const auto p : order) {
    Surface surface;
    surface.id = static_cast<std::int32_t>(surfaces.surfaces.size());
    surface.inliers = inliers[p];
    surface.plane.normal = truth.planes[p].normal;
    surface.plane.offset = truth.planes[p].offset;
    surface.plane.centroid_sigma = 0.001;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto i : surface.inliers) {
      sum += scan.cloud.points[i];
      surfaces.plane_of_point[i] = surface.id;
    }
    surface.plane.centroid = sum / static_cast<double>(surface.inliers.size());
    surfaces.surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

}  // namespace scanchor
