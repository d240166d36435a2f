#pragma once
// The library of materials: what things are made of, with how they answer light of 905 nm.

#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace scanchor {

/// All materials by name. Sources and caveats: docs/reference/furniture.md, "Materials".
const std::vector<Material>& material_library();

/// Index of a material of the scene by name; taken from the library where the scene has none of
/// that name. Throws Error(wrong_usage) with a suggestion where both know none.
int use_material(Scene& scene, const std::string& name);

}  // namespace scanchor
