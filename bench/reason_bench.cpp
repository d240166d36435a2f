// Time of reasoning: a room of 150 surfaces with 30 of the office classes and with all, and 10,000
// surfaces with 1,000 random classes.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "core/random.hpp"
#include "perception/surface.hpp"
#include "reasoning/reason.hpp"

namespace {

using namespace scanchor;

Surface plate(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double length,
              double width) {
  Surface s;
  const Eigen::Vector3d x = std::abs(normal.z()) > 0.9
                                ? Eigen::Vector3d::UnitX()
                                : Eigen::Vector3d(-normal.y(), normal.x(), 0);
  s.plane.normal = normal;
  s.plane.centroid = center;
  s.plane.offset = normal.dot(center);
  s.plane.normal_covariance = 1e-5 * (Eigen::Matrix3d::Identity() - normal * normal.transpose());
  s.plane.centroid_sigma = 0.003;
  s.T_cloud_surface.linear().col(0) = x;
  s.T_cloud_surface.linear().col(1) = normal.cross(x);
  s.T_cloud_surface.linear().col(2) = normal;
  s.T_cloud_surface.translation() = center;
  const double a = 0.5 * length;
  const double b = 0.5 * width;
  Polygon polygon;
  polygon.outer = {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
  s.polygons = {polygon};
  s.rectangle.length = {length, length - 0.01, length + 0.01, false};
  s.rectangle.width = {width, width - 0.01, width + 0.01, false};
  s.area = {length * width, length * width * 0.98, length * width * 1.02, false};
  s.rectangularness = 1.0;
  return s;
}

/// Floor, walls, ceiling, and furniture-sized plates at random: about one in twenty a desk top, a
/// screen, ...
Surfaces scene(int count, double side) {
  SequentialRandom random(1);
  Surfaces surfaces;
  surfaces.sensor_positions = {Eigen::Vector3d(0, 0, 1.4)};
  auto& all = surfaces.surfaces;
  all.push_back(plate({0, 0, 0}, {0, 0, 1}, 2 * side, 2 * side));
  all.push_back(plate({0, 0, 2.7}, {0, 0, -1}, 2 * side, 2 * side));
  for (const double sign : {-1.0, 1.0}) {
    all.push_back(plate({sign * side, 0, 1.35}, {-sign, 0, 0}, 2 * side, 2.7));
    all.push_back(plate({0, sign * side, 1.35}, {0, -sign, 0}, 2 * side, 2.7));
  }
  while (static_cast<int>(all.size()) < count) {
    const Eigen::Vector3d center(random.uniform(-side, side), random.uniform(-side, side),
                                 random.uniform(0.1, 2.2));
    const auto way = random.below(3);
    const Eigen::Vector3d normal = way == 0   ? Eigen::Vector3d::UnitZ()
                                   : way == 1 ? Eigen::Vector3d::UnitX()
                                              : Eigen::Vector3d::UnitY();
    const double length = random.uniform(0.2, 2.0);
    all.push_back(plate(center, normal, length, length * random.uniform(0.2, 1.0)));
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].id = static_cast<std::int32_t>(i);
  return surfaces;
}

Ontology random_classes(int count) {
  SequentialRandom random(2);
  std::string text = "axiom floor:\n    area at least 4 m2\n    horizontal\n    lowest\n";
  for (int c = 0; c < count - 1; ++c) {
    const double low = random.uniform(0.05, 2.0);
    text += "class c" + std::to_string(c) + ":\n    area " + std::to_string(low) + ".." +
            std::to_string(1.3 * low) + " m2\n    extension " + std::to_string(std::sqrt(low)) +
            ".." + std::to_string(1.7 * std::sqrt(low)) + " m\n    rectangular\n";
    text += random.chance(0.5) ? "    horizontal\n" : "    vertical\n";
    const std::string target =
        c == 0 ? "floor" : "c" + std::to_string(random.below(static_cast<std::uint32_t>(c)));
    const auto kind = random.below(4);
    text += kind == 0   ? "    parallel to a floor\n"
            : kind == 1 ? "    above a " + target + "\n"
            : kind == 2 ? "    near a " + target + "\n"
                        : "";
  }
  return parse_ontology(text, "random.sdl");
}

bool speaks_of(const std::vector<Clause>& clauses, const std::string& name) {
  return std::any_of(clauses.begin(), clauses.end(), [&](const Clause& clause) {
    return clause.target == name || speaks_of(clause.target_clauses, name);
  });
}

/// The shipped classes but the last ones that no other class asks for.
Ontology office_classes(std::size_t count) {
  Ontology ontology = find_ontology("office");
  auto& classes = ontology.classes;
  for (std::size_t c = classes.size(); c-- > 0 && classes.size() > count;) {
    const std::string name = classes[c].name();
    const bool asked_for = std::any_of(classes.begin(), classes.end(), [&](const auto& other) {
      return other.name() != name &&
             (other.parent == name || other.part_of == name || speaks_of(other.clauses, name));
    });
    if (!asked_for) {
      classes.erase(classes.begin() + static_cast<std::ptrdiff_t>(c));
      c = classes.size();  // what only this one asked for may go now
    }
  }
  return ontology;
}

void office_room(benchmark::State& state) {
  const auto surfaces = scene(150, 3.0);
  const auto ontology = office_classes(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(reason(surfaces, ontology, {}));
  state.counters["classes"] = static_cast<double>(ontology.classes.size());
}
BENCHMARK(office_room)->Arg(30)->Arg(45)->Unit(benchmark::kMillisecond);

void many_surfaces_many_classes(benchmark::State& state) {
  const auto surfaces = scene(static_cast<int>(state.range(0)), 40.0);
  const auto ontology = random_classes(static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(reason(surfaces, ontology, {}));
}
BENCHMARK(many_surfaces_many_classes)
    ->Args({1000, 100})
    ->Args({10000, 100})
    ->Args({10000, 1000})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
