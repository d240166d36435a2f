// Every test runs in a process of its own and many at once: each gets an empty folder for its
// files, which goes when it ends, so that two tests may use the same file names.
#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {
namespace fs = std::filesystem;

class OwnFolder {
 public:
  OwnFolder() {
    std::string name = (fs::temp_directory_path() / "scanchor-tests-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      std::perror(name.c_str());
      std::exit(1);
    }
    path_ = name;
    setenv("TMPDIR", name.c_str(), 1);               // std::filesystem::temp_directory_path
    setenv("TEST_TMPDIR", (name + "/").c_str(), 1);  // testing::TempDir
  }
  ~OwnFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

 private:
  fs::path path_;
};
}  // namespace

int main(int argc, char** argv) {
  const OwnFolder folder;
  testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
