#include "reasoning/places.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/polygons.hpp"
#include "reasoning/free_space.hpp"

namespace scanchor {
namespace {

constexpr double above_level = 0.015;  // [m] what rises less is the surface itself
constexpr double work_height = 0.5;    // [m] that is to be free above a place
constexpr double robot_height = 1.8;   // [m]
constexpr double step_height = 0.05;   // [m] that a robot drives over
constexpr double standoff = 0.65;      // [m] of its middle, where there is room
constexpr double farthest = 1.5;       // [m]
constexpr double most_margin = 0.5;    // [m]
constexpr double cosine_level = 0.94;

Ring box(double length, double width) {
  const double a = 0.5 * length, b = 0.5 * width;
  return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
}

/// A regular polygon around a circle.
Ring disc(double diameter) {
  constexpr int corners = 16;
  Ring ring;
  const double r = 0.5 * diameter / std::cos(pi / corners);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * pi * (k + 0.5) / corners;
    ring.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return ring;
}

std::vector<Eigen::Vector3d> corners_of(const Surface& surface) {
  const auto& r = surface.rectangle;
  const Eigen::Rotation2Dd turn(r.angle);
  std::vector<Eigen::Vector3d> corners;
  for (const auto& p : box(r.length.value, r.width.value)) {
    const Eigen::Vector2d q = r.center + turn * p;
    corners.push_back(surface.T_cloud_surface * Eigen::Vector3d(q.x(), q.y(), 0.0));
  }
  return corners;
}

/// A level plane to put something on: z up, coordinates in the plane.
struct Level {
  Eigen::Isometry3d T_level_cloud = Eigen::Isometry3d::Identity();
  FreeSpace space;  // seen parts, and what is in the way
  Ring whole;       // with what was not seen; empty: anywhere
};

Ring flat(const Level& level, const Eigen::Isometry3d& T_cloud_surface, const Ring& ring) {
  Ring out;
  for (const auto& p : ring)
    out.push_back(
        (level.T_level_cloud * (T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0))).head<2>());
  return out;
}

void add_seen(Level& level, const Surface& surface) {
  for (const auto& polygon : surface.polygons) {
    level.space.outer.push_back(flat(level, surface.T_cloud_surface, polygon.outer));
    for (const auto& hole : polygon.holes)
      level.space.holes.push_back(flat(level, surface.T_cloud_surface, hole));
  }
}

/// What reaches into the heights between `low` and `high` above the plane; of a slanting face all.
void add_obstacles(Level& level, const Surfaces& surfaces, const std::vector<char>& is_ground,
                   double low, double high) {
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s) {
    if (is_ground[s] != 0) continue;
    double bottom = INFINITY, top = -INFINITY;
    std::vector<Eigen::Vector2d> shadow;
    for (const auto& corner : corners_of(surfaces.surfaces[s])) {
      const Eigen::Vector3d p = level.T_level_cloud * corner;
      bottom = std::min(bottom, p.z());
      top = std::max(top, p.z());
      shadow.push_back(p.head<2>());
    }
    if (top < low || bottom > high) continue;
    Ring hull = convex_hull(std::move(shadow));
    if (hull.size() >= 2) level.space.obstacles.push_back(std::move(hull));
  }
}

