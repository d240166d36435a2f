// peers: the comparison table on any cloud, or on the reference room.
//   peers                               the reference room, 100,000 points, 1 cm noise
//   peers --seed 7 --sigma 0.02         another room, more noise
//   peers SCAN --truth plane            a cloud with the plane of each point in the field "plane"
//   (ids below --first are none)
// Each method runs in a process of its own, so that its peak memory is its own: resident growth
// above the loaded cloud.

#include <fmt/core.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <ctime>
#include <fstream>
#include <functional>

#include "bench/peers/peer.hpp"
#include "cloud/io.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "perception/perceive.hpp"
#include "tests/perception/support/plane_score.hpp"
#include "tests/perception/support/room.hpp"

namespace {

using namespace scanchor;

struct Method {
  std::string name;
  std::function<peers::Labels(const PointCloud&, const peers::PeerOptions&)> run;
};

struct Result {
  double first_ms = 0.0, cpu_ms = 1e300, wall_ms = 1e300, megabytes = 0.0;
  support::PlaneScore score;
};

peers::Points positions(const PointCloud& cloud) {
  peers::Points points(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    points[i] = {cloud.points[i].x(), cloud.points[i].y(), cloud.points[i].z()};
  return points;
}

Method ours(const std::string& method, bool told) {
  return {"scanchor " + method + (told ? "" : ", told nothing"),
          [method, told](const PointCloud& cloud, const peers::PeerOptions& options) {
            PerceiveOptions perceive;
            perceive.method = method;
            perceive.noise_sigma = told ? options.sigma : 0.0;
            perceive.shapes = false;
            return find_planes(cloud, perceive).plane_of_point;
          }};
}

template <class Peer>
Method theirs(const std::string& name, Peer peer) {
  return {name, [peer](const PointCloud& cloud, peers::PeerOptions options) {
            // A tolerance of zero finds nothing anywhere: 2 mm is what a sweep at no noise likes.
            options.sigma = std::max(options.sigma, 0.002);
            return peer(positions(cloud), options);
          }};
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

// Resident memory now, so that the peak can be told from what was loaded before.
double resident_megabytes() {
  std::ifstream statm("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

// The first turn of a process also pays for memory that the system hands out page by page and for
// what is loaded when it is first called: it stands for itself, and the best of all turns counts.
Result measure(const Method& method, const PointCloud& cloud,
               const std::vector<std::int32_t>& truth, const peers::PeerOptions& options,
               int turns) {
  Result result;
  peers::Labels labels;
  for (int turn = 0; turn < turns; ++turn) {
    const double before_mb = resident_megabytes(), before_cpu = cpu_ms();
    const auto before = std::chrono::steady_clock::now();
    labels = method.run(cloud, options);
    const double wall =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before)
            .count();
    const double cpu = cpu_ms() - before_cpu;
    result.wall_ms = std::min(result.wall_ms, wall);
    result.cpu_ms = std::min(result.cpu_ms, cpu);
    if (turn > 0) continue;
    result.first_ms = cpu;
    result.megabytes = std::max(0.0, peak_megabytes() - before_mb);
  }
  if (!truth.empty()) result.score = support::score_planes(truth, labels, 0.8, truth.size() / 2000);
  return result;
}

void print_row(const std::string& name, const Result& r) {
  const auto& s = r.score;
  fmt::print(
      "{:<32} {:>8.0f} {:>8.0f} {:>8.0f} {:>7.1f} {:>4}/{:<4} {:>5} {:>6} {:>7} {:>6} {:>8.3f} "
      "{:>7.3f} "
      "{:>8.3f}\n",
      name, r.first_ms, r.cpu_ms, r.wall_ms, r.megabytes, s.correct, s.planes, s.over, s.under,
      s.missed, s.spurious, s.precision, s.recall, s.small_recall);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  CLI::App app{"Planes of other libraries beside ours, on one cloud"};
  std::string file, truth_field, only;
  int first = 0, turns = 3;
  std::uint64_t seed = 0;
  support::RayGrid grid;
  peers::PeerOptions options;
  app.add_option("cloud", file, "a cloud; without one the reference room is scanned");
  app.add_option("--truth", truth_field, "field with the plane of each point");
  app.add_option("--first", first, "smaller values of that field are no planes");
  app.add_option("--seed", seed, "of the reference room; 0: the furniture of the design");
  app.add_option("--beams", grid.beams, "beams of a line");
  app.add_option("--lines", grid.lines, "lines of the sweep");
  app.add_option("--sigma", options.sigma,
                 "[m] range noise: of the scan, and what the methods are told");
  app.add_option("--neighbours", options.neighbours, "k of the peers' normals");
  app.add_option("--turns", turns, "runs of each method; the best time counts");
  app.add_option("--only", only, "methods whose name contains this");
  CLI11_PARSE(app, argc, argv);

  PointCloud cloud;
  std::vector<std::int32_t> truth;
  if (file.empty()) {
    grid.range_sigma = options.sigma;
    grid.seed = seed + 1;
    const auto scan =
        support::shuffled(support::scan_boxes(support::reference_room(seed), grid), 7);
    cloud = scan.cloud;
    truth = scan.plane;
  } else {
    cloud = read_cloud(file);
    if (const Field* field = truth_field.empty() ? nullptr : cloud.find(truth_field)) {
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        const double value = field->at(i);
        truth.push_back(value >= first ? static_cast<std::int32_t>(value) : -1);
      }
    } else if (!truth_field.empty()) {
      fail_data(file, "", "has no field \"" + truth_field + "\"");
    }
  }
  const std::vector<Method> methods = {
      ours("default", true),
      ours("default", false),
      ours("paper", true),
      theirs("CGAL region growing", peers::cgal_region_growing),
      theirs("CGAL Efficient RANSAC", peers::cgal_efficient_ransac),
#ifdef SCANCHOR_HAVE_PCL
      theirs("PCL region growing", peers::pcl_region_growing),
#endif
  };
  fmt::print("{} points, one thread\n", cloud.size());
  fmt::print("{:<32} {:>8} {:>8} {:>8} {:>7} {:>9} {:>5} {:>6} {:>7} {:>6} {:>8} {:>7} {:>8}\n",
             "method", "first ms", "CPU ms", "wall ms", "MB", "correct", "over", "under", "missed",
             "spur.", "adjPrec", "adjRec", "smallRec");
  std::fflush(stdout);
  for (const auto& method : methods) {
    if (method.name.find(only) == std::string::npos) continue;
    const pid_t child = fork();
    if (child == 0) {
      const ThreadLimit one(1);
      print_row(method.name, measure(method, cloud, truth, options, std::max(turns, 1)));
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) fmt::print("{:<32} ended with status {}\n", method.name, status);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const scanchor::Error& error) {
    fmt::print(stderr, "peers: {}\n", error.what());
    return static_cast<int>(error.code());
  }
}
