#include "scenes/materials.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

namespace scanchor {

const std::vector<Material>& material_library() {
  // name, reflectance at 905 nm, specular, transmittance, colour
  static const std::vector<Material> library = {
      {"paint white", 0.85, 0.0, 0.0, {238, 238, 232}},
      {"paint grey", 0.45, 0.0, 0.0, {150, 152, 155}},
      {"paint blue", 0.45, 0.0, 0.0, {96, 128, 170}},
      {"paint orange", 0.60, 0.0, 0.0, {226, 112, 38}},
      {"concrete", 0.35, 0.0, 0.0, {150, 148, 142}},
      {"carpet grey", 0.30, 0.0, 0.0, {112, 114, 118}},
      {"carpet blue", 0.35, 0.0, 0.0, {72, 84, 112}},
      {"linoleum", 0.40, 0.02, 0.0, {168, 160, 142}},
      {"parquet", 0.55, 0.02, 0.0, {176, 128, 82}},
      {"tile", 0.60, 0.05, 0.0, {206, 204, 198}},
      {"ceiling panel", 0.80, 0.0, 0.0, {236, 236, 234}},
      {"beech", 0.65, 0.0, 0.0, {214, 172, 122}},
      {"oak", 0.60, 0.0, 0.0, {186, 142, 92}},
      {"walnut", 0.45, 0.0, 0.0, {104, 70, 46}},
      {"raw wood", 0.60, 0.0, 0.0, {200, 164, 112}},
      {"melamine white", 0.82, 0.02, 0.0, {232, 232, 228}},
      {"melamine grey", 0.50, 0.02, 0.0, {168, 170, 172}},
      {"steel painted", 0.45, 0.03, 0.0, {132, 136, 142}},
      {"steel blue", 0.40, 0.03, 0.0, {42, 78, 134}},
      {"steel orange", 0.55, 0.03, 0.0, {224, 106, 30}},
      {"stainless steel", 0.35, 0.30, 0.0, {190, 194, 196}},
      {"chrome", 0.20, 0.60, 0.0, {206, 210, 214}},
      {"aluminium", 0.50, 0.15, 0.0, {184, 186, 190}},
      {"enamel white", 0.80, 0.05, 0.0, {240, 240, 240}},
      {"plastic black", 0.07, 0.02, 0.0, {34, 34, 36}},
      {"plastic grey", 0.35, 0.02, 0.0, {120, 122, 126}},
      {"plastic white", 0.78, 0.02, 0.0, {226, 226, 222}},
      {"plastic blue", 0.45, 0.02, 0.0, {40, 92, 168}},
      {"screen", 0.08, 0.04, 0.0, {18, 20, 26}},
      {"fabric black", 0.30, 0.0, 0.0, {44, 44, 48}},
      {"fabric grey", 0.45, 0.0, 0.0, {128, 128, 132}},
      {"fabric blue", 0.45, 0.0, 0.0, {58, 82, 132}},
      {"fabric red", 0.50, 0.0, 0.0, {150, 50, 52}},
      {"fabric beige", 0.60, 0.0, 0.0, {196, 180, 152}},
      {"linen white", 0.80, 0.0, 0.0, {236, 234, 228}},
      {"leather black", 0.20, 0.03, 0.0, {36, 32, 30}},
      {"rubber", 0.05, 0.0, 0.0, {30, 30, 30}},
      {"cardboard", 0.55, 0.0, 0.0, {178, 138, 92}},
      {"paper", 0.85, 0.0, 0.0, {240, 238, 230}},
      {"book red", 0.55, 0.0, 0.0, {148, 40, 44}},
      {"book green", 0.50, 0.0, 0.0, {50, 104, 70}},
      {"book blue", 0.50, 0.0, 0.0, {46, 66, 120}},
      {"glass", 0.02, 0.08, 0.88, {176, 206, 214}},
      {"bottle glass", 0.15, 0.08, 0.60, {70, 120, 84}},
      {"mirror", 0.0, 0.95, 0.0, {200, 212, 220}},
      {"ceramic", 0.80, 0.05, 0.0, {236, 232, 224}},
      {"terracotta", 0.50, 0.0, 0.0, {176, 92, 60}},
      {"soil", 0.25, 0.0, 0.0, {70, 52, 40}},
      {"leaf", 0.48, 0.0, 0.05, {60, 122, 50}},
      {"skin", 0.55, 0.0, 0.0, {218, 170, 142}},
      {"lampshade", 0.70, 0.0, 0.15, {244, 236, 206}},
      {"canvas", 0.60, 0.0, 0.0, {168, 150, 120}},
  };
  return library;
}

int use_material(Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    if (scene.materials[i].name == name) return static_cast<int>(i);
  }
  std::vector<std::string> names;
  for (const auto& material : scene.materials) names.push_back(material.name);
  for (const auto& material : material_library()) {
    if (material.name == name) {
      scene.materials.push_back(material);
      return static_cast<int>(scene.materials.size()) - 1;
    }
    names.push_back(material.name);
  }
  fail_usage("unknown material '" + name + "'", suggestion(name, names));
}

}  // namespace scanchor
