#include "core/file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <stdexcept>

#include "core/error.hpp"

namespace scanchor {
namespace {
namespace fs = std::filesystem;

class FileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("scanchor_file_" +
               std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  fs::path folder_;
};

std::string message_of(const std::function<void()>& body) {
  try {
    body();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "nothing was thrown";
}

TEST_F(FileTest, ReadsBackEveryByte) {
  std::string bytes;
  for (int i = 0; i < 100000; ++i) bytes += static_cast<char>(i * 7 + i / 256);
  write_file(folder_ / "a", bytes);
  EXPECT_EQ(read_file(folder_ / "a"), bytes);
  write_file(folder_ / "a", "");
  EXPECT_EQ(read_file(folder_ / "a"), "");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(FileTest, ReadsWhatHasNoSize) { EXPECT_FALSE(read_file("/proc/self/status").empty()); }

TEST_F(FileTest, ErrorsNameTheFileAndTheSystemsReason) {
  EXPECT_NE(message_of([&] {
              (void)read_file(folder_ / "none");
            }).find("none: cannot be opened: No such file"),
            std::string::npos);
  EXPECT_NE(message_of([&] { (void)read_file(folder_); }).find("is a folder, not a file"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              write_file(folder_ / "no" / "a", "x");
            }).find("cannot be written: No such file"),
            std::string::npos);
}

TEST_F(FileTest, AFailingWriterLeavesTheOldFileAndNoOther) {
  write_file(folder_ / "a", "old");
  EXPECT_THROW(write_file(folder_ / "a",
                          [](std::ostream& out) {
                            out << "half";
                            throw std::runtime_error("stop");
                          }),
               std::runtime_error);
  EXPECT_EQ(read_file(folder_ / "a"), "old");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(FileTest, AFullDiskLeavesNothingUnderTheFinalName) {
  // The limit on the size of a file stands in for a disk that is full.
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = old;
  small.rlim_cur = 4096;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message =
      message_of([&] { write_file(folder_ / "big", std::string(1 << 20, 'x')); });
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_NE(message.find("big: cannot be written: File too large"), std::string::npos) << message;
  EXPECT_EQ(entries(), 0U);
}

TEST_F(FileTest, MakeFolderMakesParentsAndSaysWhyItCannot) {
  make_folder(folder_ / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
  EXPECT_TRUE(fs::is_empty(folder_ / "a" / "b"));
  make_folder(folder_ / "a" / "b");
  write_file(folder_ / "file", "");
  EXPECT_NE(message_of([&] { make_folder(folder_ / "file"); }).find("file"), std::string::npos);
  EXPECT_NE(message_of([&] { make_folder(folder_ / "file" / "x"); }).find("folder cannot be made"),
            std::string::npos);
}

TEST_F(FileTest, Sha256KnownAnswers) {  // FIPS 180-2, appendix B
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace scanchor
