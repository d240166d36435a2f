// What belongs to the building: doors, windows, radiators, pillars, partitions. Door openings: DIN
// 18100; leaves: DIN 18101.

#include "scenes/catalogue/maker.hpp"

namespace scanchor {
namespace {

/// In a wall opening of `width` x `height` whose inner edge is the plane y = 0 and whose reveals
/// reach to y = `wall`. Origin below the middle of the opening. The leaf opens into the room.
void make_door(Maker& m) {
  const double width = m.series("width", {0.76, 0.885, 0.885, 1.01});
  const double height = m.series("height", {2.005, 2.005, 2.13});
  const double wall = m.series("wall", {0.1, 0.12, 0.15, 0.2});
  const double jamb = 0.035;
  const double seam = 0.003;
  const int frame = m.material({"paint white", "paint grey", "steel painted", "oak"});
  const int leaf = m.material({"melamine white", "beech", "oak", "paint grey", "paint blue"});
  const int metal = m.material({"aluminium", "stainless steel"});
  const double half = 0.5 * width - glide;
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (half - 0.5 * jamb);
    m.box(s < 0 ? "left jamb" : "right jamb", frame, {x - 0.5 * jamb, 0.0, glide},
          {x + 0.5 * jamb, wall, height - glide});
  }
  m.box("lintel", frame, {-half + jamb - joint, 0.0015, height - glide - jamb},
        {half - jamb + joint, wall - 0.0015, height - 0.004});
  const double leaf_width = 2 * (half - jamb - seam);
  const double leaf_height = height - glide - jamb - seam - 0.008;
  const bool hinge_left = m.random.chance(0.5);
  double angle = 0.0;
  if (m.is("ajar")) angle = m.number("angle_deg", 8.0, 23.0);
  if (m.is("open")) angle = m.number("angle_deg", 80.0, 95.0);
  const double side = hinge_left ? 1.0 : -1.0;
  const Eigen::Isometry3d swing =
      pose_at({-side * 0.5 * leaf_width, 0.0, 0.008}, -side * radians(angle));
  const auto hang = [&](Part part) {
    part.T_instance_part = swing;
    m.add(std::move(part));
  };
  hang(box_part("leaf", leaf, {side * 0.5 * leaf_width, 0.022, 0.5 * leaf_height},
                {leaf_width, 0.04, leaf_height}));
  const double x = side * (leaf_width - 0.07);
  for (const double s : {-1.0, 1.0}) {
    const double y = 0.022 + s * 0.02;
    const std::string where = s < 0 ? "inner" : "outer";
    hang(box_part(where + " rose", metal, {x, y + s * 0.003, 1.04}, {0.04, 0.01, 0.16}));
    hang(box_part(where + " neck", metal, {x, y + s * 0.025, 1.05}, {0.018, 0.045, 0.018}));
    hang(box_part(where + " handle", metal, {x - side * 0.05, y + s * 0.05, 1.0505},
                  {0.13, 0.016, 0.024}));
  }
}

/// In a wall opening as a door, origin below the middle of the opening's lower edge.
void make_window(Maker& m) {
  const double width = m.series("width", {0.9, 1.1, 1.2, 1.4, 1.8});
  const double height = m.series("height", {1.1, 1.2, 1.35, 1.5});
  const double wall = m.series("wall", {0.2, 0.24, 0.3});
  const int frame = m.material({"plastic white", "plastic white", "oak", "aluminium"});
  const int glass = m.material({"glass"});
  const double y0 = 0.45 * wall;
  const double y1 = y0 + 0.07;
  const double half = 0.5 * width - glide;
  const double bar = 0.07;
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (half - 0.5 * bar);
    m.box(s < 0 ? "left bar" : "right bar", frame, {x - 0.5 * bar, y0, glide},
          {x + 0.5 * bar, y1, height - glide});
  }
  const double inner = half - bar;
  m.box("lower bar", frame, {-inner - joint, y0 + 0.0015, 0.003},
        {inner + joint, y1 - 0.0015, bar});
  m.box("upper bar", frame, {-inner - joint, y0 + 0.0015, height - bar},
        {inner + joint, y1 - 0.0015, height - 0.003});
  const int panes = m.is("two panes") ? 2 : m.is("three panes") ? 3 : 1;
  const double field = 2 * inner / panes;
  for (int i = 1; i < panes; ++i) {
    const double x = -inner + field * i;
    m.box("mullion " + std::to_string(i), frame, {x - 0.04, y0 + 0.003, bar - joint},
          {x + 0.04, y1 - 0.003, height - bar + joint});
  }
  for (int i = 0; i < panes; ++i) {
    const double x0 = -inner + field * i + (i > 0 ? 0.04 : 0.0);
    const double x1 = -inner + field * (i + 1) - (i + 1 < panes ? 0.04 : 0.0);
    const double y = 0.5 * (y0 + y1);
    m.box("glass " + std::to_string(i + 1), glass, {x0 - 2 * joint, y - 0.012, bar - 2 * joint},
          {x1 + 2 * joint, y + 0.012, height - bar + 2 * joint});
  }
}

