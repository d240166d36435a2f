#pragma once
// What each relation and feature of the language means as a number in [0, 1]; reasoning.md
// section 2.3.

#include <optional>
#include <string>

#include "reasoning/item.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {

struct RelationModel;
const RelationModel& relation_model();

/// What a likelihood was made of.
struct Evidence {
  double likelihood = 0.0;
  double measured = 0.0;  ///< in `unit`
  double sigma = 0.0;     ///< standard deviation of the measurement alone, in `unit`
  const char* unit = "";  ///< "deg", "m", "m2", "1"
};

/// What all relations of one scene share.
struct Surrounding {
  double up_sigma = 0.0;  ///< [rad] of the levelled frame's z axis
  std::optional<Eigen::Vector3d>
      viewpoint;  ///< of the robot, levelled [m]; for left, right, in front, behind
  const RelationModel* model = &relation_model();
};

/// Horizontal (the normal is along gravity) and vertical within a tolerance, softness 1 deg.
Evidence horizontal(const Item& a, const Surrounding& around, double tolerance_deg = 5.0);
Evidence vertical(const Item& a, const Surrounding& around, double tolerance_deg = 5.0);
/// A feature in a range. Softness of a limit: 10 % of a length, 15 % of an area (reasoning.md 2.4),
/// 5 % of pure numbers.
Evidence feature(Feature which, const Range& range, const Item& a);
/// The word "rectangular": R at least 0.8, softness 0.07.
Evidence rectangular(const Item& a);

/// Relation of a (subject) to b (target). Never NaN; 0 where one of them has no shape and the
/// relation needs one.
Evidence relate(const RelationTerm& term, const Item& a, const Item& b, const Surrounding& around);

/// Share of the smaller footprint that lies in the other one, [0, 1].
double footprint_overlap(const Footprint& a, const Footprint& b);
/// Shortest distance between two entities [m]: between rectangles for surfaces, between upright
/// boxes for groups.
double gap_distance(const Item& a, const Item& b);
/// Where the two come nearest: from a to b, of the length of their distance [m].
Eigen::Vector3d nearest_step(const Item& a, const Item& b);

}  // namespace scanchor
