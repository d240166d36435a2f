#include "core/data_folder.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include "core/error.hpp"
#include "core/file.hpp"

namespace scanchor {
namespace {

class DataFolder : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("scanchor_data_" + std::to_string(::getpid()));
    make_folder(folder_ / "words");
    write_file(folder_ / "words" / "office.sdl", "x");
    write_file(folder_ / "words" / "storage.sdl", "x");
    ::setenv("SCANCHOR_DATA", folder_.c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("SCANCHOR_DATA");
    std::filesystem::remove_all(folder_);
  }
  std::filesystem::path folder_;
};

TEST_F(DataFolder, FindsANameAndAPath) {
  EXPECT_EQ(find_data_file("words", "office", ".sdl"), folder_ / "words" / "office.sdl");
  const auto path = (folder_ / "words" / "storage.sdl").string();
  EXPECT_EQ(find_data_file("words", path, ".sdl"), path);
  EXPECT_EQ(list_data_files("words", ".sdl"), (std::vector<std::string>{"office", "storage"}));
}

TEST_F(DataFolder, AMissingNameIsOneLineWithTheNearestName) {
  try {
    find_data_file("words", "ofice", ".sdl");
    FAIL() << "found a file that is not there";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    EXPECT_NE(std::string(error.what()).find("did you mean 'office'?"), std::string::npos)
        << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
  EXPECT_THROW(find_data_file("words", "nowhere/office.sdl", ".sdl"), Error);
}

TEST_F(DataFolder, FoldersOfAVariableComeFirst) {
  make_folder(folder_ / "own");
  write_file(folder_ / "own" / "office.sdl", "y");
  write_file(folder_ / "own" / "mine.sdl", "y");
  ::setenv("SCANCHOR_WORDS", (":/nowhere:" + (folder_ / "own").string()).c_str(), 1);
  EXPECT_EQ(look_up_data_file("words", "office", ".sdl"), folder_ / "own" / "office.sdl");
  EXPECT_EQ(look_up_data_file("words", "storage", ".sdl"), folder_ / "words" / "storage.sdl");
  EXPECT_EQ(look_up_data_file("words", "absent", ".sdl"), std::nullopt);
  EXPECT_EQ(list_data_files("words", ".sdl"),
            (std::vector<std::string>{"mine", "office", "storage"}));
  ::unsetenv("SCANCHOR_WORDS");
}

}  // namespace
}  // namespace scanchor
