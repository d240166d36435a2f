#include "scenes/collide.hpp"

#include <algorithm>
#include <cmath>

#include "core/polygons.hpp"
#include "scenes/truth.hpp"

namespace scanchor {
namespace {

bool is_shell(const Instance& instance) {
  return instance.kind == "floor" || instance.kind == "wall" || instance.kind == "ceiling";
}

std::string label(const Instance& instance, const Part& part) {
  return instance.kind + " " + std::to_string(instance.id) + " '" + part.name + "'";
}

struct WorldTriangle {
  Eigen::Vector3d p[3];
  Eigen::Vector3d normal;
  Eigen::AlignedBox3d bounds;
  std::int32_t face;
};

}  // namespace

std::vector<OrientedBox> part_boxes(const Instance& instance) {
  std::vector<OrientedBox> boxes;
  for (const auto& part : instance.parts) {
    Eigen::AlignedBox3d bounds;
    for (const auto& vertex : part.vertices) bounds.extend(vertex);
    if (bounds.isEmpty()) continue;
    const Eigen::Isometry3d T = instance.T_world_instance * part.T_instance_part;
    boxes.push_back({T * bounds.center(), T.linear(), 0.5 * bounds.sizes()});
  }
  return boxes;
}

Eigen::AlignedBox3d bounds_of(const OrientedBox& box) {
  const Eigen::Vector3d reach = box.axes.cwiseAbs() * box.half;
  return {box.center - reach, box.center + reach};
}

bool boxes_near(const OrientedBox& a, const OrientedBox& b, double gap) {
  const Eigen::Vector3d d = b.center - a.center;
  const auto separated = [&](const Eigen::Vector3d& axis) {
    double ra = 0.0;
    double rb = 0.0;
    for (int i = 0; i < 3; ++i) {
      ra += a.half[i] * std::abs(axis.dot(a.axes.col(i)));
      rb += b.half[i] * std::abs(axis.dot(b.axes.col(i)));
    }
    return std::abs(axis.dot(d)) >= ra + rb + gap;
  };
  for (int i = 0; i < 3; ++i) {
    if (separated(a.axes.col(i)) || separated(b.axes.col(i))) return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Eigen::Vector3d axis = a.axes.col(i).cross(b.axes.col(j));
      const double length = axis.norm();
      if (length > 1e-6 && separated(axis / length)) return false;
    }
  }
  return true;
}

std::vector<std::string> interpenetrations(const Scene& scene, double tolerance) {
  struct Item {
    std::size_t instance, part;
    OrientedBox box;
    Eigen::AlignedBox3d bounds;
  };
  std::vector<Item> items;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (is_shell(scene.instances[i])) continue;
    const auto boxes = part_boxes(scene.instances[i]);
    for (std::size_t p = 0; p < boxes.size(); ++p)
      items.push_back({i, p, boxes[p], bounds_of(boxes[p])});
  }
  std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    return a.bounds.min().x() < b.bounds.min().x();
  });
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t j = i + 1;
         j < items.size() && items[j].bounds.min().x() < items[i].bounds.max().x(); ++j) {
      const Item& a = items[i];
      const Item& b = items[j];
      if (a.instance == b.instance || !a.bounds.intersects(b.bounds)) continue;
      if (!boxes_near(a.box, b.box, -tolerance)) continue;
      const Instance& first = scene.instances[a.instance];
      const Instance& second = scene.instances[b.instance];
      lines.push_back(label(first, first.parts[a.part]) + " and " +
                      label(second, second.parts[b.part]));
    }
  }
  return lines;
}

