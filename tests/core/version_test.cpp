#include "core/version.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/file.hpp"

namespace scanchor {
namespace {

TEST(Version, IsThatOfTheProject) {
  const std::string lists = read_file(std::string(SCANCHOR_SOURCE_DIR) + "/CMakeLists.txt");
  EXPECT_NE(lists.find(std::string("project(scanchor VERSION ") + scanchor_version + " "),
            std::string::npos);
}

}  // namespace
}  // namespace scanchor
