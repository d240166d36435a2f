#pragma once
// A suite: which scenes a data set has, how they are scanned, and which part each belongs to.
// docs/reference/suite-format.md.

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/options.hpp"
#include "scenes/generator.hpp"
#include "sensors/tilting_lidar.hpp"
#include "sim/settle.hpp"

namespace scanchor {

/// An option that differs from scene to scene: uniform between the two, drawn from the scene's
/// seed.
struct Variation {
  std::string option;  ///< dotted name of a number: "room.clutter", "lidar.range_sigma"
  double minimum = 0.0;
  double maximum = 0.0;
};

/// Shares of the three parts; they need not add up to one.
struct SplitShares {
  double train = 0.7, valid = 0.15, test = 0.15;
};

struct Suite {
  std::string name = "suite";
  std::string text;  ///< what it is for, one line
  std::uint64_t seed = 1;
  int scenes = 10;
  int scans = 1;  ///< of each scene, from its sensor poses in their order (again from the first if
                  ///< there are fewer)
  SplitShares split;
  std::vector<std::pair<std::string, double>> families = {{"office", 1.0}};  ///< name and weight
  std::vector<Variation> vary;
  RoomOptions room;  ///< `family` is set from `families`, scene by scene
  SettleOptions settle;
  LidarOptions lidar;

  /// The options of the three stages: room.*, settle.*, lidar.*.
  void describe(OptionList& list);
};

/// What is to be done for one scene: a pure function of suite and index.
struct SceneTask {
  int index = 0;
  std::string name;        ///< "00", "01", ... "117": the folder of the sequence
  std::string split;       ///< "train", "valid" or "test"
  std::uint64_t seed = 0;  ///< of the room; scan k uses stream_seed(seed, "scan", k)
  RoomOptions room;
  SettleOptions settle;
  LidarOptions lidar;
};

/// Reads a YAML suite. Throws Error(bad_data), "office.yaml: line 7: unknown key 'scens'; did you
/// mean 'scenes'?".
Suite read_suite(const std::filesystem::path& path);
Suite parse_suite(const std::string& yaml, const std::string& file);

/// The first `count` scenes. Families follow their weights, and within a family the parts follow
/// their shares, as exactly as whole numbers allow (smooth weighted round robin), so a longer suite
/// begins with the scenes of a shorter one. Throws Error(bad_data) for a suite that cannot be (no
/// family with a weight above 0).
std::vector<SceneTask> scene_tasks(const Suite& suite);

/// Sets one thing of a suite from text, as `--set` gives it: an option by its dotted name, or name,
/// seed, scenes, scans. "lidar.preset" loads the preset (so it comes before what changes it),
/// "room.family" makes it the only family. Throws Error(wrong_usage).
void set_suite_option(Suite& suite, std::string_view name, std::string_view value);

/// The resolved suite with every option; what a data set's card holds.
nlohmann::ordered_json suite_to_json(const Suite& suite);

/// "2/5": the second of five parts, as --shard takes it. Index from 0. Throws Error(wrong_usage).
struct Shard {
  int index = 0, count = 1;
  [[nodiscard]] bool has(int scene) const { return scene % count == index; }
};
Shard parse_shard(std::string_view text);

}  // namespace scanchor
