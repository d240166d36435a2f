#include "scenes/materials.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/error.hpp"

namespace scanchor {
namespace {

TEST(Materials, NoneGivesBackMoreLightThanItGets) {
  std::set<std::string> names;
  for (const auto& m : material_library()) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_GE(m.reflectance, 0.0) << m.name;
    EXPECT_LE(m.reflectance + m.specular + m.transmittance, 1.0) << m.name;
  }
}

TEST(Materials, AreAddedToASceneOnce) {
  Scene scene;
  EXPECT_EQ(use_material(scene, "beech"), 0);
  EXPECT_EQ(use_material(scene, "glass"), 1);
  EXPECT_EQ(use_material(scene, "beech"), 0);
  EXPECT_EQ(scene.materials.size(), 2U);
}

TEST(Materials, ASceneMayRedefineThem) {
  Scene scene;
  Material own;
  own.name = "beech";
  own.reflectance = 0.1;
  scene.materials.push_back(own);
  EXPECT_EQ(scene.materials[static_cast<std::size_t>(use_material(scene, "beech"))].reflectance,
            0.1);
}

TEST(Materials, UnknownOnesAreErrorsWithASuggestion) {
  Scene scene;
  try {
    use_material(scene, "beach");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'beech'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace scanchor