std::vector<ClosePair> close_parallel_faces(const Scene& scene, double distance) {
  std::vector<WorldTriangle> triangles;
  std::int32_t first_face = 0;
  for (const auto& instance : scene.instances) {
    for (const auto& part : instance.parts) {
      const Eigen::Isometry3d T = instance.T_world_instance * part.T_instance_part;
      for (std::size_t t = 0; t < part.triangles.size(); ++t) {
        WorldTriangle triangle;
        for (int k = 0; k < 3; ++k) {
          triangle.p[k] = T * part.vertices[static_cast<std::size_t>(part.triangles[t][k])];
          triangle.bounds.extend(triangle.p[k]);
        }
        const Eigen::Vector3d n =
            (triangle.p[1] - triangle.p[0]).cross(triangle.p[2] - triangle.p[0]);
        if (n.norm() < 1e-12) continue;
        triangle.normal = n.normalized();
        triangle.face = first_face + part.triangle_face[t];
        triangles.push_back(triangle);
      }
      first_face += static_cast<std::int32_t>(part.faces.size());
    }
  }
  std::stable_sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
    return a.bounds.min().x() < b.bounds.min().x();
  });
  constexpr double cos_parallel = 0.9999984769132877;  // 0.1 degrees
  std::vector<ClosePair> pairs;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const WorldTriangle& a = triangles[i];
    for (std::size_t j = i + 1;
         j < triangles.size() && triangles[j].bounds.min().x() <= a.bounds.max().x() + distance;
         ++j) {
      const WorldTriangle& b = triangles[j];
      if (a.face == b.face) continue;
      const double c = a.normal.dot(b.normal);
      if (std::abs(c) < cos_parallel) continue;
      const Eigen::Vector3d reach = Eigen::Vector3d::Constant(distance);
      if (!Eigen::AlignedBox3d(a.bounds.min() - reach, a.bounds.max() + reach).intersects(b.bounds))
        continue;
      // The overlap seen along a's normal, and b's height over a's plane at its corners.
      const Eigen::Vector3d u = (a.p[1] - a.p[0]).normalized();
      const Eigen::Vector3d v = a.normal.cross(u);
      const auto flat = [&](const Eigen::Vector3d& p) {
        return Eigen::Vector2d(u.dot(p - a.p[0]), v.dot(p - a.p[0]));
      };
      Ring2 overlap = {flat(b.p[0]), flat(b.p[1]), flat(b.p[2])};
      for (int k = 0; k < 3 && !overlap.empty(); ++k)
        clip(overlap, flat(a.p[k]), flat(a.p[(k + 1) % 3]));
      // Neighbours share an edge: rounding makes slivers of them.
      if (overlap.size() < 3 || std::abs(area_of(overlap)) < 1e-8) continue;
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const auto& q : overlap) {
        const Eigen::Vector3d at = a.p[0] + q.x() * u + q.y() * v;
        const double h = b.normal.dot(b.p[0] - at) / c;
        low = std::min(low, h);
        high = std::max(high, h);
      }
      const double nearest = low <= 0 && high >= 0 ? 0.0 : std::min(std::abs(low), std::abs(high));
      if (nearest >= distance) continue;
      pairs.push_back({std::min(a.face, b.face), std::max(a.face, b.face), nearest, c > 0});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const ClosePair& a, const ClosePair& b) {
    return std::tie(a.face_a, a.face_b, a.distance) < std::tie(b.face_a, b.face_b, b.distance);
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end(),
                          [](const ClosePair& a, const ClosePair& b) {
                            return a.face_a == b.face_a && a.face_b == b.face_b;
                          }),
              pairs.end());
  return pairs;
}

bool FloorGrid::is_free(const Eigen::Vector2d& p) const {
  const int x = static_cast<int>(std::floor((p.x() - low.x()) / cell));
  const int y = static_cast<int>(std::floor((p.y() - low.y()) / cell));
  return inside(x, y) && free[index(x, y)] != 0;
}

bool FloorGrid::is_reachable(const Eigen::Vector2d& p) const {
  const int x = static_cast<int>(std::floor((p.x() - low.x()) / cell));
  const int y = static_cast<int>(std::floor((p.y() - low.y()) / cell));
  return inside(x, y) && reachable[index(x, y)] != 0;
}

bool FloorGrid::reachable_near(const Eigen::Vector2d& p, double distance) const {
  const int reach = static_cast<int>(std::ceil(distance / cell));
  const int cx = static_cast<int>(std::floor((p.x() - low.x()) / cell));
  const int cy = static_cast<int>(std::floor((p.y() - low.y()) / cell));
  for (int y = cy - reach; y <= cy + reach; ++y) {
    for (int x = cx - reach; x <= cx + reach; ++x) {
      if (!inside(x, y) || reachable[index(x, y)] == 0) continue;
      if ((center(x, y) - p).squaredNorm() <= distance * distance) return true;
    }
  }
  return false;
}

double FloorGrid::reachable_share() const {
  const auto free_cells = std::count(free.begin(), free.end(), 1);
  const auto reached = std::count(reachable.begin(), reachable.end(), 1);
  return free_cells == 0 ? 0.0 : static_cast<double>(reached) / static_cast<double>(free_cells);
}

