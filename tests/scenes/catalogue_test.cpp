#include "scenes/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "scenes/truth.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

TEST(Catalogue, HasThirtyKindsAndMoreInSeveralVariants) {
  std::set<std::string> names;
  for (const auto& kind : furniture_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_GE(kind.variants.size(), 2U) << kind.name;
    EXPECT_NE(kind.class_id, unlabelled) << kind.name;
  }
  EXPECT_GE(names.size(), 30U);
}

// Every variant of every kind, several seeds, usual and unusual sizes: whole meshes, no tied faces,
// true numbers.
class EveryKind : public ::testing::TestWithParam<std::size_t> {};

TEST_P(EveryKind, IsSound) {
  const KindInfo& kind = furniture_kinds()[GetParam()];
  for (const auto& variant : kind.variants) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Scene scene = testing::alone({kind.name, variant, seed, {}, seed < 3 ? 0.0 : 0.5});
      const Instance& thing = scene.instances[0];
      const std::string what = kind.name + " / " + variant + " / seed " + std::to_string(seed);
      EXPECT_EQ(thing.class_id, kind.class_id);
      EXPECT_TRUE(kind.loose || !thing.loose) << what;
      EXPECT_GT(thing.mass, 0.0);
      EXPECT_LT(thing.mass, 10000.0) << what;
      ASSERT_FALSE(thing.parts.empty());
      testing::expect_no_close_faces(scene, what);
      for (const auto& part : thing.parts) {
        EXPECT_EQ(testing::open_edges(part), 0) << what << " / " << part.name;
        EXPECT_GT(testing::volume(part), 0.0) << what << " / " << part.name;
        // The faces say what their triangles are.
        Part measured = part;
        measure_faces(measured);
        for (std::size_t f = 0; f < part.faces.size(); ++f) {
          EXPECT_NEAR(measured.faces[f].area, part.faces[f].area, 1e-12)
              << what << " / " << part.name;
          if (!part.faces[f].planar) continue;
          EXPECT_NEAR((measured.faces[f].center - part.faces[f].center).norm(), 0, 1e-12)
              << what << " / " << part.name;
          EXPECT_NEAR((measured.faces[f].size - part.faces[f].size).norm(), 0, 1e-12)
              << what << " / " << part.name;
          EXPECT_LE(part.faces[f].area, part.faces[f].size.prod() + 1e-12) << what;
        }
      }
      const Eigen::AlignedBox3d bounds = local_bounds(thing);
      EXPECT_LT(bounds.sizes().maxCoeff(), 6.0) << what;
      EXPECT_LT(triangle_count(scene), 2500U) << what;
      if (kind.place == Place::floor || kind.place == Place::surface) {
        // On the floor or a hair above it: loose things lie, fixed ones stand on glides of 1.5 mm.
        EXPECT_GE(bounds.min().z(), -1e-12) << what;
        EXPECT_LE(bounds.min().z(), 0.0031) << what;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryKind,
                         ::testing::Range(std::size_t{0}, furniture_kinds().size()),
                         [](const auto& kind) {
                           std::string name = furniture_kinds()[kind.param].name;
                           for (char& c : name) c = c == ' ' ? '_' : c;
                           return name;
                         });

TEST(Catalogue, TheSameRequestGivesTheSameThing) {
  for (const auto& kind : furniture_kinds()) {
    const std::string a = scene_to_json(testing::alone({kind.name, "", 5, {}, 0.0})).dump();
    EXPECT_EQ(a, scene_to_json(testing::alone({kind.name, "", 5, {}, 0.0})).dump()) << kind.name;
    bool differs = false;
    for (std::uint64_t seed = 6; seed < 16; ++seed)
      differs =
          differs || a != scene_to_json(testing::alone({kind.name, "", seed, {}, 0.0})).dump();
    EXPECT_TRUE(differs) << kind.name;
  }
}

TEST(Catalogue, FixingOneParameterLeavesTheOthers) {
  Scene scene;
  const Instance drawn = make_furniture(scene, {"shelf", "with sides", 9, {}, 0.0});
  const Instance fixed = make_furniture(scene, {"shelf", "with sides", 9, {{"boards", 5}}, 0.0});
  EXPECT_EQ(fixed.parameters.at("boards"), 5);
  EXPECT_EQ(fixed.parameters.at("width"), drawn.parameters.at("width"));
  EXPECT_EQ(fixed.parameters.at("depth"), drawn.parameters.at("depth"));
}

TEST(Catalogue, UnusualSizesFallOutsideTheUsualRange) {
  Scene scene;
  int outside = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const double usual =
        make_furniture(scene, {"table", "four legs", seed, {}, 0.0}).parameters.at("height");
    EXPECT_GE(usual, 0.72);
    EXPECT_LE(usual, 0.78);
    const double odd =
        make_furniture(scene, {"table", "four legs", seed, {}, 1.0}).parameters.at("height");
    outside += odd < 0.72 || odd > 0.78 ? 1 : 0;
  }
  EXPECT_EQ(outside, 200);
}

TEST(Catalogue, MistakesNameWhatIsKnown) {
  Scene scene;
  const auto line = [&](const FurnitureRequest& request) {
    try {
      make_furniture(scene, request);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::wrong_usage);
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(line({"dexk", "", 0, {}, 0.0}).find("'desk'"), std::string::npos);
  EXPECT_NE(line({"desk", "four leg", 0, {}, 0.0}).find("'four legs'"), std::string::npos);
  EXPECT_NE(line({"desk", "four legs", 0, {{"with", 1.0}}, 0.0}).find("'width'"),
            std::string::npos);
  EXPECT_NE(line({"desk", "four legs", 0, {{"width", -1.0}}, 0.0}).find("0 .. 100"),
            std::string::npos);
}

// docs/gallery is drawn by `scanchor gallery`: nothing may be missing from it.
TEST(Catalogue, EveryKindAndFamilyIsInTheGallery) {
  const std::filesystem::path gallery = std::filesystem::path(SCANCHOR_SOURCE_DIR) / "docs/gallery";
  const std::string page = read_file(gallery / "README.md");
  const auto expect_picture = [&](const std::string& folder, std::string name) {
    std::replace(name.begin(), name.end(), ' ', '-');
    const std::string file = folder + "/" + name + ".png";
    EXPECT_TRUE(std::filesystem::exists(gallery / file)) << file;
    EXPECT_NE(page.find("(" + file + ")"), std::string::npos) << file << " is not on the page";
  };
  for (const auto& kind : furniture_kinds()) {
    expect_picture("furniture", kind.name);
    for (const auto& variant : kind.variants)
      EXPECT_NE(page.find(variant), std::string::npos) << kind.name << ": " << variant;
  }
  for (const auto& family : room_families()) expect_picture("rooms", family);
}

}  // namespace
}  // namespace scanchor
