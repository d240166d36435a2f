// One SHA-256 over all files of a data set of 20 scans, for every instruction set, packet width and
// number of threads: they must be the same.
//   hashes_bench [SUITE [PRESET]]     default: mixed, as the suite says
//
// Exit code 1 where one differs.

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <set>

#include "core/data_folder.hpp"
#include "core/file.hpp"
#include "sensors/dataset.hpp"

namespace scanchor {
namespace fs = std::filesystem;
namespace {

/// Of the hashes of all files by name.
std::string hash_of(const fs::path& root) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.is_regular_file())
      files[fs::relative(entry.path(), root).generic_string()] = sha256(read_file(entry.path()));
  }
  std::string all;
  for (const auto& [name, hash] : files) all += name + " " + hash + "\n";
  return sha256(all);
}

int run(const std::string& name, const std::string& preset) {
  Suite suite = read_suite(find_data_file("suites", name, ".yaml"));
  suite.scenes = 10;
  suite.scans = 2;
  if (!preset.empty()) suite.lidar = lidar_preset(preset);
  const fs::path folder = fs::temp_directory_path() / "scanchor_hashes_bench";
  std::set<std::string> seen;
  for (const char* isa : {"", "sse2", "avx2"}) {
    for (const int width : {1, 8, 16}) {
      for (const int threads : {1, 2}) {
        fs::remove_all(folder);
        DatasetOptions options;
        options.threads = threads;
        options.world.embree_isa = isa;
        options.world.packet_width = width;
        const DatasetResult result = generate_dataset(suite, folder, options);
        const std::string hash = hash_of(folder);
        seen.insert(hash);
        fmt::print("{:7} width {:2} threads {}: {} scans, {} points, {}\n",
                   *isa == 0 ? "default" : isa, width, threads, result.scans_written,
                   result.points_written, hash);
      }
    }
  }
  fs::remove_all(folder);
  fmt::print("{}\n", seen.size() == 1 ? "all the same" : "THEY DIFFER");
  return seen.size() == 1 ? 0 : 1;
}

}  // namespace
}  // namespace scanchor

int main(int argc, char** argv) {
  return scanchor::run(argc > 1 ? argv[1] : "mixed", argc > 2 ? argv[2] : "");
}
