#include "scenes/classes.hpp"

#include <fmt/format.h>

#include <string>

namespace scanchor {

// Ids are part of the data-set format: append, never renumber. The colours of the classes that
// every room has follow Okabe and Ito, "Color Universal Design" (2008), which stay apart under
// protanopia and deuteranopia; a test holds them to that.
const std::vector<ClassInfo>& class_list() {
  static const std::vector<ClassInfo> list = {
      {0, "unlabelled", false, "clutter", {0, 0, 0}},
      {1, "floor", false, "floor", {110, 110, 110}},
      {2, "wall", false, "wall", {196, 196, 196}},
      {3, "ceiling", false, "ceiling", {242, 242, 242}},
      {4, "pillar", true, "column", {150, 130, 160}},
      {5, "beam", true, "beam", {130, 150, 150}},
      {6, "door", true, "door", {213, 94, 0}},
      {7, "window", true, "window", {86, 180, 233}},
      {8, "desk", true, "table", {230, 159, 0}},
      {9, "table", true, "table", {240, 228, 66}},
      {10, "meeting table", true, "table", {250, 200, 120}},
      {11, "coffee table", true, "table", {205, 170, 60}},
      {12, "chair", true, "chair", {0, 114, 178}},
      {13, "stool", true, "chair", {60, 60, 200}},
      {14, "sofa", true, "sofa", {120, 70, 200}},
      {15, "bed", true, "sofa", {170, 90, 220}},
      {16, "shelf", true, "bookcase", {0, 158, 115}},
      {17, "bookcase", true, "bookcase", {60, 190, 90}},
      {18, "cabinet", true, "clutter", {204, 121, 167}},
      {19, "drawer unit", true, "clutter", {230, 150, 200}},
      {20, "wardrobe", true, "clutter", {150, 60, 110}},
      {21, "monitor", true, "clutter", {30, 30, 90}},
      {22, "laptop", true, "clutter", {90, 100, 140}},
      {23, "keyboard", true, "clutter", {70, 70, 70}},
      {24, "television", true, "clutter", {20, 20, 50}},
      {25, "whiteboard", true, "board", {215, 235, 255}},
      {26, "picture", true, "board", {255, 170, 150}},
      {27, "refrigerator", true, "clutter", {180, 215, 235}},
      {28, "microwave", true, "clutter", {110, 160, 190}},
      {29, "oven", true, "clutter", {70, 110, 130}},
      {30, "sink counter", true, "clutter", {150, 200, 190}},
      {31, "radiator", true, "clutter", {255, 230, 200}},
      {32, "waste bin", true, "clutter", {80, 120, 60}},
      {33, "lamp", true, "clutter", {255, 255, 150}},
      {34, "plant", true, "clutter", {40, 130, 30}},
      {35, "box", true, "clutter", {140, 80, 30}},
      {36, "pallet", true, "clutter", {190, 140, 90}},
      {37, "pallet rack", true, "bookcase", {250, 90, 90}},
      {38, "trolley", true, "clutter", {170, 40, 40}},
      {39, "mannequin", true, "clutter", {255, 190, 170}},
      {40, "book", true, "clutter", {160, 50, 70}},
      {41, "bottle", true, "clutter", {0, 90, 60}},
      {42, "cup", true, "clutter", {220, 110, 90}},
      {43, "bowl", true, "clutter", {240, 140, 110}},
      {44, "kitchen counter", true, "clutter", {170, 180, 150}},
      {45, "dishwasher", true, "clutter", {140, 170, 170}},
      {46, "printer", true, "clutter", {120, 120, 150}},
      {47, "mouse", true, "clutter", {95, 85, 95}},
      {48, "telephone", true, "clutter", {60, 50, 60}},
      {49, "bag", true, "clutter", {110, 60, 160}},
      {50, "workbench", true, "table", {220, 130, 40}},
      {51, "partition", true, "wall", {160, 175, 195}},
      {52, "washing machine", true, "clutter", {205, 225, 245}},
      {53, "cushion", true, "clutter", {190, 120, 240}},
      {54, "curtain", true, "clutter", {245, 215, 235}},
      {55, "clutter", false, "clutter", {100, 85, 60}},
  };
  return list;
}

const ClassInfo& class_info(ClassId id) {
  const auto& list = class_list();
  if (id < 0 || static_cast<std::size_t>(id) >= list.size()) return list.front();
  return list[static_cast<std::size_t>(id)];
}

std::optional<ClassId> find_class(std::string_view name) {
  for (const auto& info : class_list()) {
    if (info.name == name) return info.id;
  }
  return std::nullopt;
}

const std::vector<std::string_view>& s3dis_classes() {
  static const std::vector<std::string_view> names = {
      "ceiling", "floor", "wall", "beam",     "column", "window", "door",
      "table",   "chair", "sofa", "bookcase", "board",  "clutter"};
  return names;
}

std::int32_t s3dis_index(ClassId id) {
  const auto& names = s3dis_classes();
  const auto wanted = class_info(id).s3dis;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == wanted) return static_cast<std::int32_t>(i);
  }
  return static_cast<std::int32_t>(names.size()) - 1;
}

std::string semantic_kitti_yaml() {
  const auto line = [](ClassId id, const std::string& value) {
    return fmt::format("  {}: {}\n", id, value);
  };
  std::string labels = "labels:\n";
  std::string colors = "color_map: # blue, green, red\n";
  std::string to = "learning_map:\n";
  std::string ignore = "learning_ignore:\n  0: true\n";
  std::string inverse = "learning_map_inv:\n  0: 0\n";
  for (const auto& info : class_list()) {
    labels += line(info.id, fmt::format("\"{}\"", info.name));
    colors +=
        line(info.id, fmt::format("[{}, {}, {}]", info.color[2], info.color[1], info.color[0]));
    // Learning class 0 is "unlabelled", which the evaluation ignores; 1..13 are S3DIS in its own
    // order.
    to += line(info.id, std::to_string(info.id == unlabelled ? 0 : s3dis_index(info.id) + 1));
  }
  for (std::size_t k = 0; k < s3dis_classes().size(); ++k) {
    ignore += fmt::format("  {}: false\n", k + 1);
    for (const auto& info : class_list()) {
      if (info.id == unlabelled || s3dis_index(info.id) != static_cast<std::int32_t>(k)) continue;
      inverse += line(static_cast<ClassId>(k) + 1, std::to_string(info.id));
      break;
    }
  }
  return labels + colors + to + inverse + ignore;
}

}  // namespace scanchor
