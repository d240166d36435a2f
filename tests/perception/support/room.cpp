#include "tests/perception/support/room.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include "core/math.hpp"
#include "core/random.hpp"

namespace scanchor::support {
namespace {

Box box_at(const Eigen::Vector3d& center, const Eigen::Vector3d& size, double yaw_deg = 0.0) {
  Box box;
  box.half = 0.5 * size;
  box.T_world_box =
      Eigen::Translation3d(center) * Eigen::AngleAxisd(radians(yaw_deg), Eigen::Vector3d::UnitZ());
  return box;
}

// A box given in the frame of a piece of furniture.
void place(std::vector<Box>& boxes, const Eigen::Isometry3d& T_world_thing,
           const Eigen::Vector3d& center, const Eigen::Vector3d& size, double yaw_deg = 0.0) {
  Box box = box_at(center, size, yaw_deg);
  box.T_world_box = T_world_thing * box.T_world_box;
  boxes.push_back(box);
}

Eigen::Isometry3d standing_at(double x, double y, double yaw_deg) {
  return Eigen::Translation3d(x, y, 0.0) *
         Eigen::AngleAxisd(radians(yaw_deg), Eigen::Vector3d::UnitZ());
}

}  // namespace

std::vector<Box> reference_room(std::uint64_t seed) {
  SequentialRandom random(stream_seed(seed, "test room"));
  const bool moved = seed != 0;
  const auto jitter = [&](double by) { return moved ? random.uniform(-by, by) : 0.0; };
  const auto scale = [&](double value) { return moved ? value * random.uniform(0.9, 1.1) : value; };
  std::vector<Box> boxes;
  Box walls = box_at({3.0, 2.5, 1.4}, {6.0, 5.0, 2.8});
  walls.inside = true;
  boxes.push_back(walls);

  const auto desk = standing_at(4.6 + jitter(0.3), 1.2 + jitter(0.3), 90.0 + jitter(15.0));
  const double wide = scale(1.6), deep = scale(0.8), high = 0.75;
  place(boxes, desk, {0, 0, high - 0.0125}, {wide, deep, 0.025});
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      place(boxes, desk, {sx * (0.5 * wide - 0.05), sy * (0.5 * deep - 0.05), 0.5 * (high - 0.025)},
            {0.05, 0.05, high - 0.025});
    }
  }
  for (const double side : {-1.0, 1.0}) {
    place(boxes, desk, {side * 0.35, -0.15, high + 0.10 + 0.21}, {0.57, 0.04, 0.42},
          side * 8.0 - 1.0 + jitter(4.0));
    place(boxes, desk, {side * 0.35, -0.13, high + 0.05}, {0.05, 0.05, 0.10});
  }

  const auto shelf = standing_at(2.6 + jitter(0.4), 4.75, jitter(3.0));
  const double shelf_width = scale(1.16), shelf_high = 1.9;
  for (int board = 0; board < 5; ++board) {
    place(boxes, shelf, {0, 0, 0.1 + 0.4 * board}, {shelf_width, 0.35, 0.02});
  }
  for (const double side : {-1.0, 1.0}) {
    place(boxes, shelf, {side * 0.5 * (shelf_width + 0.02), 0, 0.5 * shelf_high},
          {0.02, 0.35, shelf_high});
  }

  const auto cabinet = standing_at(5.0 + jitter(0.2), 4.3 + jitter(0.1), jitter(5.0));
  place(boxes, cabinet, {0, 0, 0.5}, {1.2, 0.45, 1.0});

  const auto chair = standing_at(3.3 + jitter(0.4), 1.9 + jitter(0.4), 23.0 + jitter(40.0));
  place(boxes, chair, {0, 0, 0.45}, {0.42, 0.42, 0.04});
  place(boxes, chair, {0, 0.19, 0.75}, {0.42, 0.03, 0.45});
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0})
      place(boxes, chair, {sx * 0.18, sy * 0.18, 0.215}, {0.04, 0.04, 0.43});
  }

  // Clutter: four boxes on the floor, two on the desk, two on the cabinet, nine in the shelf.
  const auto size = [&] {
    return Eigen::Vector3d(random.uniform(0.12, 0.35), random.uniform(0.12, 0.3),
                           random.uniform(0.1, 0.35));
  };
  const auto stand = [&](const Eigen::Isometry3d& on, double x, double y, double z,
                         const Eigen::Vector3d& s) {
    place(boxes, on, {x, y, z + 0.5 * s.z()}, s, random.uniform(-45.0, 45.0));
  };
  const auto floor = standing_at(0, 0, 0);
  stand(floor, 2.2 + jitter(0.2), 3.3 + jitter(0.3), 0, size());
  stand(floor, 3.9 + jitter(0.2), 3.2 + jitter(0.3), 0, size());
  stand(floor, 1.7 + jitter(0.2), 0.8 + jitter(0.3), 0, size());
  stand(floor, 2.6 + jitter(0.2), 0.5 + jitter(0.2), 0, size());
  stand(desk, -0.55, 0.22, high, 0.7 * size());
  stand(desk, 0.1, 0.25, high, 0.7 * size());
  stand(cabinet, -0.3, 0, 1.0, size());
  stand(cabinet, 0.3, 0, 1.0, size());
  for (int i = 0; i < 9; ++i) {
    const Eigen::Vector3d s = size().cwiseMin(Eigen::Vector3d(0.3, 0.25, 0.3));
    place(boxes, shelf,
          {(i % 3 - 1) * 0.36 + jitter(0.03), -0.02, 0.11 + 0.4 * (i / 3) + 0.5 * s.z()}, s,
          random.uniform(-15.0, 15.0));
  }
  return boxes;
}

