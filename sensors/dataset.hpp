#pragma once
// Data sets on disk: the SemanticKITTI layout with the truth beside it.
// docs/reference/dataset-layout.md.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "sensors/scan.hpp"
#include "sensors/suite.hpp"
#include "sim/world.hpp"

namespace scanchor {

/// What is written beside the SemanticKITTI files.
struct DatasetFormats {
  bool truth = true;   ///< truth/NNNNNN.npy: face, part, runner-up, flags, line, beam, true range
                       ///< and incidence of each point
  bool pcd = false;    ///< pcd/NNNNNN.pcd with all truth as fields
  bool ply = false;    ///< ply/NNNNNN.ply with all truth as fields
  bool s3dis = false;  ///< S3DIS text below Area_1 (train), Area_2 (valid), Area_5 (test)
  bool operator==(const DatasetFormats&) const = default;
};

struct DatasetOptions {
  int threads = 0;  ///< 0: as many as there are cores. The bytes do not depend on it
  Shard shard;      ///< only the scenes of this part
  DatasetFormats formats;
  WorldOptions world;  ///< packets and instruction set: the bytes do not depend on them either
  /// Called once at the start with the scans that an earlier run had done, then after each scan;
  /// from any thread but never from two at once.
  std::function<void(std::size_t scans_done, std::size_t scans_total)> progress;
  /// Set it (from a signal handler, say) and the work ends after the scans that are under way; a
  /// later call goes on from there.
  const std::atomic<bool>* stop = nullptr;
};

struct DatasetResult {
  int scenes_written = 0;
  int scenes_found = 0;     ///< complete from an earlier run
  int rooms_made_anew = 0;  ///< of those, rooms whose first try lacked something or did not settle
  std::size_t scans_written = 0;
  std::size_t points_written = 0;
  bool interrupted = false;
  bool complete = false;  ///< all scenes of all shards are there, dataset.json is written
  std::vector<std::string> problems;  ///< what is wrong with scenes all the same, one line each
};

/// Generates what is missing of the data set in `out`: scenes that an earlier run completed are
/// kept, so an interrupted run goes on, and shards that were laid side by side are finished by a
/// call without work. Each file appears whole or not at all, and the same suite gives the same
/// bytes for any number of threads, shards and interruptions. Throws Error(bad_data) if `out` holds
/// another data set or cannot be written to.
DatasetResult generate_dataset(const Suite& suite, const std::filesystem::path& out,
                               const DatasetOptions& options = {});

/// One sequence: one scene and its scans.
struct DatasetSequence {
  std::string name;                ///< "00"
  std::string split;               ///< "train", "valid", "test"; empty: the data set does not say
  std::filesystem::path folder;    ///< .../sequences/00
  std::vector<std::string> scans;  ///< "000000", in order
};

struct Dataset {
  std::filesystem::path root;
  std::string name;  ///< of the suite; empty for a data set of somebody else
  std::vector<DatasetSequence> sequences;
};

/// Finds the sequences below `root`/sequences: of our own data sets and of anybody's in the
/// SemanticKITTI layout. Throws Error(bad_data) if there are none.
Dataset read_dataset(const std::filesystem::path& root);

/// The scene of a sequence. Throws Error(bad_data) where there is no scene.json (somebody else's
/// data set).
Scene read_dataset_scene(const DatasetSequence& sequence);
/// Scan `index` of a sequence with all truth that is there: class and instance from .label, the
/// rest from truth/*.npy and faces.json, the pose from poses.txt and calib.txt. Positions are
/// float32, as the .bin holds them.
Scan read_dataset_scan(const DatasetSequence& sequence, std::size_t index);

/// Compares every file with the SHA-256 of the data-set card; one line for each that is missing,
/// changed or not in the card.
std::vector<std::string> verify_dataset(const std::filesystem::path& root);

}  // namespace scanchor
