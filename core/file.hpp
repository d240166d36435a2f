#pragma once
// Files appear whole or not at all.

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace scanchor {

/// Whole content of a file. Throws Error(bad_data) that names the file and the system's reason.
std::string read_file(const std::filesystem::path& path);

/// Writes to a temporary name beside `path` and renames at the end; on any failure the temporary
/// file is removed and nothing lies under the final name. Throws Error(bad_data) with the system's
/// reason ("No space left on device", "Permission denied").
void write_file(const std::filesystem::path& path, std::string_view content);
void write_file(const std::filesystem::path& path,
                const std::function<void(std::ostream&)>& writer);

/// Makes the folder and its parents, and checks that a file can be written in it. Throws
/// Error(bad_data).
void make_folder(const std::filesystem::path& folder);

/// Lower-case hexadecimal SHA-256 of the bytes.
std::string sha256(std::string_view bytes);

}  // namespace scanchor