RoomScan scan_boxes(const std::vector<Box>& boxes, const RayGrid& grid) {
  RoomScan scan;
  const CounterRandom noise(stream_seed(grid.seed, "range"));
  struct Local {
    Eigen::Vector3d origin;
    Eigen::Matrix3d rotation;
  };
  std::vector<Local> locals;
  for (const auto& box : boxes) {
    const Eigen::Isometry3d inverse = box.T_world_box.inverse();
    locals.push_back({inverse * grid.position, inverse.linear()});
  }
  for (int line = 0; line < grid.lines; ++line) {
    const double tilt =
        radians(grid.tilt_deg + grid.vertical_deg * ((line + 0.5) / grid.lines - 0.5));
    for (int beam = 0; beam < grid.beams; ++beam) {
      const double bearing = radians(grid.horizontal_deg * ((beam + 0.5) / grid.beams - 0.5));
      // A line scanner on a tilt unit: the line's own plane is tilted about the y axis.
      const Eigen::Vector3d direction(std::cos(bearing) * std::cos(tilt), std::sin(bearing),
                                      std::cos(bearing) * std::sin(tilt));
      double nearest = std::numeric_limits<double>::infinity(), cosine = 0.0;
      std::int32_t plane = -1;
      for (std::size_t b = 0; b < boxes.size(); ++b) {
        const Eigen::Vector3d o = locals[b].origin, d = locals[b].rotation * direction;
        double enter = -1e30, leave = 1e30;
        int enter_axis = 0, leave_axis = 0;
        for (int axis = 0; axis < 3; ++axis) {
          double t0 = (-boxes[b].half[axis] - o[axis]) / d[axis],
                 t1 = (boxes[b].half[axis] - o[axis]) / d[axis];
          if (t0 > t1) std::swap(t0, t1);
          if (t0 > enter) enter = t0, enter_axis = axis;
          if (t1 < leave) leave = t1, leave_axis = axis;
        }
        if (enter > leave || leave <= 0.0) continue;
        const bool in = boxes[b].inside;
        const double t = in ? leave : enter;
        const int axis = in ? leave_axis : enter_axis;
        if (t <= 0.0 || t >= nearest) continue;
        nearest = t;
        cosine = std::abs(d[axis]);
        const bool high = in == (d[axis] > 0.0);
        plane = static_cast<std::int32_t>(6 * b) + 2 * axis + (high ? 1 : 0);
      }
      if (plane < 0) continue;
      const double range =
          nearest + grid.range_sigma * noise.normal(static_cast<std::uint64_t>(line),
                                                    static_cast<std::uint32_t>(beam));
      scan.cloud.points.push_back(grid.position + range * direction);
      scan.plane.push_back(plane);
      scan.incidence_cos.push_back(cosine);
    }
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = grid.position;
  scan.cloud.sensor_poses.push_back(pose);
  return scan;
}

RoomScan shuffled(const RoomScan& scan, std::uint64_t seed) {
  std::vector<std::uint32_t> order(scan.plane.size());
  std::iota(order.begin(), order.end(), 0U);
  SequentialRandom random(seed);
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  }
  RoomScan out;
  out.cloud.sensor_poses = scan.cloud.sensor_poses;
  for (const auto i : order) {
    out.cloud.points.push_back(scan.cloud.points[i]);
    out.plane.push_back(scan.plane[i]);
    out.incidence_cos.push_back(scan.incidence_cos[i]);
  }
  return out;
}

}  // namespace scanchor::support
