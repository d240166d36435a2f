// scanchor gallery: a picture of every kind of furniture and of every family of rooms.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "apps/command.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "results/image.hpp"
#include "results/pictures.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/generator.hpp"
#include "scenes/materials.hpp"
#include "scenes/pose.hpp"
#include "scenes/shell.hpp"
#include "sim/settle.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct GalleryArguments {
  Common common;
  std::string out = "gallery";
  std::string only;
  std::uint64_t seed = 60;
};

/// "pallet rack" -> "pallet-rack".
std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '-');
  return name + ".png";
}

/// All variants of a kind side by side as a visitor would see them, on a floor where they stand on
/// one.
Scene all_variants(const KindInfo& kind, std::uint64_t seed) {
  Scene scene;
  double right = 0.0;
  double tallest = 0.0;
  Eigen::AlignedBox3d all;
  for (const std::string& variant : kind.variants) {
    Instance thing = make_furniture(scene, {kind.name, variant, seed, {}, 0.0});
    const Eigen::AlignedBox3d bounds = local_bounds(thing);
    const double gap = right > 0.0 ? 0.15 + 0.1 * bounds.sizes().x() : 0.0;
    thing.T_world_instance = pose_at({right + gap - bounds.min().x(), 0, 0});
    right += gap + bounds.sizes().x();
    tallest = std::max(tallest, bounds.sizes().z());
    thing.id = next_id(scene);
    all.extend(world_bounds(thing));
    scene.instances.push_back(std::move(thing));
  }
  if (kind.place == Place::floor || kind.place == Place::surface) {
    Instance floor;
    floor.id = next_id(scene);
    floor.kind = "floor";
    floor.class_id = *find_class("floor");
    const double rim = 0.1 * std::max(right, tallest);
    const Eigen::Vector3d size(all.sizes().x() + 2 * rim, all.sizes().y() + 2 * rim, 0.02);
    const Eigen::Vector3d center(all.center().x(), all.center().y(), -0.01);
    floor.parts.push_back(box_part("floor", use_material(scene, "linoleum"), center, size));
    scene.instances.push_back(std::move(floor));
  }
  return scene;
}

PictureOptions small_picture(const std::string& title, int width, int height) {
  PictureOptions options;
  options.title = title;
  options.render.width = width;
  options.render.height = height;
  options.render.legend = false;
  options.render.labels = false;
  options.render.axes = false;
  return options;
}

int run_gallery(const GalleryArguments& arguments) {
  const fs::path root = arguments.out;
  std::vector<std::string> names;
  Json json = Json::array();
  const auto wanted = [&](const std::string& name) {
    names.push_back(name);
    return arguments.only.empty() || arguments.only == name;
  };
  const auto keep = [&](const fs::path& file, const Image& image) {
    make_folder(file.parent_path());
    write_png(file, image);
    json.push_back(file.string());
    say(arguments.common, file.string());
  };
  for (const KindInfo& kind : furniture_kinds()) {
    if (!wanted(kind.name)) continue;
    PictureOptions options = small_picture(kind.name, 400, 240);
    options.azimuth_deg = -115.0;
    options.elevation_deg = 25.0;
    keep(root / "furniture" / file_name(kind.name),
         picture_of_scene(all_variants(kind, arguments.seed), options, SceneColor::material));
  }
  for (const std::string& family : room_families()) {
    if (!wanted(family)) continue;
    RoomOptions room;
    room.family = family;
    Scene scene = generate_room(room, arguments.seed);
    settle(scene, {});
    keep(root / "rooms" / file_name(family),
         picture_of_scene(
             scene, small_picture(fmt::format("{}, seed {}", family, arguments.seed), 600, 360),
             SceneColor::material));
  }
  if (json.empty()) {
    fail_usage(
        "--only: no kind of furniture and no family of rooms is called '" + arguments.only + "'",
        suggestion(arguments.only, names));
  }
  answer(arguments.common, json);
  return 0;
}

}  // namespace

void add_gallery(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("gallery", "A picture of every kind of furniture and of rooms");
  verb->footer(
      "Examples:\n  scanchor gallery --out gallery\n"
      "  scanchor gallery --only \"pallet rack\" --seed 7 --out rack");
  auto arguments = std::make_shared<GalleryArguments>();
  verb->add_option("--out", arguments->out, "Folder")->type_name("DIR")->capture_default_str();
  verb->add_option("--only", arguments->only, "One kind of furniture or family of rooms")
      ->type_name("NAME");
  verb->add_option("--seed", arguments->seed, "Of the furniture and the rooms")
      ->capture_default_str();
  add_common(*verb, arguments->common, false);
  verb->callback([arguments, &code] { code = run_gallery(*arguments); });
}

}  // namespace scanchor::apps
