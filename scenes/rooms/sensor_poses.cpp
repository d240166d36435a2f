// Where a person would put the scanner: in the room, near the door or a corner, nothing in front of
// it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/collide.hpp"
#include "scenes/pose.hpp"
#include "scenes/rooms/rooms.hpp"

namespace scanchor {
namespace {

constexpr double clear_range = 1.0;     // [m] what is nearer fills the view
constexpr double clear_share = 0.04;    // of the view may be filled so
constexpr double search_radius = 2.0;   // [m] from the wished place
constexpr int cells_between = 3;        // places that are tried lie 15 cm apart
constexpr double scanner_radius = 0.3;  // [m] with its stand

/// Distance along a ray at which it enters a box [m]; infinite: it does not.
double entry(const OrientedBox& box, const Eigen::Vector3d& from, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d p = box.axes.transpose() * (from - box.center);
  const Eigen::Vector3d d = box.axes.transpose() * ray;
  double near = 0.0;
  double far = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    if (std::abs(d[i]) < 1e-12) {
      if (std::abs(p[i]) > box.half[i]) return std::numeric_limits<double>::infinity();
      continue;
    }
    const double a = (-box.half[i] - p[i]) / d[i];
    const double b = (box.half[i] - p[i]) / d[i];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  return near <= far ? near : std::numeric_limits<double>::infinity();
}

}  // namespace

double blocked_view(const std::vector<OrientedBox>& boxes, const Eigen::Vector3d& from,
                    const Eigen::Vector2d& look, double range) {
  const OrientedBox reach{from, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Constant(range)};
  std::vector<const OrientedBox*> close;
  for (const auto& box : boxes) {
    if (boxes_near(reach, box, 0.0)) close.push_back(&box);
  }
  // 24 x 9 directions, turned from one to the next by constants: libm's sines differ between
  // machines, and a place must not.
  constexpr double cos_turn = 0.99144486137381038;  // 7.5 degrees
  constexpr double sin_turn = 0.13052619222005157;
  constexpr double cos_half = 0.99785892323860348;  // 3.75 degrees
  constexpr double sin_half = 0.06540312923014306;
  constexpr double cos_tilt = 0.98480775301220802;  // 10 degrees
  constexpr double sin_tilt = 0.17364817766693033;
  constexpr double cos_most = 0.76604444311897801;  // 40 degrees
  constexpr double sin_most = 0.64278760968653936;
  double blocked = 0.0;
  double total = 0.0;
  double level = cos_most;
  double rise = -sin_most;
  for (int v = 0; v < 9; ++v) {
    // Half a step in from the right end of the view.
    Eigen::Vector2d flat = cos_half * Eigen::Vector2d(look.y(), -look.x()) + sin_half * look;
    for (int u = 0; u < 24; ++u) {
      const Eigen::Vector3d ray(level * flat.x(), level * flat.y(), rise);
      const bool hit = std::any_of(close.begin(), close.end(), [&](const OrientedBox* box) {
        return entry(*box, from, ray) < range;
      });
      total += level;
      if (hit) blocked += level;
      flat = Eigen::Vector2d(cos_turn * flat.x() - sin_turn * flat.y(),
                             sin_turn * flat.x() + cos_turn * flat.y());
    }
    const double next = cos_tilt * level - sin_tilt * rise;
    rise = sin_tilt * level + cos_tilt * rise;
    level = next;
  }
  return blocked / total;
}

void add_sensor_poses(Placer& placer, const RoomPlan& plan, int count) {
  auto& random = placer.random();
  Scene& scene = placer.scene();
  const Eigen::AlignedBox2d room(plan.shell.low, plan.shell.high);
  const FloorGrid grid = walkable_floor(scene, room, scanner_radius, plan.entrances.front());
  const Eigen::Vector2d middle = room.center();
  // The first near the door, the others near corners.
  std::vector<Eigen::Vector2d> wishes = {plan.entrances.front()};
  for (int corner = 0; corner < 4; ++corner) {
    const Eigen::Vector2d c((corner & 1) != 0 ? room.max().x() - 0.7 : room.min().x() + 0.7,
                            (corner & 2) != 0 ? room.max().y() - 0.7 : room.min().y() + 0.7);
    if ((c - wishes[0]).norm() > 1.5) wishes.push_back(c);
  }
  std::vector<OrientedBox> boxes;
  for (const auto& instance : scene.instances) {
    for (const auto& box : part_boxes(instance)) boxes.push_back(box);
  }
  const bool joined = grid.reachable_share() > 0;
  int added = 0;
  for (const auto& wish : wishes) {
    if (added >= count) break;
    const double height = to_mm(random.uniform(1.2, 1.5));
    const Eigen::Vector2d target =
        middle + Eigen::Vector2d(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4));
    struct Spot {
      double distance;
      Eigen::Vector2d p;
    };
    std::vector<Spot> places;
    for (int y = 0; y < grid.ny; y += cells_between) {
      for (int x = 0; x < grid.nx; x += cells_between) {
        if (grid.free[grid.index(x, y)] == 0) continue;
        if (joined && grid.reachable[grid.index(x, y)] == 0) continue;
        const Eigen::Vector2d p = grid.center(x, y);
        const double distance = (p - wish).norm();
        // A door is no obstacle to walking, and its leaf may hang behind the scanner's back.
        const OrientedBox body{{p.x(), p.y(), 1.3}, Eigen::Matrix3d::Identity(), {0.3, 0.3, 0.4}};
        if (distance > search_radius || (target - p).norm() < 0.2) continue;
        const bool touched = std::any_of(boxes.begin(), boxes.end(), [&](const OrientedBox& box) {
          return boxes_near(body, box, 0.0);
        });
        if (!touched) places.push_back({distance, p});
      }
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Spot& a, const Spot& b) { return a.distance < b.distance; });
    // The nearest place with a clear view; else the clearest of all.
    double best = std::numeric_limits<double>::infinity();
    const Spot* chosen = nullptr;
    for (const auto& place : places) {
      const double blocked = blocked_view(boxes, {place.p.x(), place.p.y(), height},
                                          (target - place.p).normalized(), clear_range);
      if (blocked >= best) continue;
      best = blocked;
      chosen = &place;
      if (blocked <= clear_share) break;
    }
    if (chosen == nullptr) continue;
    const Eigen::Vector2d x = (target - chosen->p).normalized();
    Eigen::Isometry3d pose = pose_at({to_mm(chosen->p.x()), to_mm(chosen->p.y()), height});
    pose.linear().col(0) = Eigen::Vector3d(x.x(), x.y(), 0);
    pose.linear().col(1) = Eigen::Vector3d(-x.y(), x.x(), 0);
    scene.sensor_poses.push_back(pose);
    ++added;
  }
}

}  // namespace scanchor
