#pragma once
// What scene.json says it is, for its writer and its reader.

namespace scanchor {

inline constexpr const char* scene_format_name = "scanchor scene 1";

}  // namespace scanchor
