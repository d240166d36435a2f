// How often "up" is found in rooms of every family that were turned at random, and how sure it is
// when it is wrong.
//   up_bench [ROOMS [SEED]]     default 10 rooms a family from seed 50

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "core/random.hpp"
#include "eval/run.hpp"
#include "perception/perceive.hpp"
#include "reasoning/up.hpp"
#include "scenes/generator.hpp"

namespace scanchor {
namespace {

struct Tally {
  int rooms = 0, right = 0, upside_down = 0;
  double surest_wrong = 0.0;
};

void add(const UpDirection& found, const Eigen::Vector3d& up, Tally& tally) {
  const double c = found.up.dot(up);
  ++tally.rooms;
  if (c > 0.996) {  // 5 degrees
    ++tally.right;
    return;
  }
  if (c < -0.9) ++tally.upside_down;
  tally.surest_wrong = std::max(tally.surest_wrong, found.upright);
}

int run(int rooms, std::uint64_t seed) {
  fmt::print("{:<20} {:>6} {:>6} {:>12} {:>9} {:>13}\n", "family", "rooms", "right", "upside down",
             "sideways", "surest wrong");
  Tally all;
  SequentialRandom random(seed);
  for (const std::string& family : room_families()) {
    Suite suite;
    suite.name = "up";
    suite.scenes = rooms;
    suite.seed = seed;
    suite.families = {{family, 1.0}};
    Tally tally;
    for (const auto& task : scene_tasks(suite)) {
      const MadeScene made = make_scene(task, 1);
      Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
      turn.linear() =
          Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
              .normalized()
              .toRotationMatrix();
      const Scan& scan = made.scans.front();
      PointCloud cloud = scan.cloud;
      for (auto& p : cloud.points) p = turn * p;
      for (auto& pose : cloud.sensor_poses) pose = turn * pose;
      const auto found = find_up(perceive(cloud, PerceiveOptions{}), "auto", 0.05);
      const Eigen::Vector3d up =
          turn.linear() * scan.T_world_sensor.linear().transpose() * Eigen::Vector3d::UnitZ();
      add(found, up, tally);
      add(found, up, all);
    }
    fmt::print("{:<20} {:>6} {:>6} {:>12} {:>9} {:>13.2f}\n", family, tally.rooms, tally.right,
               tally.upside_down, tally.rooms - tally.right - tally.upside_down,
               tally.surest_wrong);
  }
  fmt::print("{:<20} {:>6} {:>6} {:>12} {:>9} {:>13.2f}\n", "all", all.rooms, all.right,
             all.upside_down, all.rooms - all.right - all.upside_down, all.surest_wrong);
  return 0;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  const int rooms = argc > 1 ? std::atoi(argv[1]) : 10;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 50;
  return scanchor::run(rooms, seed);
}
