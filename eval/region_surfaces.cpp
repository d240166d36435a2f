#include "eval/region_surfaces.hpp"

#include <chrono>

#include "perception/cell_tree.hpp"
#include "perception/find_planes.hpp"
#include "perception/noise.hpp"
#include "reasoning/alternatives.hpp"

namespace scanchor {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Surfaces surfaces_of_regions(const PointCloud& cloud, const PerceiveOptions& options,
                             const PlaneFinder& finder) {
  Surfaces surfaces;
  PlaneInput input = plane_input(cloud, options, surfaces);
  input.sigma = options.noise_sigma > 0.0
                    ? options.noise_sigma
                    : estimate_noise(input.cloud, cell_tree(input.cloud), input.spacing,
                                     surfaces.sensor_positions);
  surfaces.noise_sigma = input.sigma;
  const std::vector<std::int32_t> region_of_point = finder(cloud, input.sigma);
  // Equal points are one point of the canonical cloud.
  std::vector<std::int32_t> region_of(input.cloud.size());
  for (std::size_t i = 0; i < region_of.size(); ++i)
    region_of[i] = region_of_point[input.cloud.source[input.cloud.first[i]]];
  collect_surfaces(cloud, input, region_of, surfaces);
  return surfaces;
}

Method peer_method(const std::string& name, PlaneFinder finder,
                   const PerceiveOptions& perceive_options, const Ontology& ontology,
                   const ReasonOptions& reason_options) {
  Method method = own_method(perceive_options, ontology, reason_options);
  method.name = name + "/" + reason_options.mode + "/" + ontology.name;
  method.answer = [=, finder = std::move(finder)](const Scan& scan, const std::string&) {
    MethodAnswer answer;
    const auto start = std::chrono::steady_clock::now();
    answer.surfaces = surfaces_of_regions(scan.cloud, perceive_options, finder);
    find_shapes(scan.cloud, perceive_options, *answer.surfaces);
    answer.perceive_seconds = seconds_since(start);
    answer.labelling = interpret(*answer.surfaces, scan.cloud, ontology, reason_options);
    answer.reason_seconds = seconds_since(start) - answer.perceive_seconds;
    answer.points = predict_points(*answer.surfaces, *answer.labelling);
    return answer;
  };
  return method;
}

}  // namespace scanchor
