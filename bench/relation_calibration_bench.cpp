// How often a relation holds that is given a likelihood: expected calibration error of each
// relation between planes that were found, over range noise from 0 to 4 cm, against the exact
// faces.
//   relation_calibration_bench [ROOMS [SEED [FAMILY]]]     default 12 office rooms from seed 50

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

#include "core/math.hpp"
#include "eval/plane_relations.hpp"
#include "eval/run.hpp"
#include "perception/perceive.hpp"
#include "reasoning/up.hpp"

namespace scanchor {
namespace {

constexpr int bin_count = 15;

/// Fifteen even bins of likelihood (C. Guo et al., ICML 2017, equation 3).
struct Bins {
  std::array<double, bin_count> said{}, held{}, number{};
  void add(double probability, bool holds) {
    const int bin = std::min(bin_count - 1, static_cast<int>(probability * bin_count));
    const auto k = static_cast<std::size_t>(bin);
    said[k] += probability;
    held[k] += holds ? 1.0 : 0.0;
    number[k] += 1.0;
  }
  [[nodiscard]] double error() const {
    double off = 0.0, all = 0.0;
    for (std::size_t k = 0; k < bin_count; ++k) {
      off += std::abs(said[k] - held[k]);
      all += number[k];
    }
    return all > 0.0 ? off / all : 0.0;
  }
  [[nodiscard]] double count() const {
    double all = 0.0;
    for (const double n : number) all += n;
    return all;
  }
};

// Pairs that are claimed with at least 5 % or hold, and borderline ones: all others are a plain no
// on both sides and would only flatter.
void add_pairs(const PlaneRelations& lists, std::map<std::string, Bins>& bins) {
  std::map<std::tuple<std::string, std::int32_t, std::int32_t>, bool> holds;
  for (const auto& fact : lists.truth) holds[{fact.relation, fact.a, fact.b}] = fact.holds;
  for (const auto& claim : lists.claims) {
    const auto at = holds.find({claim.relation, claim.a, claim.b});
    bins[claim.relation].add(claim.probability, at != holds.end() && at->second);
    if (at != holds.end()) holds.erase(at);
  }
  for (const auto& [key, held] : holds) bins[std::get<0>(key)].add(0.0, held);
}

int run(int rooms, std::uint64_t seed, const std::string& family) {
  std::map<std::string, Bins> all;
  fmt::print("{:<20} {:>7} {:>8}\n", "relation", "pairs", "error");
  for (const double sigma : {0.0, 0.005, 0.01, 0.02, 0.04}) {
    std::map<std::string, Bins> bins;
    Suite suite;
    suite.name = "calibration";
    suite.scenes = rooms;
    suite.seed = seed;
    suite.families = {{family, 1.0}};
    suite.lidar.range_sigma = sigma;
    for (const auto& task : scene_tasks(suite)) {
      const MadeScene made = make_scene(task, 1);
      const Scan& scan = made.scans.front();
      const ScanTruth truth = truth_of(scan, &made.scene, Protocol{});
      const Surfaces surfaces = perceive(scan.cloud, PerceiveOptions{});
      PlaneMatch match;
      score_planes(truth.plane, truth.ignored_planes, surfaces.plane_of_point, Protocol{}, &match);
      const ReasonOptions options;
      const UpDirection up = find_up(surfaces, options.up, radians(options.up_sigma_deg));
      const auto lists =
          plane_relations(scan, made.scene, truth, match, surfaces, up.up, up.sigma, Protocol{});
      add_pairs(lists, bins);
      add_pairs(lists, all);
    }
    for (const auto& [relation, own] : bins)
      fmt::print("{:<20} {:>7.0f} {:>8.3f}   at {:g} m\n", relation, own.count(), own.error(),
                 sigma);
  }
  for (const auto& [relation, own] : all)
    fmt::print("{:<20} {:>7.0f} {:>8.3f}   all\n", relation, own.count(), own.error());
  return 0;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  const int rooms = argc > 1 ? std::atoi(argv[1]) : 12;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 50;
  return scanchor::run(rooms, seed, argc > 3 ? argv[3] : "office");
}
