#include "core/data_folder.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "core/error.hpp"
#include "core/text.hpp"

namespace scanchor {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> folders(const std::string& kind) {
  std::vector<fs::path> found;
  std::error_code error;
  if (const char* data = std::getenv("SCANCHOR_DATA")) found.push_back(fs::path(data) / kind);
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) found.push_back(program.parent_path().parent_path() / "share" / "scanchor" / kind);
#ifdef SCANCHOR_SOURCE_FOLDER
  found.push_back(fs::path(SCANCHOR_SOURCE_FOLDER) / kind);
#endif
  return found;
}

}  // namespace

fs::path find_data_file(const std::string& kind, const std::string& name_or_path,
                        const std::string& ending) {
  std::error_code error;
  if (fs::is_regular_file(name_or_path, error)) return name_or_path;
  const bool is_path = name_or_path.find('/') != std::string::npos ||
                       (name_or_path.size() > ending.size() && name_or_path.ends_with(ending));
  if (!is_path) {
    for (const auto& folder : folders(kind)) {
      const fs::path candidate = folder / (name_or_path + ending);
      if (fs::is_regular_file(candidate, error)) return candidate;
    }
  }
  const auto known = list_data_files(kind, ending);
  fail_data(name_or_path, "", is_path ? "no such file" : "no such name among the " + kind,
            known.empty() ? "" : suggestion(name_or_path, known));
}

std::vector<std::string> list_data_files(const std::string& kind, const std::string& ending) {
  std::vector<std::string> names;
  for (const auto& folder : folders(kind)) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace scanchor
