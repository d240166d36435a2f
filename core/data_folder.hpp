#pragma once
// Where the files lie that come with the program: ontologies/, suites/, protocols/.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scanchor {

/// Finds "office" of kind "ontologies" with ending ".sdl". In this order: the name as a path; the
/// folders of $SCANCHOR_<KIND> (SCANCHOR_ONTOLOGIES), separated by ':'; $SCANCHOR_DATA/<kind>;
/// share/scanchor/<kind> beside the running program's folder (an installed copy may be moved);
/// <kind> of the source tree it was built from. Throws Error(bad_data) that lists the names there
/// are.
std::filesystem::path find_data_file(const std::string& kind, const std::string& name_or_path,
                                     const std::string& ending);

/// The same without the name as a path, and nothing where there is no such name.
std::optional<std::filesystem::path> look_up_data_file(const std::string& kind,
                                                       const std::string& name,
                                                       const std::string& ending);

/// Names (without ending) of all files of a kind, sorted, each once.
std::vector<std::string> list_data_files(const std::string& kind, const std::string& ending);

}  // namespace scanchor
