#pragma once
// The line that long work shows on a terminal.

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>

namespace scanchor {

struct ProgressOptions {
  bool quiet = false;              ///< never show anything
  std::optional<bool> terminal{};  ///< empty: ask the system whether `stream` is one
  double delay = 2.0;              ///< [s] work shorter than this shows nothing
  double interval = 0.2;           ///< [s] between two changes of the line
  std::FILE* stream = stderr;      ///< answers go to stdout, this does not
};

/// "scans 250/1000 (25 %), 25.0/s, 30 s left". `total` 0: unknown, then without share and time
/// left. `seconds` since the start. `before`: what an earlier run had done; it counts for the share
/// but not for the rate.
std::string progress_line(const std::string& what, std::size_t done, std::size_t total,
                          double seconds, std::size_t before = 0);

/// Shows one line that changes in place and takes it away when it dies. May be called from any
/// thread.
class Progress {
 public:
  Progress(std::string what, std::size_t total, const ProgressOptions& options = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done);
  /// The same where the total is known only now.
  void update(std::size_t done, std::size_t total);
  void add(std::size_t more = 1);
  /// What an earlier run had done.
  void resume(std::size_t done);

 private:
  void show();
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::size_t total_;
  ProgressOptions options_;
  std::mutex mutex_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_{};
  std::size_t done_ = 0, before_ = 0;
  bool visible_ = false;
};

}  // namespace scanchor
