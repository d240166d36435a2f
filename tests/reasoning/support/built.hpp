#pragma once
// Surfaces that are made and not measured: the answers are known by construction.

#include <string>
#include <vector>

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor::test {

/// A rectangle with its longer side along `along`, seen whole, with the deviations of a good scan.
struct Plate {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();
  double length = 1.0;
  double width = 0.5;
  double tilt_sigma_deg = 0.1;
  double edge_sigma = 0.005;
  double hidden = 0.0;  ///< share of the outline in the shadow; above 0: sizes are "at least"
  double fill = 1.0;    ///< area / area of the rectangle
};

Surface make_surface(const Plate& plate);
/// Numbered in their order.
Surfaces make_surfaces(const std::vector<Plate>& plates);

/// The desk of equation 1 with one or two screens, on a floor of 6 x 5 m, walls of 2.7 m and a
/// ceiling.
std::vector<Plate> paper_room();
/// `boards` boards 1.16 x 0.35 m, one above the other, at (2, 2).
std::vector<Plate> shelf_boards(int boards);

Plate floor_plate();
Plate desk_plate();
Plate screen_plate(double x = 1.0);

/// All turned by `R` and then moved.
Surfaces moved(const Surfaces& surfaces, const Eigen::Isometry3d& T);

/// Labels of the surfaces in their order, "shelf" for what a shelf owns.
std::vector<std::string> labels(const Labelling& labelling);
int count_things(const Labelling& labelling, const std::string& label);
double probability_of(const Entity& entity, const std::string& name);

/// A class file that comes with the source.
Ontology shipped(const std::string& name);

/// The shipped one that most tests ask.
const Ontology& office();

}  // namespace scanchor::test
