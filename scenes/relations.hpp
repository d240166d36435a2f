#pragma once
// The exact relations of a scene, with their margins: what a reasoner should find if it measured
// without error. Definitions and tolerances: the crisp limits of the likelihoods in the reasoner's
// own documentation (docs/reference/classes.md lists both).

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/collide.hpp"
#include "scenes/scene.hpp"

namespace scanchor {

enum class SpatialRelation {
  parallel,
  orthogonal,
  above,
  below,
  on,
  supports,
  inside,
  near,
  same_size,
  vertically_aligned,
  coplanar,
  left_of,
  right_of,
  in_front_of,
  behind,
};
inline constexpr std::size_t relation_count = 15;

/// "parallel", "same size", "left of", ... and back.
std::string_view relation_name(SpatialRelation relation);
std::optional<SpatialRelation> find_relation(std::string_view name);
/// a R b exactly if b R a.
bool is_symmetric(SpatialRelation relation);
/// The relation that b has to a where a has this one to b: itself for symmetric ones.
SpatialRelation inverse(SpatialRelation relation);
/// left, right, in front, behind: need a viewpoint.
bool needs_viewpoint(SpatialRelation relation);

struct RelationTolerances {
  double angle_deg = 5.0;            ///< parallel, orthogonal, coplanar
  double above_gap = 0.05;           ///< [m] a may reach this far below the top of b
  double overlap = 0.3;              ///< share of a's footprint over b
  double footprint_dilation = 0.05;  ///< [m] of b for above and inside
  double upright_footprint = 0.03;   ///< [m] half thickness given to the footprint of upright faces
  double on_low = -0.03;             ///< [m] gap between a's lowest point and the face of b
  double on_high = 0.15;             ///< [m]
  double inside_share = 0.8;         ///< of a's box within b's dilated box
  double near = 0.5;                 ///< [m] gap
  double same_length = 1.15;         ///< ratio of the longer sides
  double same_area = 1.25;           ///< ratio of the areas
  double aligned = 0.15;             ///< horizontal distance of centres / shorter extension
  double stacked = 0.05;             ///< [m] least difference in height of what is aligned
  double elongated = 1.3;  ///< sides' ratio from which long axes must be parallel to be aligned
  double coplanar = 0.03;  ///< [m] of the smaller one's centre from the larger one's plane
  double cone_deg = 45.0;  ///< half angle of left, right, front, behind
};

/// Something that relations hold between: a planar face or a whole thing, made for the tolerances
/// that it is then related with.
struct RelationBody {
  std::vector<OrientedBox> boxes;          ///< its parts, or the flat box of a face
  std::vector<Eigen::Vector2d> footprint;  ///< convex, counter-clockwise
  double z_low = 0.0;                      ///< [m]
  double z_high = 0.0;
  Eigen::Vector3d center =
      Eigen::Vector3d::Zero();  ///< of the face, or of the thing's bounding box
  WorldFace face;               ///< the face itself, or the thing's largest planar face
  bool has_face = false;
  /// For `on`, within angle_deg: planar faces of a thing that look up; a face itself either way, as
  /// a scan of a thin board sees one of its sides.
  std::vector<WorldFace> level_faces;
  // What every pair asks for, worked out once:
  std::vector<std::vector<Eigen::Vector2d>>
      level_shadows;  ///< of the level faces' rectangles, dilated by footprint_dilation
  std::vector<Eigen::Vector2d> grown;  ///< the footprint, dilated by footprint_dilation
  Eigen::AlignedBox3d bounds;          ///< of the boxes
};
RelationBody face_body(const Scene& scene, const FaceAddress& address,
                       const RelationTolerances& tolerances = {});
RelationBody instance_body(const Scene& scene, std::size_t instance,
                           const RelationTolerances& tolerances = {});

/// How clearly a relation holds: `margin` is (tolerance - deviation) / tolerance of its tightest
/// condition: 1 perfect, 0 on the border, negative where it does not hold. `value` is the tightest
/// condition's own number in its unit ([deg], [m], ratio, share).
struct RelationMargin {
  double margin = -1.0;
  double value = 0.0;
  [[nodiscard]] bool holds() const { return margin >= 0.0; }
};
/// a relation b. `viewpoint` is used by the four that need one. `on` and `supports` look at the
/// pair only; whether b is the top-most that could carry a is decided in the lists below. Margins
/// of at least `least` are exact; what cannot reach it may come back with any margin below it.
RelationMargin relate(const RelationBody& a, const RelationBody& b, SpatialRelation relation,
                      const Eigen::Vector3d& viewpoint, const RelationTolerances& tolerances = {},
                      double least = -std::numeric_limits<double>::infinity());

/// One relation that holds, or misses by less than a wanted margin.
struct RelationFact {
  SpatialRelation relation;
  std::int32_t a, b;  ///< indices: into all_faces, or into Scene::instances
  RelationMargin value;
};

struct RelationQuery {
  RelationTolerances tolerances;
  double least_margin = 0.0;  ///< list facts with at least this margin; -0.2 adds near misses
  double least_area = 0.05;   ///< [m2] faces below are left out
  std::vector<SpatialRelation> relations;  ///< empty: all
  std::optional<Eigen::Vector3d>
      viewpoint;  ///< else the first sensor pose, else the middle of the bounds
};

/// Facts between planar faces, in order (a, b, relation). Symmetric facts are listed once, with a <
/// b.
std::vector<RelationFact> face_relations(const Scene& scene, const RelationQuery& query = {});
/// Facts between things (floor, walls and ceiling too).
std::vector<RelationFact> instance_relations(const Scene& scene, const RelationQuery& query = {});

/// Planar faces that a scan sees as one plane: same side, within `distance` [m] and `angle_deg` of
/// one plane, and within `gap` [m] of each other (two doors of a cabinet, the deck boards of a
/// pallet). Returns a group number a face of all_faces; curved faces get -1.
std::vector<std::int32_t> coplanar_groups(const Scene& scene, double gap = 0.05,
                                          double distance = 0.003, double angle_deg = 0.5);

/// truth.json: all faces in the world frame with their exact values, and the relations of both
/// kinds. docs/reference/scene-format.md, "Truth".
nlohmann::ordered_json truth_to_json(const Scene& scene, const RelationQuery& query = {});

}  // namespace scanchor
