#pragma once
// Somebody's program as a method: it gets a scan as a file and leaves a prediction as a file.

#include <filesystem>
#include <string>

#include "eval/predictions.hpp"
#include "eval/run.hpp"

namespace scanchor {

struct ExternalOptions {
  std::string command;  ///< "mypipeline {scan} {out}": run by /bin/sh, {scan} and {out} replaced by
                        ///< quoted paths
  double time_limit = 60.0;          ///< [s] for one scan, then it and what it started are killed
  std::string scan_format = "pcd";   ///< "pcd", "ply" or "bin": what {scan} is; without any truth
  std::string out_format = "label";  ///< "label", "ply", "pcd" or "json": what {out} must be
  std::filesystem::path
      folder;  ///< for the files; empty: a folder of its own below the system's, removed at the end
  PredictionOptions predictions;
};

/// Throws Error(wrong_usage) where the command does not say {scan} and {out}.
/// Its answer throws Error(bad_data) with one line: "exit code 3: last line of its error output",
/// "killed by signal 11", "killed after 60 s", "left no file", or what read_prediction finds wrong.
/// Scans are given one at a time to each thread.
Method external_method(const ExternalOptions& options);

/// What a program did.
struct ProcessResult {
  int exit_code = 0;  ///< -1: it did not end by itself
  int signal = 0;     ///< that ended it, 0: none
  bool timed_out = false;
  double seconds = 0;
  std::string error_output;  ///< the last 4 kB
};

/// Runs a command by /bin/sh in a process group of its own, its input empty, its output dropped.
ProcessResult run_process(const std::string& command, double time_limit,
                          const std::filesystem::path& error_file);

}  // namespace scanchor
