// A thousand settled rooms of the mixed suite: time a room by family, wall time of all, and whether
// memory stays flat.
//   rooms_bench [ROOMS [THREADS]]     default 1000 rooms on all cores

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <mutex>

#include "core/data_folder.hpp"
#include "core/parallel.hpp"
#include "sensors/made_room.hpp"
#include "sensors/suite.hpp"

namespace scanchor {
namespace {

double cpu_of_this_thread() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// [MiB] held now, from the second number of /proc/self/statm.
double memory_now() {
  std::ifstream in("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  in >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

struct Sum {
  int rooms = 0, tries = 0, unsettled = 0, incomplete = 0;
  std::size_t loose = 0, triangles = 0;
  double cpu = 0.0, slowest = 0.0, generate = 0.0, settle = 0.0;
};

int run(int rooms, int threads) {
  Suite suite = read_suite(find_data_file("suites", "mixed", ".yaml"));
  suite.scenes = rooms;
  const auto tasks = scene_tasks(suite);
  const ThreadLimit limit(threads);
  std::map<std::string, Sum> families;
  std::vector<double> memory;
  std::mutex mutex;
  int done = 0;
  const auto start = std::chrono::steady_clock::now();
  parallel_blocks(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double before = cpu_of_this_thread();
      RoomTimes times;
      const MadeRoom room = make_room(tasks[i], &times);
      const double spent = cpu_of_this_thread() - before;
      const std::lock_guard lock(mutex);
      for (const char* name : {tasks[i].room.family.c_str(), "all"}) {
        Sum& sum = families[name];
        ++sum.rooms;
        sum.tries += room.tries;
        sum.unsettled += room.settled ? 0 : 1;
        sum.incomplete += room.complete ? 0 : 1;
        sum.loose += static_cast<std::size_t>(
            std::count_if(room.scene.instances.begin(), room.scene.instances.end(),
                          [](const Instance& thing) { return thing.loose; }));
        sum.triangles += triangle_count(room.scene);
        sum.cpu += spent;
        sum.generate += times.generate;
        sum.settle += times.settle;
        sum.slowest = std::max(sum.slowest, spent);
      }
      if (++done % std::max(1, rooms / 10) == 0) memory.push_back(memory_now());
    }
  });
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{:18} {:>6} {:>7} {:>7} {:>10} {:>8} {:>10} {:>9} {:>11} {:>9} {:>10}\n", "family",
             "rooms", "tries", "loose", "triangles", "CPU ms", "generate %", "settle %",
             "slowest ms", "unsettled", "incomplete");
  for (const auto& [name, s] : families) {
    const double n = s.rooms;
    fmt::print("{:18} {:6} {:7.2f} {:7.1f} {:10.0f} {:8.1f} {:10.0f} {:9.0f} {:11.0f} {:9} {:10}\n",
               name, s.rooms, s.tries / n, static_cast<double>(s.loose) / n,
               static_cast<double>(s.triangles) / n, 1e3 * s.cpu / n,
               100 * s.generate / (s.generate + s.settle), 100 * s.settle / (s.generate + s.settle),
               1e3 * s.slowest, s.unsettled, s.incomplete);
  }
  fmt::print(
      "\n{} rooms in {:.1f} s wall, {:.1f} s CPU: {:.1f} rooms/s\nmemory [MiB] after each tenth:",
      rooms, wall, families["all"].cpu, rooms / wall);
  for (const double mib : memory) fmt::print(" {:.0f}", mib);
  fmt::print("\n");
  return 0;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  return scanchor::run(argc > 1 ? std::atoi(argv[1]) : 1000, argc > 2 ? std::atoi(argv[2]) : 0);
}
