// How often a relation holds that is given a likelihood: expected calibration error of each
// relation between planes that were found, over range noise from 0 to 4 cm, against the exact
// faces.
//   relation_calibration_bench [ROOMS [SEED [FAMILY]]]     default 12 office rooms from seed 50
// "Of claims": without the pairs that hold and were said to with less than 5 %. They are counted
// because they do hold, and not because of what was said; exact likelihoods miss some too.
// "By chance" is what likelihoods that are exactly right would score on as many pairs: the error
// of few pairs says little.
// After the table: what the likelihoods take for granted of directions in rooms (shares of angles
// between exact faces that were found, reasoning/angle_relations.cpp), and how far the tilts of
// planes are from what is said of them (reasoning/plane_error.cpp).

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

#include "core/math.hpp"
#include "core/random.hpp"
#include "eval/labels.hpp"
#include "eval/plane_relations.hpp"
#include "eval/run.hpp"
#include "perception/perceive.hpp"
#include "reasoning/plane_error.hpp"
#include "reasoning/up.hpp"

namespace scanchor {
namespace {

/// Statements of one relation, counted in fifteen bins (eval/labels.hpp).
struct Bins {
  std::vector<ReliabilityBin> bins = std::vector<ReliabilityBin>(15);
  std::vector<ReliabilityBin> claims = std::vector<ReliabilityBin>(15);
  std::vector<double> said;
  void add(double probability, bool holds) {
    add_to_bins(bins, probability, holds);
    if (probability > 0.0) add_to_bins(claims, probability, holds);
    said.push_back(probability);
  }
  [[nodiscard]] double error_of_claims() const { return expected_calibration_error(claims); }
  [[nodiscard]] double by_chance() const {
    SequentialRandom random(1);
    constexpr int draws = 40;
    double sum = 0.0;
    for (int i = 0; i < draws; ++i) {
      std::vector<ReliabilityBin> drawn(15);
      for (const double p : said) add_to_bins(drawn, p, random.uniform(0.0, 1.0) < p);
      sum += expected_calibration_error(drawn);
    }
    return sum / draws;
  }
  [[nodiscard]] double error() const { return expected_calibration_error(bins); }
  [[nodiscard]] std::int64_t count() const {
    std::int64_t all = 0;
    for (const auto& bin : bins) all += bin.count;
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

/// Angles between the exact faces, [deg]: up to 0.5, 5, 85, 89.5, 90.
struct Angles {
  std::array<double, 5> number{};
  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double angle = degrees(std::atan2(a.cross(b).norm(), std::abs(a.dot(b))));
    number[angle < 0.5 ? 0 : angle < 5.0 ? 1 : angle < 85.0 ? 2 : angle < 89.5 ? 3 : 4] += 1.0;
  }
  void print(const char* name) const {
    double all = 0.0;
    for (const double n : number) all += n;
    fmt::print(
        "{:<26} parallel {:.2f}, nearly {:.2f}, any {:.2f}, nearly orthogonal {:.2f}, "
        "orthogonal {:.2f}\n",
        name, number[0] / all, number[1] / all, number[2] / all, number[3] / all, number[4] / all);
  }
};

/// True tilts of planes over the deviation that is said for them: 0.68 and 0.95 were right.
struct Tilts {
  double number = 0.0, within_one = 0.0, within_two = 0.0;
  void add(const Eigen::Vector3d& off, const Eigen::Matrix3d& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
    for (int k = 1; k < 3; ++k) {
      const double sigma = std::sqrt(std::max(0.0, axes.eigenvalues()[k]));
      const double x = std::abs(axes.eigenvectors().col(k).dot(off));
      number += 1.0;
      within_one += x <= sigma ? 1.0 : 0.0;
      within_two += x <= 2.0 * sigma ? 1.0 : 0.0;
    }
  }
  void print(const char* name) const {
    fmt::print("{:<26} within one deviation {:.2f}, within two {:.2f} of {:.0f}\n", name,
               within_one / number, within_two / number, number);
  }
};

struct Counts {
  Angles between, small, gravity;
  Tilts fit, error;
  void add(const ScanTruth& truth, const PlaneMatch& match, const Surfaces& surfaces,
           const Eigen::Vector3d& up) {
    std::vector<const PlaneTruth*> found;
    for (std::size_t p = 0; p < truth.planes.size() && p < match.region_of_truth.size(); ++p) {
      const std::int32_t region = match.region_of_truth[p];
      if (region < 0 || !truth.planes[p].has_geometry) continue;
      const PlaneTruth& plane = truth.planes[p];
      const Surface& surface = surfaces.surfaces[static_cast<std::size_t>(region)];
      gravity.add(plane.normal, up);
      Eigen::Vector3d off = plane.normal;
      if (off.dot(surface.plane.normal) < 0.0) off = -off;
      fit.add(off, surface.plane.normal_covariance);
      error.add(off, plane_error(surface, surfaces));
      for (const auto* other : found) {
        between.add(plane.normal, other->normal);
        if (std::min(plane.area, other->area) < 0.05) small.add(plane.normal, other->normal);
      }
      found.push_back(&plane);
    }
  }
  void print() const {
    between.print("angles of faces");
    small.print("one of them below 0.05 m2");
    gravity.print("angles against gravity");
    fit.print("tilts, by the fit");
    error.print("tilts, all told");
  }
};

int run(int rooms, std::uint64_t seed, const std::string& family) {
  std::map<std::string, Bins> all;
  Counts counts;
  fmt::print("{:<20} {:>7} {:>8} {:>10} {:>10}\n", "relation", "pairs", "error", "of claims",
             "by chance");
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
      if (sigma > 0.0) counts.add(truth, match, surfaces, up.up);
      add_pairs(lists, bins);
      add_pairs(lists, all);
    }
    for (const auto& [relation, own] : bins)
      fmt::print("{:<20} {:>7} {:>8.3f} {:>10.3f} {:>10.3f}   at {:g} m\n", relation, own.count(),
                 own.error(), own.error_of_claims(), own.by_chance(), sigma);
  }
  for (const auto& [relation, own] : all)
    fmt::print("{:<20} {:>7} {:>8.3f} {:>10.3f} {:>10.3f}   all\n", relation, own.count(),
               own.error(), own.error_of_claims(), own.by_chance());
  counts.print();
  return 0;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  const int rooms = argc > 1 ? std::atoi(argv[1]) : 12;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 50;
  return scanchor::run(rooms, seed, argc > 3 ? argv[3] : "office");
}
