#pragma once
// A folder that is there for one test.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "core/file.hpp"

namespace scanchor::testing {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::path(::testing::TempDir()) /
            (std::string("scanchor_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// SHA-256 of every file below a folder, by its path.
inline std::map<std::string, std::string> hashes(const std::filesystem::path& root) {
  std::map<std::string, std::string> result;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.is_regular_file()) {
      result[std::filesystem::relative(entry.path(), root).generic_string()] =
          sha256(read_file(entry.path()));
    }
  }
  return result;
}

}  // namespace scanchor::testing
