#pragma once
// The stored run that a gate compares with, and why it is what it is.

#include <filesystem>
#include <string>
#include <vector>

#include "eval/run.hpp"

namespace scanchor {

struct BaselineChange {
  std::string date;  ///< "2026-11-22"
  std::string reason;
  std::vector<std::string> changes;  ///< one line each: "objects.f1: 81.20 -> 83.05"
};

struct Baseline {
  RunResult run;
  std::vector<BaselineChange> history;  ///< oldest first
};

/// What is different between two runs: metrics that moved (in points), scenes that came and went,
/// another protocol, data or method.
std::vector<std::string> describe_change(const RunResult& before, const RunResult& after);

/// The baseline with another run in its place. Throws Error(wrong_usage) without a reason of at
/// least three words, or where nothing changed.
Baseline update_baseline(const Baseline& old, RunResult run, const std::string& reason,
                         const std::string& date);

/// Without times, so that the file changes only when a count does.
void write_baseline(const std::filesystem::path& path, const Baseline& baseline);
Baseline read_baseline(const std::filesystem::path& path);

}  // namespace scanchor
