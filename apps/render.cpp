// scanchor render: a scene or a cloud as a picture, off-screen.

#include <fmt/format.h>

#include <filesystem>

#include "apps/scan_input.hpp"
#include "cloud/io.hpp"
#include "results/image.hpp"
#include "results/pictures.hpp"
#include "scenes/scene.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct Arguments {
  Common common;
  std::string input;
  std::string out = "picture.png";
  std::string color;
  PictureOptions picture;
};

const std::vector<std::pair<std::string, CloudColor>>& cloud_colors() {
  static const std::vector<std::pair<std::string, CloudColor>> colors = {
      {"plain", CloudColor::plain},         {"height", CloudColor::height},
      {"intensity", CloudColor::intensity}, {"range-error", CloudColor::range_error},
      {"flags", CloudColor::flags},         {"class", CloudColor::class_id},
      {"instance", CloudColor::instance},   {"plane", CloudColor::plane}};
  return colors;
}

const std::vector<std::pair<std::string, SceneColor>>& scene_colors() {
  static const std::vector<std::pair<std::string, SceneColor>> colors = {
      {"class", SceneColor::class_id},
      {"material", SceneColor::material},
      {"instance", SceneColor::instance}};
  return colors;
}

template <class Color>
Color color_of(const std::vector<std::pair<std::string, Color>>& colors, const std::string& name,
               const std::string& what) {
  std::string known;
  for (const auto& [word, color] : colors) {
    if (word == name) return color;
    known += (known.empty() ? "" : ", ") + word;
  }
  fail_usage(fmt::format("--color: {} cannot be coloured by '{}'", what, name),
             "known are: " + known);
}

int run(Arguments& arguments) {
  OptionList list;
  list.add_group("render", arguments.picture.render);
  apply_settings(list, arguments.common);
  const fs::path input = arguments.input;
  Image image;
  if (input.extension() == ".json") {
    const auto color =
        color_of(scene_colors(), arguments.color.empty() ? "class" : arguments.color, "a scene");
    image = picture_of_scene(read_scene(input), arguments.picture, color);
  } else {
    const auto color =
        color_of(cloud_colors(), arguments.color.empty() ? "height" : arguments.color, "a cloud");
    const PointCloud cloud = read_cloud(input);
    require_finite(cloud, arguments.input);
    image = picture_of_cloud(cloud, arguments.picture, color);
  }
  write_png(arguments.out, image);
  answer(arguments.common,
         Json{{"picture", arguments.out}, {"width", image.width}, {"height", image.height}});
  say(arguments.common, fmt::format("{} ({} x {})", arguments.out, image.width, image.height));
  return 0;
}

}  // namespace

void add_render(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("render", "Draw a scene or a cloud into a PNG file, off-screen");
  verb->footer(
      "Examples:\n  scanchor render demo/00/scene.json --out scene.png\n"
      "  scanchor render demo/00/scan.pcd --color class --azimuth 30 --out cloud.png");
  auto arguments = std::make_shared<Arguments>();
  verb->add_option("input", arguments->input, "scene.json, or a cloud (PCD, PLY, XYZ, bin)")
      ->required()
      ->type_name("FILE");
  verb->add_option("--out", arguments->out, "The picture")->type_name("PNG")->capture_default_str();
  verb->add_option("--color", arguments->color,
                   "By what: class, material, instance; for clouds also height, plane, intensity, "
                   "range-error, flags, plain");
  verb->add_option("--azimuth", arguments->picture.azimuth_deg,
                   "Of the eye [deg], counter-clockwise from x")
      ->capture_default_str();
  verb->add_option("--elevation", arguments->picture.elevation_deg, "Of the eye [deg]")
      ->capture_default_str();
  verb->add_option("--title", arguments->picture.title, "Written over the picture");
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run(*arguments); });
}

}  // namespace scanchor::apps
