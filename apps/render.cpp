// scanchor render: a scene or a cloud as a picture, off-screen.

#include <fmt/format.h>

#include <filesystem>

#include "apps/scan_input.hpp"
#include "apps/scan_pictures.hpp"
#include "cloud/io.hpp"
#include "reasoning/item.hpp"
#include "results/image.hpp"
#include "results/pictures.hpp"
#include "scenes/scene.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct RenderArguments {
  Common common;
  std::vector<std::string> inputs;
  std::string out = "picture.png";
  std::string color;
  std::string view = "perspective";
  std::vector<std::string> titles;
  std::int32_t relations_of = -1;
  bool together = false;
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

/// labels.json with the surfaces beside it.
struct Labels {
  Surfaces surfaces;
  Labelling labelling;
  DrawLabelsOptions how;

  Labels(const fs::path& input, const RenderArguments& arguments) {
    const fs::path beside = input.parent_path() / "surfaces.json";
    if (!fs::exists(beside))
      fail_data(beside.string(), "", "is not there",
                "labels are drawn on the surfaces that they name: keep both in one folder");
    labelling = labelling_from_json(read_json(input), input.string());
    const auto entities = static_cast<std::int32_t>(labelling.entities.size());
    if (arguments.relations_of >= entities)
      fail_usage(
          fmt::format("--relations: {} has no thing {}", input.string(), arguments.relations_of),
          fmt::format("things are 0 .. {}, and -2: all", entities - 1));
    how.relations_of = arguments.relations_of;
    surfaces = read_surfaces(beside);
  }
};

bool is_surfaces(const fs::path& input) {
  return input.filename().string().ends_with("surfaces.json");
}
bool is_labels(const fs::path& input) { return input.filename().string().ends_with("labels.json"); }

Image picture_of_file(const fs::path& input, const RenderArguments& arguments,
                      const PictureOptions& options) {
  if (is_surfaces(input)) return picture_of_surfaces(read_surfaces(input), options);
  if (is_labels(input)) {
    const Labels labels(input, arguments);
    return picture_of_labels(labels.surfaces, labels.labelling, options, nullptr,
                             upright(labels.labelling), labels.how);
  }
  if (input.extension() == ".json") {
    const auto color =
        color_of(scene_colors(), arguments.color.empty() ? "class" : arguments.color, "a scene");
    return picture_of_scene(read_scene(input), options, color);
  }
  const auto color =
      color_of(cloud_colors(), arguments.color.empty() ? "height" : arguments.color, "a cloud");
  const PointCloud cloud = read_cloud(input);
  require_finite(cloud, input.string());
  return picture_of_cloud(cloud, options, color);
}

/// Surfaces or labels as paths.
VectorPicture outlines_of_file(const fs::path& input, const RenderArguments& arguments,
                               const PictureOptions& options) {
  if (is_surfaces(input)) return outlines_of_surfaces(read_surfaces(input), options);
  if (!is_labels(input)) {
    if (!fs::exists(input))
      fail_data(input.string(), "", "cannot be opened: No such file or directory");
    fail_usage("--out: an SVG file holds outlines, and " + input.string() + " has none",
               "name surfaces.json or labels.json, or write a PNG file");
  }
  const Labels labels(input, arguments);
  return outlines_of_labels(labels.surfaces, labels.labelling, options, upright(labels.labelling),
                            labels.how);
}

Image rooms_together(const RenderArguments& arguments) {
  std::vector<Scene> scenes;
  for (const auto& input : arguments.inputs) scenes.push_back(read_scene(input));
  return picture_of_rooms(
      scenes, arguments.picture,
      color_of(scene_colors(), arguments.color.empty() ? "class" : arguments.color, "a scene"));
}

