#pragma once
// What reasoning says of the surfaces: a label for each thing, how sure, and why.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace scanchor {

/// One clause of a proof, with what was measured; recursive through `because` down to an axiom.
struct ProofClause {
  std::string text;         ///< the clause in the words of the class file: "parallel to a floor"
  double likelihood = 0.0;  ///< [0, 1] of the clause
  double background = 0.0;  ///< [0, 1] probability that any entity satisfies it
  double measured = 0.0;    ///< in `unit`; an angle in deg, a length in m, ...
  double sigma = 0.0;       ///< of the measurement, in `unit`
  std::string unit;         ///< "m", "m2", "deg", "1", "" where nothing was measured
  std::vector<std::int32_t>
      targets;                       ///< entity ids that the clause was satisfied on (or failed on)
  std::string target_class;          ///< the class that the targets had to be of
  std::vector<ProofClause> that_is;  ///< what the clause says of its target, held against it
};

struct ClassProbability {
  std::string name;
  double probability = 0.0;
};

/// A thing that has been named: a surface, or a group of surfaces (a shelf with its boards).
struct Entity {
  std::int32_t id = 0;                 ///< index in Labelling::entities
  std::vector<std::int32_t> surfaces;  ///< Surface::id of its faces; one for a single surface
  std::vector<std::int32_t>
      members;               ///< entity ids of a group's members, in order; empty for single ones
  std::string label;         ///< a class name, "unknown" or "ambiguous"
  double probability = 0.0;  ///< of `label`
  std::vector<ClassProbability>
      classes;                     ///< all that are not negligible, falling, "unknown" included
  std::vector<ProofClause> proof;  ///< of the best class
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of the main surface
  Eigen::Vector3d size = Eigen::Vector3d::Zero();     ///< [m] of the oriented box, longest first; a
                                                      ///< surface has size.z() = 0
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< of the box, T_cloud_entity
  double area = 0.0;                                       ///< [m2]
  std::int32_t whole = -1;  ///< entity that this one is a part of (a side of a cabinet, a board of
                            ///< a shelf); -1: none
  std::int32_t also = -1;   ///< second class when ambiguous, index into `classes`; -1: none
};

/// Surfaces that were read in another way than they were found (reasoning/alternatives.hpp).
struct Alternative {
  std::string kind;                    ///< "cut at seams", "cut evenly", "joined over a shadow"
  std::vector<std::int32_t> surfaces;  ///< Surface::id of what stands for them now
  int of = 1;                          ///< number of surfaces before
  std::string class_name;              ///< the class that decided it
  double log_ratio = 0.0;  ///< ln of the likelihood ratio against the first reading, prior included
  double log_prior = 0.0;  ///< ln of the prior against it
};

struct Labelling {
  std::vector<Entity> entities;  ///< surfaces first, in the order of Surfaces; then groups
  std::vector<std::int32_t>
      entity_of_surface;  ///< the entity that owns the surface's label: the group, else its own
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< unit, as used after refinement
  double up_sigma = 0.0;                          ///< [rad]
  std::string ontology;                           ///< name of the file
  std::string mode;                               ///< "default" or "paper"
  std::vector<Alternative> alternatives;          ///< readings that were preferred
};

/// Entity ids that are things of their own: those that own at least one surface, rising. Parts and
/// faces that were claimed by a whole are left out, so counting these counts things.
std::vector<std::int32_t> things(const Labelling& labelling);

/// labels.json (docs/reference/labels-format.md): {"objects": [{"id", "class", "probability",
/// "center", "normal", "size", "points", ...}]}. `points_of_surface`: number of inliers of each
/// surface.
nlohmann::ordered_json labelling_to_json(const Labelling& labelling,
                                         const std::vector<std::size_t>& points_of_surface);
Labelling labelling_from_json(const nlohmann::ordered_json& json, const std::string& file);

}  // namespace scanchor
