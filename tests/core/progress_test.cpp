#include "core/progress.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <thread>

namespace scanchor {
namespace {

TEST(Progress, LineHasShareRateAndTimeLeft) {
  EXPECT_EQ(progress_line("scans", 250, 1000, 10.0), "scans 250/1000 (25 %), 25.0/s, 30 s left");
  EXPECT_EQ(progress_line("scans", 999, 100000, 10.0),
            "scans 999/100000 (0 %), 99.9/s, 16 min 31 s left");
  EXPECT_EQ(progress_line("scenes", 1, 1000, 30.0),
            "scenes 1/1000 (0 %), 0.0333/s, 8 h 19 min left");
  EXPECT_EQ(progress_line("scenes", 0, 5, 3.0), "scenes 0/5 (0 %)");
  EXPECT_EQ(progress_line("scenes", 5, 5, 5.0), "scenes 5/5 (100 %), 1.00/s, 0 s left");
  EXPECT_EQ(progress_line("scans", 600, 1000, 10.0, 500),
            "scans 600/1000 (60 %), 10.0/s, 40 s left")
      << "resumed at 500";
  EXPECT_EQ(progress_line("points", 7, 0, 7.0), "points 7, 1.00/s");
}

std::string output_of(const ProgressOptions& options, bool wait) {
  std::FILE* file = std::tmpfile();
  ProgressOptions with_file = options;
  with_file.stream = file;
  {
    Progress progress("scans", 10, with_file);
    progress.update(1);
    if (wait) std::this_thread::sleep_for(std::chrono::milliseconds(30));
    progress.update(5);
    progress.add(2);
    progress.update(8, 20);
  }
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  std::fclose(file);
  return text;
}

TEST(Progress, SilentWhereNobodyLooks) {
  EXPECT_EQ(output_of({}, true), "") << "a file is no terminal";
  EXPECT_EQ(output_of({.quiet = true, .terminal = true, .delay = 0.0}, true), "");
  EXPECT_EQ(output_of({.terminal = true}, true), "") << "short work needs no progress line";
}

TEST(Progress, OneLineThatIsTakenAwayAtTheEnd) {
  const std::string text = output_of({.terminal = true, .delay = 0.01, .interval = 0.0}, true);
  EXPECT_NE(text.find("\rscans 5/10 (50 %)"), std::string::npos) << text;
  EXPECT_NE(text.find("\rscans 7/10 (70 %)"), std::string::npos) << text;
  EXPECT_NE(text.find("\rscans 8/20 (40 %)"), std::string::npos) << text;
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 4), "\r\x1b[K");
}

}  // namespace
}  // namespace scanchor
