#pragma once
// Where the files lie that come with the program: ontologies/, suites/, protocols/.

#include <filesystem>
#include <string>
#include <vector>

namespace scanchor {

/// Finds "office" of kind "ontologies" with ending ".sdl". In this order: the name as a path;
/// $SCANCHOR_DATA/<kind>; share/scanchor/<kind> beside the running program's folder (an installed
/// copy may be moved); <kind> of the source tree it was built from. Throws Error(bad_data) that
/// lists the names there are.
std::filesystem::path find_data_file(const std::string& kind, const std::string& name_or_path,
                                     const std::string& ending);

/// Names (without ending) of all files of a kind, sorted, each once.
std::vector<std::string> list_data_files(const std::string& kind, const std::string& ending);

}  // namespace scanchor