/// At the wall y = 0, origin on the floor.
void make_radiator(Maker& m) {
  const double width = m.series("width", {0.6, 0.8, 1.0, 1.2, 1.6});
  const double height = m.series("height", {0.4, 0.5, 0.6});
  const double depth = m.is("single panel") ? 0.06 : 0.1;
  const int paint = m.material({"enamel white"});
  const double y1 = -0.045;
  const double y0 = y1 - depth;
  const double z = 0.12;
  if (m.is("ribs")) {
    const int ribs = static_cast<int>(width / 0.06);
    for (int i = 0; i < ribs; ++i) {
      const double x = -0.5 * width + 0.06 * i;
      m.box("rib " + std::to_string(i + 1), paint, {x, y0, z}, {x + 0.046, y1, z + height});
    }
    for (const double a : {0.06, height - 0.06}) {
      const double r = 0.018;
      m.add(cylinder_part(a < 0.1 ? "lower pipe" : "upper pipe", paint,
                          {-0.5 * width + 0.02, 0.5 * (y0 + y1), z + a},
                          {-0.5 * width + 0.06 * ribs - 0.034, 0.5 * (y0 + y1), z + a}, r, 8));
    }
  } else {
    m.box("panel", paint, {-0.5 * width, y0, z}, {0.5 * width, y1, z + height});
  }
  for (const double s : {-1.0, 1.0}) {
    double x = s * (0.5 * width - 0.12);
    if (m.is("ribs"))
      x = -0.5 * width + 0.023 +
          0.06 * (s < 0 ? 1 : static_cast<int>(width / 0.06) - 2);  // behind a rib
    m.box(s < 0 ? "left bracket" : "right bracket", paint, {x - 0.015, y1 - 0.03, z + 0.1},
          {x + 0.015, -0.003, z + height - 0.1});
  }
}

void make_pillar(Maker& m) {
  const double height = m.size("height", 2.6, 0.1, 2.3, 3.2);
  const int material = m.material({"concrete", "paint white", "paint grey"});
  if (m.is("round")) {
    const double r = 0.5 * m.series("diameter", {0.25, 0.3, 0.4, 0.5});
    m.add(lathe_part("shaft", material, {{r, glide}, {r, height - glide}}, 32));
    return;
  }
  const double a = m.series("side", {0.25, 0.3, 0.4, 0.5});
  const double b = m.is("square") ? a : a * 1.6;
  m.box("shaft", material, {-0.5 * b, -0.5 * a, glide}, {0.5 * b, 0.5 * a, height - glide});
}

void make_partition(Maker& m) {
  const double width = m.series("width", {0.8, 1.0, 1.2, 1.6});
  const double height = m.series("height", {1.2, 1.4, 1.6, 1.8});
  const int cloth = m.material({"fabric grey", "fabric blue", "fabric beige", "glass"});
  const int metal = m.material({"aluminium", "steel painted"});
  m.box("panel", cloth, {-0.5 * width, -0.02, 0.06}, {0.5 * width, 0.02, height});
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (0.5 * width - 0.12);
    const double deep = m.is("flat feet") ? 0.3 : 0.22;
    m.box(s < 0 ? "left foot" : "right foot", metal, {x - 0.03, -deep, glide},
          {x + 0.03, deep, m.is("flat feet") ? 0.012 : 0.03});
    m.box(s < 0 ? "left post" : "right post", metal, {x - 0.015, -0.012, 0.012 - joint},
          {x + 0.015, 0.012, 0.06 + joint});
  }
}

}  // namespace

std::vector<CatalogueEntry> building_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"door", id("door"), {"closed", "ajar", "open"}, Place::wall, false, 500}, make_door},
      {{"window", id("window"), {"one pane", "two panes", "three panes"}, Place::wall, false, 500},
       make_window},
      {{"radiator", id("radiator"), {"panel", "single panel", "ribs"}, Place::wall, false, 500},
       make_radiator},
      {{"pillar", id("pillar"), {"square", "oblong", "round"}, Place::floor, false, 2400},
       make_pillar},
      {{"partition", id("partition"), {"flat feet", "high feet"}, Place::floor, false, 200},
       make_partition},
  };
}

}  // namespace scanchor
