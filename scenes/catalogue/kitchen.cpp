// Kitchen: worktops 900 mm high, 600 mm modules (EN 1116); appliances as makers size them for them.

#include <algorithm>

#include "scenes/catalogue/maker.hpp"

namespace scanchor {
namespace {

constexpr double slab = 0.038;  // [m] worktop

/// A base unit of the kitchen grid: plinth, body, fronts, worktop with an overhang.
void base_units(Maker& m, double width, double depth, double height, double body_top,
                bool with_top) {
  const int body = m.material({"melamine white", "melamine grey", "beech"});
  const int metal = m.material({"stainless steel", "aluminium"});
  const int top = m.material({"oak", "melamine grey", "beech", "concrete"});
  const double y = -0.5 * depth + 0.04;
  m.box("plinth", body, {-0.5 * width + 0.003, y + 0.05, glide},
        {0.5 * width - 0.003, 0.5 * depth - 0.02, 0.1 + joint});
  m.box("body", body, {-0.5 * width + 0.0015, y, 0.1},
        {0.5 * width - 0.0015, 0.5 * depth - 0.003, body_top});
  const int units = std::max(1, static_cast<int>(width / 0.55));
  const double unit = width / units;
  for (int i = 0; i < units; ++i) {
    const std::string number = std::to_string(i + 1);
    const double x0 = -0.5 * width + unit * i + 0.004;
    const double x1 = x0 + unit - 0.008;
    m.box("door " + number, body, {x0, y - 0.018, 0.105}, {x1, y + joint, height - slab - 0.01});
    m.box("handle " + number, metal, {0.5 * (x0 + x1) - 0.08, y - 0.05, height - 0.12},
          {0.5 * (x0 + x1) + 0.08, y - 0.018 + joint, height - 0.108});
  }
  if (with_top)
    m.box("worktop", top, {-0.5 * width, -0.5 * depth, height - slab},
          {0.5 * width, 0.5 * depth, height});
}

void make_counter(Maker& m) {
  const double width = m.series("width", {0.6, 0.9, 1.2, 1.5, 1.8});
  const double depth = m.series("depth", {0.6, 0.6, 0.65});
  const double height = m.size("height", 0.91, 0.015, 0.85, 0.96);
  base_units(m, width, depth, height, height - slab + joint, true);
  if (m.is("with hob"))
    m.box("hob", m.material({"screen"}), {-0.29, -0.26, height - joint},
          {0.29, 0.25, height + 0.006});
  if (m.is("with wall units")) {
    const int body = m.material({"melamine white", "melamine grey", "beech"});
    m.box("wall unit", body, {-0.5 * width, 0.5 * depth - 0.35, 1.45},
          {0.5 * width, 0.5 * depth - 0.003, 2.15});
    m.box("wall unit front", body, {-0.5 * width + 0.003, 0.5 * depth - 0.368, 1.453},
          {0.5 * width - 0.003, 0.5 * depth - 0.35 + joint, 2.147});
  }
}

/// Walls and floor of a basin 0.36 m deep from front to back, below a worktop at `height`.
void basin(Maker& m, int steel, const std::string& which, double cx, double half, double y0,
           double height) {
  const double y1 = y0 + 0.36;
  for (const double s : {-1.0, 1.0}) {
    const double x = cx + s * (half + 0.005);
    m.box(which + (s < 0 ? "left" : "right") + " basin wall", steel,
          {x - 0.003, y0 - 0.0035, height - 0.198},
          {x + 0.003, y1 + 0.0035, height - slab + joint});
    const double y = s < 0 ? y0 - 0.005 : y1 + 0.005;
    m.box(which + (s < 0 ? "front" : "back") + " basin wall", steel,
          {cx - half - 0.0035, y - 0.003, height - 0.1965},
          {cx + half + 0.0035, y + 0.003, height - slab + 0.0035});
  }
  m.box(which + "basin floor", steel, {cx - half - 0.005, y0 - 0.005, height - 0.2},
        {cx + half + 0.005, y1 + 0.005, height - 0.194});
}

void make_sink(Maker& m) {
  const double width = m.series("width", {0.8, 1.0, 1.2});
  const double depth = 0.6;
  const double height = m.size("height", 0.91, 0.015, 0.85, 0.96);
  const double body_top = height - 0.24;
  base_units(m, width, depth, height, body_top, false);
  // A worktop with the basins cut out, and the basins below it.
  const int steel = m.material({"stainless steel"});
  const bool two = m.is("two basins");
  const double half = two ? std::min(0.15, 0.25 * width - 0.05) : 0.17;
  std::vector<double> centers = {m.is("with drainer") ? -0.5 * width + 0.28 : 0.0};
  if (two) centers = {-half - 0.04, half + 0.04};
  // The panel is made standing and laid down: its x-z plane becomes the x-y plane, its front the
  // top.
  Eigen::Matrix3d lay;
  lay << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  std::vector<Opening> holes;
  for (const double cx : centers)
    holes.push_back({{cx + 0.5 * width - half, 0.12}, {cx + 0.5 * width + half, 0.12 + 0.36}});
  m.add(panel_part("worktop", steel, width, depth, slab, holes, true,
                   pose_at({-0.5 * width, -0.5 * depth, height}, lay)));
  const double y0 = -0.5 * depth + 0.12;
  for (const double cx : centers)
    basin(m, steel, cx == centers.back() ? "" : "second ", cx, half, y0, height);
  for (const double s : {-1.0, 1.0}) {
    // The unit's sides stand above its body, which ends below the basin.
    const double edge = s * (0.5 * width - 0.011);
    m.box(s < 0 ? "left side" : "right side", steel,
          {edge - 0.008, -0.5 * depth + 0.044, body_top - joint},
          {edge + 0.008, 0.5 * depth - 0.0045, height - slab + joint});
  }
  // The tap.
  const double cx = two ? 0.0 : centers.front();
  m.add(cylinder_part("tap", steel, {cx, 0.5 * depth - 0.07, height - 0.01},
                      {cx, 0.5 * depth - 0.07, height + 0.25}, 0.014, 10));
  m.add(cylinder_part("spout", steel, {cx, 0.5 * depth - 0.07, height + 0.24},
                      {cx, 0.5 * depth - 0.25, height + 0.22}, 0.011, 10));
}

void make_refrigerator(Maker& m) {
  const bool small = m.is("under counter");
  const double width = m.series("width", {0.55, 0.6, 0.6});
  const double depth = m.series("depth", {0.6, 0.63, 0.65});
  const double height = small ? 0.85 : m.series("height", {1.45, 1.75, 1.85, 2.0});
  const int body = m.material({"enamel white", "stainless steel", "steel painted"});
  const int metal = m.material({"aluminium", "stainless steel"});
  const double y = -0.5 * depth + 0.06;
  m.box("body", body, {-0.5 * width, y, 0.03}, {0.5 * width, 0.5 * depth, height});
  m.box("foot", m.material({"plastic black"}), {-0.5 * width + 0.02, y + 0.03, glide},
        {0.5 * width - 0.02, 0.5 * depth - 0.03, 0.03 + joint});
  const double split = m.is("fridge-freezer") ? 0.38 * height : 0.05;
  const auto door = [&](const std::string& name, double z0, double z1) {
    m.box(name + " door", body, {-0.5 * width + 0.0015, y - 0.055, z0},
          {0.5 * width - 0.0015, y + joint, z1});
    m.box(name + " handle", metal, {0.5 * width - 0.07, y - 0.09, 0.5 * (z0 + z1) - 0.12},
          {0.5 * width - 0.05, y - 0.055 + joint, 0.5 * (z0 + z1) + 0.12});
  };
  if (m.is("fridge-freezer")) door("freezer", 0.06, split);
  door("fridge", split + 0.004, height - 0.004);
}

/// A body with a front panel that stands out and something in it.
void appliance(Maker& m, double width, double depth, double height, double z, int body, int front,
               bool round_window) {
  const double y = -0.5 * depth + 0.02;
  m.box("body", body, {-0.5 * width, y, z}, {0.5 * width, 0.5 * depth, z + height});
  m.box("front", front, {-0.5 * width + 0.004, y - 0.018, z + 0.09 * height},
        {0.5 * width - 0.004, y + joint, z + 0.86 * height});
  if (round_window) {
    m.add(lathe_part(
        "porthole", m.material({"plastic grey"}), {{0.19, 0.0}, {0.17, 0.03}, {0.0, 0.045}}, 20,
        pose_along({0, y - 0.018 + joint, z + 0.45 * height}, {0, y - 0.1, z + 0.45 * height})));
  } else {
    m.box("handle", m.material({"stainless steel"}), {-0.4 * width, y - 0.055, z + 0.79 * height},
          {0.4 * width, y - 0.018 + joint, z + 0.79 * height + 0.016});
  }
}

void make_oven(Maker& m) {
  const bool range = m.is("range");
  const double width = m.series("width", {0.595, 0.595, 0.6});
  const int steel = m.material({"stainless steel", "enamel white"});
  const int glass = m.material({"screen"});
  appliance(m, width, 0.6, range ? 0.848 : 0.595, range ? 0.01 : glide, steel, glass, false);
  if (range) {
    m.box("hob", glass, {-0.5 * width + 0.01, -0.25, 0.858 - joint},
          {0.5 * width - 0.01, 0.28, 0.864});
    m.box("foot", steel, {-0.5 * width + 0.02, -0.22, glide},
          {0.5 * width - 0.02, 0.28, 0.01 + joint});
  }
}

void make_microwave(Maker& m) {
  const double width = m.size("width", 0.48, 0.03, 0.43, 0.55);
  const double height = m.size("height", 0.28, 0.015, 0.25, 0.33);
  const double depth = m.size("depth", 0.37, 0.03, 0.3, 0.45);
  const int body = m.material({"stainless steel", "enamel white", "plastic black"});
  const double y = -0.5 * depth + 0.02;
  m.box("body", body, {-0.5 * width, y, 0.0}, {0.5 * width, 0.5 * depth, height});
  const double split = 0.5 * width - 0.11;
  m.box("door", m.material({"screen"}), {-0.5 * width + 0.004, y - 0.018, 0.01},
        {split, y + joint, height - 0.006});
  if (m.is("handle"))
    m.box("handle", body, {split - 0.04, y - 0.05, 0.03},
          {split - 0.025, y - 0.018 + joint, height - 0.03});
  m.box("panel", body, {split + 0.003, y - 0.014, 0.012},
        {0.5 * width - 0.004, y + joint, height - 0.008});
}

void make_dishwasher(Maker& m) {
  const double width = m.series("width", {m.is("slim") ? 0.448 : 0.598});
  appliance(m, width, 0.6, 0.845 - glide, glide, m.material({"enamel white", "stainless steel"}),
            m.material({"enamel white", "stainless steel"}), false);
}

void make_washing_machine(Maker& m) {
  appliance(m, 0.598, m.is("slim") ? 0.47 : 0.6, 0.848 - glide, glide, m.material({"enamel white"}),
            m.material({"enamel white"}), true);
}

}  // namespace

std::vector<CatalogueEntry> kitchen_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"kitchen counter",
        id("kitchen counter"),
        {"plain", "with hob", "with wall units"},
        Place::floor,
        false,
        300},
       make_counter},
      {{"sink counter",
        id("sink counter"),
        {"with drainer", "single basin", "two basins"},
        Place::floor,
        false,
        300},
       make_sink},
      {{"refrigerator",
        id("refrigerator"),
        {"fridge-freezer", "tall", "under counter"},
        Place::floor,
        false,
        100},
       make_refrigerator},
      {{"oven", id("oven"), {"range", "built-in"}, Place::floor, false, 200}, make_oven},
      {{"microwave", id("microwave"), {"handle", "push button"}, Place::surface, true, 250},
       make_microwave},
      {{"dishwasher", id("dishwasher"), {"standard", "slim"}, Place::floor, false, 200},
       make_dishwasher},
      {{"washing machine", id("washing machine"), {"standard", "slim"}, Place::floor, false, 300},
       make_washing_machine},
  };
}

}  // namespace scanchor
