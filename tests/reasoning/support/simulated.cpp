#include "tests/reasoning/support/simulated.hpp"

#include <map>

#include "core/random.hpp"
#include "perception/perceive.hpp"
#include "scenes/generator.hpp"
#include "sensors/tilting_lidar.hpp"
#include "sim/settle.hpp"
#include "sim/world.hpp"

namespace scanchor::test {

SimulatedRoom simulated_room(const std::string& family, std::uint64_t seed, double range_sigma) {
  RoomOptions room;
  room.family = family;
  Scene scene = generate_room(room, seed);
  settle(scene, {});
  LidarOptions lidar;
  lidar.range_sigma = range_sigma;
  const World world(scene);
  const Scan scan = scan_room(world, scene.sensor_poses.at(0), lidar, stream_seed(seed, "scan", 0));
  SimulatedRoom result;
  PerceiveOptions options;
  options.noise_sigma = range_sigma;
  result.surfaces = perceive(scan.cloud, options);
  for (const auto& surface : result.surfaces.surfaces) {
    std::map<std::int32_t, std::size_t> classes;
    std::map<std::int32_t, std::size_t> instances;
    for (const auto p : surface.inliers) {
      ++classes[scan.truth.class_id[p]];
      ++instances[scan.truth.instance[p]];
    }
    const auto most = [](const std::map<std::int32_t, std::size_t>& counts) {
      std::pair<std::int32_t, std::size_t> best{-1, 0};
      for (const auto& [id, n] : counts) {
        if (n > best.second) best = {id, n};
      }
      return best;
    };
    const auto best = most(classes);
    const bool clear = 5 * best.second >= 3 * surface.inliers.size() && best.first > 0;
    result.classes.emplace_back(clear ? class_info(best.first).name : "");
    result.instances.push_back(most(instances).first);
    result.points.push_back(surface.inliers.size());
  }
  return result;
}

}  // namespace scanchor::test