namespace {

/// Takes the cells nearer than `radius` to a box's shadow on the floor out of the free ones. The
/// shadow with its rim is convex: in each row only the ends of the blocked stretch are looked for.
void block(FloorGrid& grid, const OrientedBox& box, const Eigen::AlignedBox3d& bounds,
           double radius) {
  const auto cell_of = [&](double at, double low) {
    return static_cast<int>(std::floor((at - low) / grid.cell));
  };
  const int x0 = std::max(0, cell_of(bounds.min().x() - radius, grid.low.x()));
  const int x1 = std::min(grid.nx - 1, cell_of(bounds.max().x() + radius, grid.low.x()));
  const int y0 = std::max(0, cell_of(bounds.min().y() - radius, grid.low.y()));
  const int y1 = std::min(grid.ny - 1, cell_of(bounds.max().y() + radius, grid.low.y()));
  if (x0 > x1 || y0 > y1) return;
  Ring2 shadow;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                               (corner & 4) != 0 ? 1 : -1);
    shadow.push_back((box.center + box.axes * sign.cwiseProduct(box.half)).head<2>());
  }
  shadow = convex_hull(std::move(shadow));
  const auto blocked = [&](int x, int y) {
    const Eigen::Vector2d p = grid.center(x, y);
    double nearest = std::numeric_limits<double>::infinity();
    bool within = shadow.size() >= 3;
    for (std::size_t i = 0; i < shadow.size(); ++i) {
      const Eigen::Vector2d& a = shadow[i];
      const Eigen::Vector2d d = shadow[(i + 1) % shadow.size()] - a;
      within = within && cross2(d, p - a) >= 0;
      const double t = std::clamp(d.dot(p - a) / std::max(1e-12, d.squaredNorm()), 0.0, 1.0);
      nearest = std::min(nearest, (a + t * d - p).squaredNorm());
    }
    return within || nearest < radius * radius;
  };
  for (int y = y0; y <= y1; ++y) {
    int first = x0;
    while (first <= x1 && !blocked(first, y)) ++first;
    if (first > x1) continue;
    int last = x1;
    while (last > first && !blocked(last, y)) --last;
    std::fill(grid.free.begin() + static_cast<std::ptrdiff_t>(grid.index(first, y)),
              grid.free.begin() + static_cast<std::ptrdiff_t>(grid.index(last, y)) + 1, 0);
  }
}

}  // namespace

FloorGrid walkable_floor(const Scene& scene, const Eigen::AlignedBox2d& room, double radius,
                         const Eigen::Vector2d& start) {
  FloorGrid grid;
  grid.low = room.min();
  grid.nx = static_cast<int>(room.sizes().x() / grid.cell);
  grid.ny = static_cast<int>(room.sizes().y() / grid.cell);
  const auto cells = static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny);
  grid.free.assign(cells, 1);
  grid.reachable.assign(cells, 0);
  for (const auto& instance : scene.instances) {
    if (is_shell(instance) || instance.kind == "door") continue;
    for (const auto& box : part_boxes(instance)) {
      const Eigen::AlignedBox3d bounds = bounds_of(box);
      if (bounds.max().z() >= 0.03 && bounds.min().z() <= 1.9) block(grid, box, bounds, radius);
    }
  }
  // Walls count too.
  for (int y = 0; y < grid.ny; ++y) {
    for (int x = 0; x < grid.nx; ++x) {
      const Eigen::Vector2d p = grid.center(x, y);
      if ((p - room.min()).minCoeff() < radius || (room.max() - p).minCoeff() < radius)
        grid.free[grid.index(x, y)] = 0;
    }
  }
  std::vector<std::pair<int, int>> stack;
  const int sx = static_cast<int>(std::floor((start.x() - grid.low.x()) / grid.cell));
  const int sy = static_cast<int>(std::floor((start.y() - grid.low.y()) / grid.cell));
  if (grid.inside(sx, sy) && grid.free[grid.index(sx, sy)] != 0) {
    grid.reachable[grid.index(sx, sy)] = 1;
    stack.emplace_back(sx, sy);
  }
  while (!stack.empty()) {
    const auto [x, y] = stack.back();
    stack.pop_back();
    for (const auto& [dx, dy] :
         {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
      if (!grid.inside(x + dx, y + dy)) continue;
      const std::size_t i = grid.index(x + dx, y + dy);
      if (grid.free[i] == 0 || grid.reachable[i] != 0) continue;
      grid.reachable[i] = 1;
      stack.emplace_back(x + dx, y + dy);
    }
  }
  return grid;
}

}  // namespace scanchor
