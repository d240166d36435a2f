#pragma once
// What the room families share: a shell with doors and windows, workplaces, clutter, and places to
// scan from.

#include <optional>
#include <string>
#include <vector>

#include "scenes/collide.hpp"
#include "scenes/placer.hpp"

namespace scanchor {

/// A room that is being made: its shell, and where one comes in.
struct RoomPlan {
  RoomShell shell;
  Side door_side =
      Side::south;  ///< of the first door; families are written for a door in the south
  std::vector<Instance> fittings;              ///< doors and windows, placed, without ids
  std::vector<Eigen::Vector2d> entrances;      ///< [m] places on the floor just inside the doors
  std::vector<Eigen::Isometry3d> door_frames;  ///< side frame at the middle of each door
  std::vector<double> door_widths;
  std::vector<Eigen::Isometry3d> window_frames;
  std::vector<double> window_widths;
  /// A side as the family means it, turned to where the door is.
  [[nodiscard]] Side turned(Side side) const {
    return static_cast<Side>((static_cast<int>(side) + static_cast<int>(door_side)) % 4);
  }
  [[nodiscard]] std::vector<Side> turned(std::vector<Side> sides) const {
    for (auto& side : sides) side = turned(side);
    return sides;
  }
};

/// One of several words, all as likely.
std::string one_of(SequentialRandom& random, const std::vector<std::string>& words);
/// A rectangle of the usual sides, scaled by the options, with materials drawn.
RoomPlan plan_room(SequentialRandom& random, const RoomOptions& options,
                   const Eigen::Vector2d& least, const Eigen::Vector2d& most, double height_low,
                   double height_high);
/// A door at `along` [m] (middle) of a side; empty variant: drawn. `outwards`: its leaf turns away
/// from the room.
void add_door(Scene& scene, RoomPlan& plan, SequentialRandom& random, Side side, double along,
              const std::string& variant = "", bool outwards = false);
/// The way in, `inset` [m] from the left or right end of the southern side.
void add_door_near_corner(Scene& scene, RoomPlan& plan, SequentialRandom& random, double inset);
/// As many windows as fit a side evenly, at most `count`.
void add_windows(Scene& scene, RoomPlan& plan, SequentialRandom& random, Side side, int count);
/// Adds shell and fittings to the scene.
void build_plan(Scene& scene, const RoomPlan& plan);
/// Door swings and the way in stay free; radiators come below windows.
void prepare(Placer& placer, const RoomPlan& plan, bool radiators);

/// A desk at a wall (or at a pose) with monitors that face the chair, keyboard, mouse, what lies on
/// desks, and a chair. Returns the desk.
std::optional<std::size_t> workplace(Placer& placer, const std::vector<Side>& sides, int monitors);
/// The same for a desk that has been placed.
void furnish_desk(Placer& placer, std::size_t desk, int monitors);
/// A chair that faces a table from its side -y (0), +x (1), +y (2) or -x (3), `along` [m] off the
/// middle, pushed in or pulled out.
std::optional<std::size_t> chair_at(Placer& placer, std::size_t table, int side, double along,
                                    const std::string& variant = "");

/// Fills surfaces of a thing with loose things of these kinds, `share` of the places.
void load_surfaces(Placer& placer, std::size_t thing, const std::vector<std::string>& kinds,
                   double share);
/// A thing at some wall with `use` [m] of free floor in front of it and loose things of these kinds
/// on it. Nothing where it does not fit.
std::optional<std::size_t> put_loaded(Placer& placer, const Instance& thing,
                                      const std::vector<Side>& sides, double use,
                                      const std::vector<std::string>& kinds, double share);
/// Loose things on the floor.
void litter(Placer& placer, const std::vector<std::string>& kinds, int count);
/// Pictures, whiteboards, televisions on free stretches of wall.
void hang_up(Placer& placer, const std::string& kind, const std::string& variant,
             const std::vector<Side>& sides, double z);
void ceiling_lamps(Placer& placer, int count);

/// Things side by side along a wall, from `start` [m], `gap` [m] apart. Returns their indices; what
/// does not fit is left out.
std::vector<std::size_t> put_in_a_row(Placer& placer, Side side, double start,
                                      const std::vector<Instance>& things, double gap);

// Furnishing: one function a family. False: something essential found no place.
using Furnish = bool (*)(Placer& placer, const RoomPlan& plan);
bool furnish_office(Placer& placer, const RoomPlan& plan);
bool furnish_open_plan(Placer& placer, const RoomPlan& plan);
bool furnish_meeting(Placer& placer, const RoomPlan& plan);
bool furnish_laboratory(Placer& placer, const RoomPlan& plan);
bool furnish_storage(Placer& placer, const RoomPlan& plan);
bool furnish_kitchen(Placer& placer, const RoomPlan& plan);
bool furnish_living(Placer& placer, const RoomPlan& plan);
bool furnish_bedroom(Placer& placer, const RoomPlan& plan);
bool furnish_corridor(Placer& placer, const RoomPlan& plan);

// Shells of the families.
using PlanRoom = RoomPlan (*)(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_office(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_open_plan(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_meeting(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_laboratory(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_storage(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_kitchen(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_living(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_bedroom(Scene& scene, SequentialRandom& random, const RoomOptions& options);
RoomPlan plan_corridor(Scene& scene, SequentialRandom& random, const RoomOptions& options);

/// A corridor with rooms of several families on both sides. False: one of them could not be
/// furnished.
bool build_floor(Scene& scene, SequentialRandom& random, const RoomOptions& options);

/// Whether one can walk from the first entrance to the others and to every chair, and at least 85 %
/// of the free floor is joined.
bool walkable(const Placer& placer, const RoomPlan& plan);
/// Share [0, 1] of the solid angle of a view, 180 degrees wide and 90 degrees high about the unit
/// direction `look`, in which a box is nearer than `range` [m].
double blocked_view(const std::vector<OrientedBox>& boxes, const Eigen::Vector3d& from,
                    const Eigen::Vector2d& look, double range);

/// Two or three places at 1.2 .. 1.5 m over reachable floor that look into the room, the first near
/// the door. Each is the place nearest to the wished one at which hardly anything stands within a
/// metre of the scanner: a door leaf there would take half of the rays.
void add_sensor_poses(Placer& placer, const RoomPlan& plan, int count);

}  // namespace scanchor
