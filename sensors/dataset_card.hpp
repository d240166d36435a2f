#pragma once
// The JSON beside a data set's points: what each sequence holds, and the card of the whole.
// Internal to dataset*.cpp.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sensors/dataset.hpp"

namespace scanchor {

struct FileRecord {
  std::uint64_t bytes = 0;
  std::string sha256;
};

struct ClassCount {
  std::uint64_t points = 0;
  std::uint64_t instances = 0;  ///< with at least one point
  std::uint64_t scenes = 0;     ///< with at least one point
};

/// What sequence.json says: it is written last and marks the sequence as complete.
struct SequenceCard {
  std::string name, split, family;
  std::uint64_t seed = 0;
  std::uint64_t tries = 1;  ///< rooms that were furnished until this one was complete and at rest
  bool complete = false, settled = false;
  std::vector<std::string> problems;
  std::vector<std::uint64_t> scan_seeds, scan_points, scan_beams;
  std::map<std::int32_t, ClassCount> classes;
  std::array<std::uint64_t, 4> flagged{};   ///< points with each bit of PointFlag
  std::map<std::string, FileRecord> files;  ///< by their path below the data set's root
};

void write_sequence_card(const std::filesystem::path& path, const SequenceCard& card);
/// Throws Error(bad_data).
SequenceCard read_sequence_card(const std::filesystem::path& path);

/// suite.json: every parameter, the formats and the version of the program; the same bytes in every
/// shard.
std::string suite_card(const Suite& suite, const DatasetFormats& formats);
/// label_map.yaml in the form of semantic-kitti-api's configuration files.
std::string label_map_yaml(const std::vector<SequenceCard>& cards, const std::string& name);
/// Writes dataset.json and label_map.yaml.
void write_dataset_card(const std::filesystem::path& root, const Suite& suite,
                        const DatasetFormats& formats, const std::vector<SequenceCard>& cards);

}  // namespace scanchor
