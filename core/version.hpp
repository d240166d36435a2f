#pragma once
// The version of the program, as data sets and reports name it.

namespace scanchor {

/// The same as project(... VERSION ...) in CMakeLists.txt; a test compares them.
inline constexpr const char* scanchor_version = "0.1.0";

}  // namespace scanchor
