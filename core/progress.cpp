#include "core/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <utility>

namespace scanchor {
namespace {

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::min(seconds, 1e12) + 0.5);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

/// Three figures that count, never in the form 1e+03.
std::string rate_text(double rate) {
  const int before = rate > 0.0 ? static_cast<int>(std::floor(std::log10(rate))) : 0;
  return fmt::format("{:.{}f}/s", rate, std::max(0, 2 - before));
}

}  // namespace

std::string progress_line(const std::string& what, std::size_t done, std::size_t total,
                          double seconds, std::size_t before) {
  std::string line = total > 0
                         ? fmt::format("{} {}/{} ({} %)", what, done, total, done * 100 / total)
                         : fmt::format("{} {}", what, done);
  if (done <= before || seconds <= 0.0) return line;
  const double rate = static_cast<double>(done - before) / seconds;
  line += ", " + rate_text(rate);
  if (total > 0) {
    line += fmt::format(", {} left",
                        duration(static_cast<double>(total > done ? total - done : 0) / rate));
  }
  return line;
}

Progress::Progress(std::string what, std::size_t total, const ProgressOptions& options)
    : what_(std::move(what)), total_(total), options_(options) {
  if (!options_.terminal) options_.terminal = ::isatty(::fileno(options_.stream)) == 1;
}

Progress::~Progress() {
  if (!visible_) return;
  std::fputs("\r\x1b[K", options_.stream);
  std::fflush(options_.stream);
}

void Progress::update(std::size_t done) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  show();
}

void Progress::update(std::size_t done, std::size_t total) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  total_ = total;
  show();
}

void Progress::add(std::size_t more) {
  const std::lock_guard lock(mutex_);
  done_ += more;
  show();
}

void Progress::resume(std::size_t done) {
  const std::lock_guard lock(mutex_);
  before_ = done;
  done_ = done;
  start_ = Clock::now();
}

void Progress::show() {
  if (options_.quiet || !*options_.terminal) return;
  const auto now = Clock::now();
  const auto since = [now](Clock::time_point then) {
    return std::chrono::duration<double>(now - then).count();
  };
  if (since(start_) < options_.delay || (visible_ && since(shown_) < options_.interval)) return;
  shown_ = now;
  visible_ = true;
  std::fprintf(options_.stream, "\r%s\x1b[K",
               progress_line(what_, done_, total_, since(start_), before_).c_str());
  std::fflush(options_.stream);
}

}  // namespace scanchor
