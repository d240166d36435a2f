#include "core/data_folder.hpp"

#include <algorithm>
#include <cctype>
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
  std::string variable = "SCANCHOR_";
  for (const char c : kind)
    variable += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const char* own = std::getenv(variable.c_str());
  const std::string list = own != nullptr ? own : "";
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(':', begin), list.size());
    if (end > begin) found.emplace_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  if (const char* data = std::getenv("SCANCHOR_DATA")) found.push_back(fs::path(data) / kind);
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) found.push_back(program.parent_path().parent_path() / "share" / "scanchor" / kind);
#ifdef SCANCHOR_SOURCE_FOLDER
  found.push_back(fs::path(SCANCHOR_SOURCE_FOLDER) / kind);
#endif
  return found;
}

}  // namespace

std::optional<fs::path> look_up_data_file(const std::string& kind, const std::string& name,
                                          const std::string& ending) {
  std::error_code error;
  for (const auto& folder : folders(kind)) {
    const fs::path candidate = folder / (name + ending);
    if (fs::is_regular_file(candidate, error)) return candidate;
  }
  return std::nullopt;
}

fs::path find_data_file(const std::string& kind, const std::string& name_or_path,
                        const std::string& ending) {
  std::error_code error;
  if (fs::is_regular_file(name_or_path, error)) return name_or_path;
  const bool is_path = name_or_path.find('/') != std::string::npos ||
                       (name_or_path.size() > ending.size() && name_or_path.ends_with(ending));
  if (!is_path) {
    if (const auto found = look_up_data_file(kind, name_or_path, ending)) return *found;
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
