#pragma once
// Furnishing a room: things are tried where people put them and stay where they fit.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/collide.hpp"
#include "scenes/generator.hpp"
#include "scenes/scene.hpp"
#include "scenes/shell.hpp"

namespace scanchor {

/// A level surface of a thing on which others can be put, in the thing's frame.
struct SupportSurface {
  std::size_t instance = 0;
  std::string part;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector2d half = Eigen::Vector2d::Zero();  ///< [m] along the instance's x and y
  double clearance = 0.0;                          ///< [m] to what is above, at most 2
};

/// One room of a scene in the making. Places are in the world frame.
class Placer {
 public:
  /// `scene` and `random` must outlive the placer. The shell is not added by it.
  Placer(Scene& scene, const RoomShell& room, const RoomOptions& options, SequentialRandom& random);

  /// A thing from the catalogue with a seed of its own, not yet placed.
  Instance make(const std::string& kind, const std::string& variant = "",
                const Parameters& parameters = {});

  /// Puts a thing at a pose if it keeps 1 mm from everything, lies in the room and off the
  /// kept-free zones. Returns its index.
  std::optional<std::size_t> put(Instance instance, const Eigen::Isometry3d& pose,
                                 bool heed_zones = true);
  /// With its back to a wall: `share` of the free length, 0 left .. 1 right as seen from inside.
  /// Yaw gets the options' jitter.
  std::optional<std::size_t> put_at_wall(const Instance& instance, Side side, double share,
                                         double gap = 0.02);
  /// The same at random places, first on the given sides. Keeps `use` [m] in front of it free for
  /// its user.
  std::optional<std::size_t> put_at_some_wall(const Instance& instance,
                                              const std::vector<Side>& sides, double use,
                                              int tries = 12);
  /// Free in the room at a random place and yaw.
  std::optional<std::size_t> put_somewhere(const Instance& instance, int tries = 12,
                                           double wall_gap = 0.05);
  /// On a surface, 3 mm above it if loose; `at` counts from its middle along the axes of its thing.
  /// Nothing where its foot would hang over the edge.
  std::optional<std::size_t> put_on(const SupportSurface& surface, Instance instance,
                                    const Eigen::Vector2d& at, double yaw);
  /// On a surface at a random place with yaw around `yaw`.
  std::optional<std::size_t> put_somewhere_on(const SupportSurface& surface,
                                              const Instance& instance, double yaw, double spread,
                                              int tries = 8);
  /// Hung on a wall, origin of the thing at height z on the wall's plane.
  std::optional<std::size_t> hang(const Instance& instance, Side side, double along, double z);

  /// Surfaces of a thing that can carry others: tops, boards, decks, bodies; lowest first.
  [[nodiscard]] std::vector<SupportSurface> surfaces(std::size_t instance) const;

  /// A rectangle on the floor where nothing may be put (door swings, places to stand).
  void keep_free(const Eigen::Isometry3d& frame, const Eigen::Vector2d& low,
                 const Eigen::Vector2d& high);
  /// A zone in front of a placed thing: its width, `depth` [m] deep.
  void keep_front_free(std::size_t instance, double depth);

  [[nodiscard]] Scene& scene() { return scene_; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const RoomShell& room() const { return room_; }
  [[nodiscard]] SequentialRandom& random() { return random_; }
  [[nodiscard]] const RoomOptions& options() const { return options_; }
  /// Yaw jitter [rad] of furniture at walls.
  double jitter();
  bool fits(const Instance& instance, bool heed_zones) const;

 private:
  struct Solid {
    OrientedBox box;
    Eigen::AlignedBox3d bounds;
  };
  void remember(const Instance& instance);

  Scene& scene_;
  RoomShell room_;
  RoomOptions options_;
  SequentialRandom& random_;
  std::vector<Solid> solids_;
  std::vector<OrientedBox> zones_;
  std::uint64_t made_ = 0;
};

}  // namespace scanchor
