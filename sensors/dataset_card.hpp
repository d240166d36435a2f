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
  bool settled = false;
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

/// faces.json: for every face its exact geometry in the world, and in each scan its points and the
/// share that was visible.
std::string faces_json(const Scene& scene,
                       const std::vector<std::vector<FaceVisibility>>& visibility);
/// relations.json: the exact relations between the things of a room, with their margins.
std::string relations_json(const Scene& scene);
/// The visibility of one scan back.
std::vector<FaceVisibility> read_face_visibility(const std::filesystem::path& path,
                                                 std::size_t scan);

}  // namespace scanchor