Ring bounds(const Ring& ring) {
  Eigen::AlignedBox2d around;
  for (const auto& p : ring) around.extend(p);
  const auto &a = around.min(), &b = around.max();
  return {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
}

/// The largest level face of a thing, or -1.
std::int32_t level_face(const Surfaces& surfaces, const Labelling& labelling, std::int32_t id) {
  std::int32_t best = -1;
  double largest = 0.0;
  const auto look = [&](std::int32_t s) {
    if (s < 0 || static_cast<std::size_t>(s) >= surfaces.surfaces.size()) return;
    const Surface& surface = surfaces.surfaces[static_cast<std::size_t>(s)];
    if (std::abs(surface.plane.normal.dot(labelling.up)) < cosine_level) return;
    if (surface.area.value > largest) largest = surface.area.value, best = s;
  };
  const Entity& entity = labelling.entities[static_cast<std::size_t>(id)];
  if (entity.surfaces.empty()) look(id);
  for (const auto s : entity.surfaces) look(s);
  for (const auto m : entity.members) look(m);
  return best;
}

std::optional<FoundPlace> free_place(const PlaceQuestion& question, const Surfaces& surfaces,
                                     const Labelling& labelling, std::int32_t id) {
  const std::int32_t face = level_face(surfaces, labelling, id);
  if (face < 0) return std::nullopt;
  const Surface& surface = surfaces.surfaces[static_cast<std::size_t>(face)];
  Level level;
  Eigen::Isometry3d T_cloud_level = Eigen::Isometry3d::Identity();
  const auto& r = surface.rectangle;
  const Eigen::Vector3d z =
      surface.plane.normal.dot(labelling.up) < 0.0 ? -surface.plane.normal : surface.plane.normal;
  const Eigen::Vector3d x =
      surface.T_cloud_surface.linear() * Eigen::Vector3d(std::cos(r.angle), std::sin(r.angle), 0.0);
  T_cloud_level.linear().col(0) = x;
  T_cloud_level.linear().col(1) = z.cross(x);
  T_cloud_level.linear().col(2) = z;
  T_cloud_level.translation() =
      surface.T_cloud_surface * Eigen::Vector3d(r.center.x(), r.center.y(), 0.0);
  level.T_level_cloud = T_cloud_level.inverse();
  add_seen(level, surface);
  std::vector<char> is_ground(surfaces.surfaces.size(), 0);
  is_ground[static_cast<std::size_t>(face)] = 1;
  add_obstacles(level, surfaces, is_ground, above_level, work_height);
  level.whole = box(r.length.value, r.width.value);

  FreeSpace anywhere = level.space;
  anywhere.outer = {level.whole};
  anywhere.holes.clear();
  for (const FreeSpace* space : {&level.space, &anywhere}) {
    std::optional<FoundPlace> best;
    for (const bool turned : {false, true}) {
      const double a = turned ? question.width : question.length;
      const double b = turned ? question.length : question.width;
      const auto at = [&](double margin) {
        return nearest_fit(*space, box(a + 2.0 * margin, b + 2.0 * margin), bounds(level.whole),
                           Eigen::Vector2d::Zero());
      };
      auto spot = at(0.0);
      if (!spot) continue;
      double low = 0.0, high = most_margin;
      for (int step = 0; step < 8; ++step) {
        const double middle = 0.5 * (low + high);
        const auto wider = at(middle);
        if (wider) spot = wider;
        (wider ? low : high) = middle;
      }
      if (best && best->margin >= low) continue;
      FoundPlace place;
      place.thing = id;
      place.margin = low;
      place.size = {question.length, question.width};
      Eigen::Isometry3d T_level_place = Eigen::Isometry3d::Identity();
      T_level_place.translation() = Eigen::Vector3d(spot->x(), spot->y(), 0.0);
      if (turned) T_level_place.rotate(Eigen::AngleAxisd(0.5 * pi, Eigen::Vector3d::UnitZ()));
      place.T_cloud_place = T_cloud_level * T_level_place;
      Ring region = box(a, b);
      for (auto& p : region) p += *spot;
      place.unseen = std::clamp(1.0 - area_within(level.space, region) / (a * b), 0.0, 1.0);
      best = place;
    }
    if (best) return best;
  }
  return std::nullopt;
}

/// Surfaces of the floor and of its pieces.
std::vector<char> floor_surfaces(const Surfaces& surfaces, const Labelling& labelling,
                                 const SceneThings& scene) {
  std::vector<char> is_floor(surfaces.surfaces.size(), 0);
  const int floor = scene.ontology().find("floor");
  for (std::size_t s = 0; s < is_floor.size() && floor >= 0; ++s) {
    const int c = scene.ontology().find(labelling.entities[s].label);
    if (c < 0) continue;
    const auto& own = scene.ontology().classes[static_cast<std::size_t>(c)];
    if (c == floor || (!own.part_of.empty() && scene.ontology().find(own.part_of) == floor))
      is_floor[s] = 1;
  }
  return is_floor;
}

std::optional<FoundPlace> standing_place(const PlaceQuestion& question, const Surfaces& surfaces,
                                         const Labelling& labelling, const SceneThings& scene,
                                         const std::vector<char>& is_floor, std::int32_t id) {
  const Eigen::Matrix3d R = levelling(labelling.up);
  // Height of the floor: of its largest surface, below the thing.
  std::int32_t ground = -1;
  for (std::size_t s = 0; s < is_floor.size(); ++s) {
    if (is_floor[s] != 0 &&
        (ground < 0 || surfaces.surfaces[s].area.value >
                           surfaces.surfaces[static_cast<std::size_t>(ground)].area.value))
      ground = static_cast<std::int32_t>(s);
  }
  const Item& thing = scene.item(id);
  // The way that its front looks.
  const Eigen::Vector2d to_sensor = scene.around().viewpoint
                                        ? (*scene.around().viewpoint - thing.center).head<2>()
                                        : Eigen::Vector2d(thing.normal.head<2>());
  Eigen::Vector2d front = Eigen::Vector2d::UnitX();
  double best = -INFINITY;
  const bool upright = !thing.group && std::abs(thing.normal.z()) < 0.5;
  std::vector<Eigen::Vector3d> axes_of_thing = {thing.along, thing.across};
  if (upright) axes_of_thing = {thing.normal};
  for (const Eigen::Vector3d& axis : axes_of_thing) {
    if (axis.head<2>().norm() < 0.5) continue;
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector2d way = sign * axis.head<2>().normalized();
      if (way.dot(to_sensor) > best) best = way.dot(to_sensor), front = way;
    }
  }
  const Eigen::Vector2d side(-front.y(), front.x());
  const auto reach = [&](const Eigen::Vector2d& way) {
    return std::abs(way.dot(thing.along.head<2>())) * thing.half_length +
           std::abs(way.dot(thing.across.head<2>())) * thing.half_width;
  };

  // x towards the thing, origin on the floor below its middle.
  Level level;
  Eigen::Isometry3d T_cloud_level = Eigen::Isometry3d::Identity();
  Eigen::Matrix3d axes;
  axes.col(0) << -front, 0.0;
  axes.col(1) << -side, 0.0;
  axes.col(2) = Eigen::Vector3d::UnitZ();
  const double floor_z = scene.item(ground).z;
  T_cloud_level.linear() = R.transpose() * axes;
  T_cloud_level.translation() =
      R.transpose() * Eigen::Vector3d(thing.center.x(), thing.center.y(), floor_z);
  level.T_level_cloud = T_cloud_level.inverse();
  for (std::size_t s = 0; s < is_floor.size(); ++s) {
    if (is_floor[s] != 0) add_seen(level, surfaces.surfaces[s]);
  }
  add_obstacles(level, surfaces, is_floor, step_height, robot_height);

  const double depth = reach(front);
  const double aside = std::max(0.05, reach(side));
  const Ring window = {
      {-depth - farthest, -aside}, {-depth, -aside}, {-depth, aside}, {-depth - farthest, aside}};
  const Ring robot = disc(question.diameter);
  const Eigen::Vector2d wanted(-depth - std::max(standoff, 0.5 * question.diameter), 0.0);
  FreeSpace anywhere = level.space;
  anywhere.outer.clear();
  anywhere.holes.clear();
  for (const FreeSpace* space : {&level.space, &anywhere}) {
    const auto spot = nearest_fit(*space, robot, window, wanted);
    if (!spot) continue;
    FoundPlace place;
    place.thing = id;
    place.size = {question.diameter, question.diameter};
    place.distance = -spot->x() - depth;
    Eigen::Isometry3d T_level_place = Eigen::Isometry3d::Identity();
    T_level_place.translation() = Eigen::Vector3d(spot->x(), spot->y(), 0.0);
    place.T_cloud_place = T_cloud_level * T_level_place;
    Ring region = robot;
    for (auto& p : region) p += *spot;
    place.unseen = std::clamp(1.0 - area_within(level.space, region) / ring_area(region), 0.0, 1.0);
    return place;
  }
  return std::nullopt;
}

}  // namespace

