#include "tests/reasoning/support/built.hpp"

#include <algorithm>

#include "core/math.hpp"

namespace scanchor::test {

Surface make_surface(const Plate& plate) {
  Surface s;
  const Eigen::Vector3d n = plate.normal.normalized();
  const Eigen::Vector3d x = (plate.along - n * n.dot(plate.along)).normalized();
  const Eigen::Vector3d y = n.cross(x);
  s.plane.normal = n;
  s.plane.centroid = plate.center;
  s.plane.offset = n.dot(plate.center);
  s.plane.residual_sigma = 0.01;
  const double t = radians(plate.tilt_sigma_deg);
  s.plane.normal_covariance = t * t * (x * x.transpose() + y * y.transpose());
  s.plane.centroid_sigma = 0.003;
  s.T_cloud_surface.linear().col(0) = x;
  s.T_cloud_surface.linear().col(1) = y;
  s.T_cloud_surface.linear().col(2) = n;
  s.T_cloud_surface.translation() = plate.center;
  const double a = 0.5 * plate.length;
  const double b = 0.5 * plate.width;
  Polygon polygon;
  polygon.outer = {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
  s.polygons = {polygon};
  const bool cut = plate.hidden > 0.0;
  const auto measured = [&](double value, double sigma) {
    return Measured{value, value - 1.96 * sigma, value + 1.96 * sigma, cut};
  };
  s.rectangle.length = measured(std::max(plate.length, plate.width), plate.edge_sigma);
  s.rectangle.width = measured(std::min(plate.length, plate.width), plate.edge_sigma);
  s.rectangle.angle = plate.length >= plate.width ? 0.0 : 0.5 * pi;
  s.area = measured(plate.length * plate.width * plate.fill,
                    plate.edge_sigma * (plate.length + plate.width));
  s.rectangularness = plate.fill;
  s.is_rectangle = plate.fill > 0.9;
  s.occluded_outline = plate.hidden;
  return s;
}

Surfaces make_surfaces(const std::vector<Plate>& plates) {
  Surfaces surfaces;
  surfaces.noise_sigma = 0.01;
  surfaces.point_spacing = 0.01;
  for (const auto& plate : plates) {
    surfaces.surfaces.push_back(make_surface(plate));
    surfaces.surfaces.back().id = static_cast<std::int32_t>(surfaces.surfaces.size()) - 1;
  }
  return surfaces;
}

Plate floor_plate() { return {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 6.0, 5.0}; }
Plate desk_plate() { return {{1, 1.5, 0.74}, {0, 0, 1}, {1, 0, 0}, 1.6, 0.8}; }
Plate screen_plate(double x) { return {{x, 1.6, 1.06}, {0, -1, 0}, {1, 0, 0}, 0.57, 0.42}; }

std::vector<Plate> paper_room() {
  return {floor_plate(),
          {{0, 2.5, 1.35}, {0, -1, 0}, {1, 0, 0}, 6.0, 2.7},
          {{0, -2.5, 1.35}, {0, 1, 0}, {1, 0, 0}, 6.0, 2.7},
          {{3, 0, 1.35}, {-1, 0, 0}, {0, 1, 0}, 5.0, 2.7},
          {{-3, 0, 1.35}, {1, 0, 0}, {0, 1, 0}, 5.0, 2.7},
          {{0, 0, 2.7}, {0, 0, -1}, {1, 0, 0}, 6.0, 5.0},
          desk_plate(),
          screen_plate(0.65),
          screen_plate(1.35)};
}

std::vector<Plate> shelf_boards(int boards) {
  std::vector<Plate> plates;
  for (int i = 0; i < boards; ++i)
    plates.push_back({{-2.0, -2.0, 0.3 + 0.4 * i}, {0, 0, 1}, {1, 0, 0}, 1.16, 0.35});
  return plates;
}

Surfaces moved(const Surfaces& surfaces, const Eigen::Isometry3d& T) {
  Surfaces result = surfaces;
  const Eigen::Matrix3d R = T.linear();
  for (auto& s : result.surfaces) {
    s.plane.normal = R * s.plane.normal;
    s.plane.centroid = T * s.plane.centroid;
    s.plane.offset = s.plane.normal.dot(s.plane.centroid);
    s.plane.normal_covariance = R * s.plane.normal_covariance * R.transpose();
    s.T_cloud_surface = T * s.T_cloud_surface;
  }
  for (auto& p : result.sensor_positions) p = T * p;
  return result;
}

std::vector<std::string> labels(const Labelling& labelling) {
  std::vector<std::string> all;
  for (const auto e : labelling.entity_of_surface) all.push_back(labelling.entities[e].label);
  return all;
}

int count_things(const Labelling& labelling, const std::string& label) {
  int count = 0;
  for (const auto e : things(labelling)) count += labelling.entities[e].label == label ? 1 : 0;
  return count;
}

double probability_of(const Entity& entity, const std::string& name) {
  for (const auto& c : entity.classes) {
    if (c.name == name) return c.probability;
  }
  return 0.0;
}

Ontology shipped(const std::string& name) {
  return read_ontology(std::string(SCANCHOR_SOURCE_DIR) + "/ontologies/" + name + ".sdl");
}

const Ontology& office() {
  static const Ontology ontology = shipped("office");
  return ontology;
}

}  // namespace scanchor::test
