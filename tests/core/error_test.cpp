#include "core/error.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

TEST(Error, JoinsFilePlaceCauseAndRemedy) {
  try {
    fail_data("a.pcd", "line 3", "POINTS is missing", "add it");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a.pcd: line 3: POINTS is missing; add it");
    EXPECT_EQ(error.code(), ExitCode::bad_data);
  }
}

TEST(Error, LeavesEmptyPartsOut) {
  const auto line = [](const char* file, const char* place) {
    try {
      fail_data(file, place, "is empty");
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(line("a", ""), "a: is empty");
  EXPECT_EQ(line("", "byte 3"), "byte 3: is empty");
  EXPECT_EQ(line("", ""), "is empty");
}

TEST(Error, UsageHasItsOwnCode) {
  try {
    fail_usage("no such verb", "did you mean 'scan'?");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "no such verb; did you mean 'scan'?");
    EXPECT_EQ(static_cast<int>(error.code()), 2);
  }
}

}  // namespace
}  // namespace scanchor