PlaceAnswer find_places(const PlaceQuestion& question, const Surfaces& surfaces,
                        const Labelling& labelling, const SceneThings& scene) {
  PlaceAnswer result;
  result.question = question;
  result.thing = answer(question.thing, scene);
  result.status = result.thing.status;
  if (result.thing.things.empty()) return result;
  std::vector<char> is_floor;
  const bool stands = question.kind == PlaceQuestion::Kind::standing_place;
  if (stands) {
    is_floor = floor_surfaces(surfaces, labelling, scene);
    if (std::none_of(is_floor.begin(), is_floor.end(), [](char f) { return f != 0; }))
      fail_usage("no floor was found to stand on");
  }
  for (const auto& thing : result.thing.things) {
    const auto place =
        stands ? standing_place(question, surfaces, labelling, scene, is_floor, thing.id)
               : free_place(question, surfaces, labelling, thing.id);
    if (place) result.places.push_back(*place);
  }
  // What was seen comes first; the order of things otherwise.
  std::stable_sort(result.places.begin(), result.places.end(),
                   [](const FoundPlace& a, const FoundPlace& b) {
                     return (a.unseen < 0.01) > (b.unseen < 0.01);
                   });
  if (result.status == Answer::Status::ambiguous) return result;
  result.status = result.places.empty()                 ? Answer::Status::not_found
                  : result.places.front().unseen < 0.01 ? Answer::Status::ok
                                                        : Answer::Status::not_seen;
  return result;
}

}  // namespace scanchor
