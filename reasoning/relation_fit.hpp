#pragma once
// Finding the free constants of the relations' likelihoods on training rooms: `scanchor fit
// --relations`.

#include <string>
#include <vector>

#include "reasoning/item.hpp"
#include "reasoning/relation.hpp"
#include "reasoning/relation_model.hpp"

namespace scanchor {

/// One statement: relation of a to b (indices of items), and whether it truly holds.
struct RelationSample {
  Relation relation = Relation::parallel;
  std::int32_t a = 0, b = 0;
  bool holds = false;
};

/// A plane as it was found, and its true normal (unit, cloud's frame).
struct NormalSample {
  std::int32_t surface = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// One training scan: what was perceived, and by somebody who may know, what truly holds.
struct RelationScene {
  Surfaces surfaces;  ///< points of surfaces and outlines are not looked at
  Eigen::Matrix3d R_level_cloud = Eigen::Matrix3d::Identity();
  std::vector<Item> items;  ///< make_items
  Surrounding around;
  std::vector<RelationSample> samples;
  std::vector<NormalSample> normals;
};

/// Puts the errors of planes that a model says into the items, and the model into `around`; it has
/// to outlive the scene's use.
void use_model(RelationScene& scene, const RelationModel& model);

struct RelationFitOptions {
  int rounds = 40;                   ///< over the constants of a part, at most
  double least_step = 0.02;          ///< of the logarithm of a constant, where it stops
  std::size_t most_samples = 12000;  ///< of one relation; more are thinned out evenly
};

/// Loss before and after of one part, per sample.
struct RelationFitPart {
  std::string name;
  std::size_t samples = 0;
  double before = 0.0, after = 0.0;
};

struct RelationFit {
  RelationModel model;
  std::vector<RelationFitPart> parts;
};

/// The constants that make what is true most likely, part by part (RelationConstant::part), from
/// `start`: of planes, how far true normals are off; of all others, whether relations hold. A
/// constant that no sample depends on stays as it is. To three digits; deterministic, whatever the
/// number of threads. Throws Error(bad_data) where there is no sample at all.
RelationFit fit_relations(const std::vector<RelationScene>& scenes, const RelationModel& start,
                          const RelationFitOptions& options = {});

}  // namespace scanchor
