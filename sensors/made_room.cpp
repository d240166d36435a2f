#include "sensors/made_room.hpp"

#include <fmt/format.h>

#include <chrono>

#include "core/error.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

// A room that does not come to rest holds a thing that rolls or a stack that falls; the next one
// seldom does.
constexpr int most_rests = 5;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

MadeRoom make_room(const SceneTask& task, RoomTimes* times) {
  MadeRoom room;
  for (int rest = 0; rest < most_rests; ++rest) {
    const auto start = std::chrono::steady_clock::now();
    GeneratedRoom made = furnish_room(task.room, task.seed, room.tries);
    const double generated = seconds_since(start);
    room.tries = made.tries;
    room.complete = made.complete;
    room.scene = std::move(made.scene);
    if (room.scene.sensor_poses.empty()) {
      fail_data(fmt::format("scene {}", task.name), "", "has no place to scan from",
                "choose another seed, a larger room.size_scale or less room.clutter");
    }
    SettleReport report = settle(room.scene, task.settle);
    room.settled = report.settled;
    room.problems = std::move(report.problems);
    if (times != nullptr) {
      times->generate += generated;
      times->settle += seconds_since(start) - generated;
    }
    if (room.settled) break;
  }
  if (!room.complete) {
    room.problems.push_back(fmt::format("lacks something essential after {} tries", room.tries));
  }
  return room;
}

std::uint64_t scan_seed(const SceneTask& task, int k) {
  return stream_seed(task.seed, "scan", static_cast<std::uint64_t>(k));
}

const Eigen::Isometry3d& scan_pose(const Scene& scene, int k) {
  return scene.sensor_poses[static_cast<std::size_t>(k) % scene.sensor_poses.size()];
}

}  // namespace scanchor