int run_render(RenderArguments& arguments) {
  OptionList list;
  list.add_group("render", arguments.picture.render);
  apply_settings(list, arguments.common);
  static const std::vector<std::pair<std::string, Viewpoint>> views = {
      {"perspective", Viewpoint::perspective},
      {"top", Viewpoint::top},
      {"side", Viewpoint::side},
      {"sensor", Viewpoint::sensor}};
  for (const auto& [word, view] : views) {
    if (word == arguments.view) arguments.picture.view = view;
  }
  const std::string kind = fs::path(arguments.out).extension().string();
  if (kind != ".png" && kind != ".svg")
    fail_usage("--out: pictures are .png or .svg, not '" + arguments.out + "'");
  const auto done = [&](int width, int height) {
    answer(arguments.common,
           Json{{"picture", arguments.out}, {"width", width}, {"height", height}});
    say(arguments.common, fmt::format("{} ({} x {})", arguments.out, width, height));
    return 0;
  };
  if (kind == ".svg") {
    if (arguments.inputs.size() != 1 || arguments.together)
      fail_usage("--out: an SVG file shows one thing", "name one surfaces.json or labels.json");
    if (!arguments.titles.empty()) arguments.picture.title = arguments.titles.front();
    const VectorPicture picture =
        outlines_of_file(arguments.inputs.front(), arguments, arguments.picture);
    write_svg(arguments.out, picture);
    return done(picture.width, picture.height);
  }
  Image image;
  if (arguments.together) {
    image = rooms_together(arguments);
  } else if (arguments.inputs.size() == 1) {
    if (!arguments.titles.empty()) arguments.picture.title = arguments.titles.front();
    image = picture_of_file(arguments.inputs.front(), arguments, arguments.picture);
  } else {
    std::vector<Image> images;
    std::vector<std::string> titles = arguments.titles;
    for (const auto& input : arguments.inputs) {
      if (titles.size() <= images.size()) titles.push_back(input);
      images.push_back(picture_of_file(input, arguments, arguments.picture));
    }
    image = side_by_side(images, titles);
  }
  write_png(arguments.out, image);
  return done(image.width, image.height);
}

}  // namespace

void add_render(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand(
      "render", "Draw scenes, clouds, surfaces or labels into a PNG or SVG file, off-screen");
  verb->footer(
      "Examples:\n  scanchor render demo/00/scene.json --view top --out scene.png\n"
      "  scanchor render demo/00/scan.pcd --color class --azimuth 30 --out cloud.png\n"
      "  scanchor render demo/00/labels.json --relations 12 --out why.png\n"
      "  scanchor render before/00/labels.json after/00/labels.json --title before --title after\n"
      "  scanchor render demo/00/labels.json --out labels.svg\n"
      "  scanchor render demo/*/scene.json --together --out floor.png");
  auto arguments = std::make_shared<RenderArguments>();
  verb->add_option("input", arguments->inputs,
                   "scene.json, surfaces.json, labels.json (beside surfaces.json), or a cloud "
                   "(PCD, PLY, XYZ, bin); several: side by side")
      ->required()
      ->type_name("FILE...");
  verb->add_option("--view", arguments->view, "Where one stands")
      ->check(CLI::IsMember({"perspective", "top", "side", "sensor"}))
      ->capture_default_str();
  verb->add_flag("--together", arguments->together, "Several scenes as rooms of one floor");
  verb->add_option("--relations", arguments->relations_of,
                   "Arrows for the proof of this thing of labels.json; -2: of all things");
  verb->add_option("--out", arguments->out, "The picture; .svg: surfaces or labels as outlines")
      ->type_name("PNG|SVG")
      ->capture_default_str();
  verb->add_option("--color", arguments->color,
                   "By what: class, material, instance; for clouds also height, plane, intensity, "
                   "range-error, flags, plain");
  verb->add_option("--azimuth", arguments->picture.azimuth_deg,
                   "Of the eye [deg], counter-clockwise from x")
      ->capture_default_str();
  verb->add_option("--elevation", arguments->picture.elevation_deg, "Of the eye [deg]")
      ->capture_default_str();
  verb->add_option("--title", arguments->titles, "Written over the picture (repeatable)")
      ->expected(1)
      ->take_all();
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run_render(*arguments); });
}

}  // namespace scanchor::apps
