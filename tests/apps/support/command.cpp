#include "tests/apps/support/command.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "core/file.hpp"

namespace scanchor::testing_support {
namespace fs = std::filesystem;

const std::string& scratch() {
  struct Folder {
    std::string path =
        (fs::temp_directory_path() / ("scanchor_apps_" + std::to_string(::getpid()))).string() +
        "/";
    Folder() { fs::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

Ran run_scanchor(const std::string& arguments) {
  const std::string out = scratch() + "stdout";
  const std::string error = scratch() + "stderr";
  const std::string line = "cd '" + scratch() + "' && '" SCANCHOR_COMMAND "' " + arguments + " >'" +
                           out + "' 2>'" + error + "' </dev/null";
  const int status = std::system(line.c_str());
  Ran ran;
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  ran.out = read_file(out);
  ran.error = read_file(error);
  return ran;
}

int lines_of(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace scanchor::testing_support
