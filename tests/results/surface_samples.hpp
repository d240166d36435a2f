#pragma once
// A desk top with a hole and a screen that stands on it, as perception and reasoning would give
// them.

#include <cmath>

#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"

namespace scanchor::samples {

inline Surface rectangle_surface(std::int32_t id, double length, double width) {
  Surface surface;
  surface.id = id;
  const double a = length / 2;
  const double b = width / 2;
  surface.polygons.push_back({{{-a, -b}, {a, -b}, {a, b}, {-a, b}}, {}, {}});
  surface.rectangle.length = {length, length - 0.02, length + 0.02, false};
  surface.rectangle.width = {width, width - 0.02, width + 0.02, false};
  surface.area = {length * width, 0, 0, false};
  surface.rectangularness = 0.95;
  surface.is_rectangle = true;
  return surface;
}

inline Surfaces two_surfaces() {
  Surfaces surfaces;
  Surface desk = rectangle_surface(0, 1.6, 0.8);
  desk.polygons[0].holes.push_back({{0, 0}, {0, 0.1}, {0.1, 0.1}, {0.1, 0}});
  desk.T_cloud_surface.translation() = Eigen::Vector3d(0, 0, 0.72);
  desk.plane.centroid = {0, 0, 0.72};
  Surface screen = rectangle_surface(1, 0.57, 0.42);
  screen.plane.normal = {1, 0, 0};
  screen.plane.centroid = {0, 0, 1.1};
  // z along the normal, x along the world's y, y up.
  screen.T_cloud_surface.linear().col(0) = Eigen::Vector3d::UnitY();
  screen.T_cloud_surface.linear().col(1) = Eigen::Vector3d::UnitZ();
  screen.T_cloud_surface.linear().col(2) = Eigen::Vector3d::UnitX();
  screen.T_cloud_surface.translation() = Eigen::Vector3d(0, 0, 1.1);
  surfaces.surfaces = {desk, screen};
  surfaces.plane_of_point = {0, 0, 1, -1};
  return surfaces;
}

inline Labelling two_labels() {
  Labelling labelling;
  Entity desk;
  desk.id = 0;
  desk.surfaces = {0};
  desk.label = "desk";
  desk.probability = 0.97;
  desk.center = {0, 0, 0.72};
  Entity screen;
  screen.id = 1;
  screen.surfaces = {1};
  screen.label = "screen";
  screen.probability = 0.8;
  screen.center = {0, 0, 1.1};
  ProofClause above;
  above.text = "above a desk";
  above.likelihood = 0.99;
  above.targets = {0};
  above.target_class = "desk";
  screen.proof = {above};
  labelling.entities = {desk, screen};
  labelling.entity_of_surface = {0, 1};
  return labelling;
}

}  // namespace scanchor::samples
