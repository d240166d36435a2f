// Whether the laws of rooms hold in thousands of them, before and after physics: what the property
// tests ask of some hundreds in each run.
//   laws_bench [ROOMS [FIRST_SEED]]     default 2000 rooms, all families in turn, from seed 100000
//
// Exit code 1 and a line each for what is broken.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>

#include "core/parallel.hpp"
#include "scenes/generator.hpp"
#include "sim/settle.hpp"
#include "tests/scenes/support/room_laws.hpp"

int main(int argc, char** argv) {
  using namespace scanchor;
  const std::size_t rooms = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 100000;
  std::mutex mutex;
  std::map<std::string, int> incomplete, unsettled, asked;
  std::vector<std::string> broken;
  double deepest = 0.0;
  parallel_blocks(rooms, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint64_t seed = first + i / room_families().size();
      RoomOptions options;
      options.family = room_families()[i % room_families().size()];
      // Corners of the settings, in turn.
      options.clutter = seed % 3 == 0 ? 1.0 : seed % 3 == 1 ? 0.5 : 0.0;
      options.unusual_sizes = seed % 4 == 3 ? 0.3 : 0.0;
      options.out_of_square_deg = seed % 5 == 4 ? 6.0 : 2.0;
      GeneratedRoom room = furnish_room(options, seed);
      std::vector<std::string> lines = testing::broken_laws(room.scene, false);
      const SettleReport report = settle(room.scene, {});
      if (report.settled) {  // else make_room furnishes it anew
        const auto after = testing::broken_laws(room.scene, true);
        lines.insert(lines.end(), after.begin(), after.end());
      }
      const std::lock_guard lock(mutex);
      ++asked[options.family];
      incomplete[options.family] += room.complete ? 0 : 1;
      unsettled[options.family] += report.settled ? 0 : 1;
      if (report.settled) deepest = std::max(deepest, report.deepest_penetration);
      broken.insert(broken.end(), lines.begin(), lines.end());
    }
  });
  for (const auto& [family, n] : asked)
    fmt::print("{:18} {:5} rooms, {} incomplete, {} did not come to rest at the first try\n",
               family, n, incomplete[family], unsettled[family]);
  std::sort(broken.begin(), broken.end());
  for (const auto& line : broken) fmt::print("{}\n", line);
  fmt::print("{} rooms, {} broken laws, deepest contact of a settled room {:.2f} mm\n", rooms,
             broken.size(), 1e3 * deepest);
  return broken.empty() ? 0 : 1;
}
