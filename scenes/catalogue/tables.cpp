// Desks and tables. Heights and tops: EN 527-1 (office desks), EN 15372 (tables); see
// docs/reference/furniture.md.

#include "scenes/catalogue/maker.hpp"

namespace scanchor {
namespace {

/// A board of thickness `t` whose top is at height `h`.
void top_board(Maker& m, int material, double width, double depth, double h, double t) {
  m.box("top", material, {-0.5 * width, -0.5 * depth, h - t}, {0.5 * width, 0.5 * depth, h});
}

/// Square legs of side `side` in the corners, `inset` from the edges.
void corner_legs(Maker& m, int material, double width, double depth, double top, double side,
                 double inset) {
  int number = 0;
  for (const double sy : {-1.0, 1.0}) {
    for (const double sx : {-1.0, 1.0}) {
      const double x = sx * (0.5 * width - inset - 0.5 * side);
      const double y = sy * (0.5 * depth - inset - 0.5 * side);
      m.box("leg " + std::to_string(++number), material, {x - 0.5 * side, y - 0.5 * side, glide},
            {x + 0.5 * side, y + 0.5 * side, top + 2 * joint});
    }
  }
}

/// Rails below the top between corner legs, thinner than the legs.
void rails(Maker& m, int material, double width, double depth, double top, double side,
           double inset) {
  const double thick = 0.5 * side;
  const double y = 0.5 * depth - inset - 0.5 * side;
  const double x = 0.5 * width - inset - 0.5 * side;
  for (const double s : {-1.0, 1.0}) {
    const double reach = x - 0.5 * side + joint;
    m.box(s < 0 ? "front rail" : "back rail", material, {-reach, s * y - 0.5 * thick, top - 0.06},
          {reach, s * y + 0.5 * thick, top + joint});
  }
  for (const double s : {-1.0, 1.0}) {
    const double reach = y - 0.5 * side + joint;
    m.box(s < 0 ? "left rail" : "right rail", material, {s * x - 0.5 * thick, -reach, top - 0.055},
          {s * x + 0.5 * thick, reach, top + joint});
  }
}

void panel_legs(Maker& m, int material, double width, double depth, double top) {
  const double t = 0.022;
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (0.5 * width - 0.02 - 0.5 * t);
    m.box(s < 0 ? "left panel" : "right panel", material, {x - 0.5 * t, -0.5 * depth + 0.03, glide},
          {x + 0.5 * t, 0.5 * depth - 0.03, top + 2 * joint});
  }
  const double reach = 0.5 * width - 0.02 - t + joint;
  m.box("modesty panel", material, {-reach, 0.5 * depth - 0.12, 0.3},
        {reach, 0.5 * depth - 0.1, top + joint});
}

/// Two lifting columns on T feet.
void lifting_columns(Maker& m, int material, double width, double depth, double top) {
  for (const double s : {-1.0, 1.0}) {
    const std::string side = s < 0 ? "left " : "right ";
    const double x = s * (0.5 * width - 0.25);
    m.box(side + "foot", material, {x - 0.04, -0.5 * depth + 0.05, glide},
          {x + 0.04, 0.5 * depth - 0.05, 0.035});
    m.box(side + "column", material, {x - 0.03, -0.02, 0.035 - joint},
          {x + 0.03, 0.06, 0.56 * top});
    m.box(side + "inner column", material, {x - 0.025, -0.015, 0.56 * top - joint},
          {x + 0.025, 0.055, top + 2 * joint});
  }
  m.box("beam", material, {-0.5 * width + 0.25 + 0.025 - joint, 0.0, top - 0.04},
        {0.5 * width - 0.25 - 0.025 + joint, 0.04, top + joint});
}

void make_desk(Maker& m) {
  const double width = m.series("width", {1.2, 1.4, 1.6, 1.6, 1.8});
  const double depth = m.series("depth", {0.7, 0.8, 0.8, 0.8, 0.9});
  const double thick = m.series("thickness", {0.019, 0.025, 0.025, 0.030});
  const int wood = m.material({"beech", "oak", "melamine white", "melamine grey", "walnut"});
  const int metal = m.material({"steel painted", "aluminium", "plastic black"});
  if (m.is("height-adjustable")) {
    const double height = m.size("height", 0.78, 0.12, 0.65, 1.25);
    top_board(m, wood, width, depth, height, thick);
    lifting_columns(m, metal, width, depth, height - thick);
    return;
  }
  const double height = m.size("height", 0.74, 0.01, 0.72, 0.76);
  const double top = height - thick;
  if (m.is("panel legs")) {
    top_board(m, wood, width, depth, height, thick);
    panel_legs(m, wood, width, depth, top);
  } else if (m.is("L-shape")) {
    // The return goes forward on the left; one board with six corners.
    const double reach = m.size("return", 0.9, 0.1, 0.6, 1.2);
    const double wing = 0.6;
    const double x0 = -0.5 * width;
    const double y0 = -0.5 * depth;
    const std::vector<Eigen::Vector2d> outline = {{x0, y0 - reach},   {x0 + wing, y0 - reach},
                                                  {x0 + wing, y0},    {0.5 * width, y0},
                                                  {0.5 * width, -y0}, {x0, -y0}};
    m.add(prism_part("top", wood, outline, top, height));
    const double s = 0.05;
    const std::vector<Eigen::Vector2d> legs = {{x0 + 0.06, y0 - reach + 0.06},
                                               {x0 + wing - 0.06, y0 - reach + 0.06},
                                               {0.5 * width - 0.06, y0 + 0.06},
                                               {0.5 * width - 0.06, -y0 - 0.06},
                                               {x0 + 0.06, -y0 - 0.06}};
    for (std::size_t i = 0; i < legs.size(); ++i) {
      m.box("leg " + std::to_string(i + 1), metal,
            {legs[i].x() - 0.5 * s, legs[i].y() - 0.5 * s, glide},
            {legs[i].x() + 0.5 * s, legs[i].y() + 0.5 * s, top + 2 * joint});
    }
  } else {
    top_board(m, wood, width, depth, height, thick);
    const double side = m.series("leg", {0.04, 0.05, 0.06});
    corner_legs(m, metal, width, depth, top, side, 0.02);
    rails(m, metal, width, depth, top, side, 0.02);
  }
}

void make_table(Maker& m) {
  const int wood = m.material({"beech", "oak", "walnut", "melamine white"});
  const double height = m.size("height", 0.745, 0.012, 0.72, 0.78);
  const double thick = m.size("thickness", 0.026, 0.004, 0.018, 0.04);
  const double top = height - thick;
  if (m.is("round pedestal")) {
    const double diameter = m.series("diameter", {0.8, 0.9, 1.0, 1.1, 1.2});
    const int metal = m.material({"steel painted", "aluminium", "chrome"});
    m.add(lathe_part("top", wood, {{0.5 * diameter, top}, {0.5 * diameter, height}}, 32));
    m.add(lathe_part("column", metal, {{0.04, 0.02}, {0.04, top + joint}}, 16));
    m.add(lathe_part("foot", metal,
                     {{0.28 * diameter, glide}, {0.28 * diameter, 0.012}, {0.05, 0.03}}, 24));
    return;
  }
  const double width = m.series("width", {1.2, 1.4, 1.6, 1.8, 2.0});
  const double depth = m.series("depth", {0.7, 0.8, 0.9, 0.9, 1.0});
  top_board(m, wood, width, depth, height, thick);
  if (m.is("trestles")) {
    for (const double s : {-1.0, 1.0}) {
      const std::string side = s < 0 ? "left " : "right ";
      const double x = s * (0.5 * width - 0.3);
      m.box(side + "beam", wood, {x - 0.03, -0.5 * depth + 0.06, top - 0.05},
            {x + 0.03, 0.5 * depth - 0.06, top + joint});
      int leg = 0;
      for (const double sy : {-1.0, 1.0}) {
        for (const double tilt : {-1.0, 1.0}) {
          const Eigen::Vector3d head(x + tilt * 0.012, sy * (0.5 * depth - 0.12), top - 0.02);
          m.leg(side + "leg " + std::to_string(++leg), wood, x + tilt * 0.13,
                sy * (0.5 * depth - 0.10), head, 0.018);
        }
      }
    }
    return;
  }
  const double side = m.series("leg", {0.05, 0.06, 0.07, 0.08});
  corner_legs(m, wood, width, depth, top, side, 0.015);
  rails(m, wood, width, depth, top, side, 0.015);
}

void make_meeting_table(Maker& m) {
  const int wood = m.material({"beech", "oak", "walnut", "melamine white", "melamine grey"});
  const int metal = m.material({"steel painted", "aluminium", "plastic black"});
  const double height = m.size("height", 0.74, 0.01, 0.72, 0.76);
  const double width = m.series("width", {2.0, 2.4, 2.8, 3.2, 3.6});
  const double depth = m.series("depth", {0.9, 1.0, 1.1, 1.2});
  const double thick = 0.028;
  const double top = height - thick;
  if (m.is("boat shape")) {
    const double narrow = 0.4 * depth;
    m.add(prism_part("top", wood,
                     {{-0.5 * width, -narrow},
                      {-0.2 * width, -0.5 * depth},
                      {0.2 * width, -0.5 * depth},
                      {0.5 * width, -narrow},
                      {0.5 * width, narrow},
                      {0.2 * width, 0.5 * depth},
                      {-0.2 * width, 0.5 * depth},
                      {-0.5 * width, narrow}},
                     top, height));
  } else {
    top_board(m, wood, width, depth, height, thick);
  }
  if (m.is("four legs")) {
    corner_legs(m, metal, width, depth, top, 0.07, 0.03);
    return;
  }
  const int stands = width > 2.9 ? 3 : 2;
  for (int i = 0; i < stands; ++i) {
    const double x = (i - 0.5 * (stands - 1)) * (width - 1.0) / (stands - 1);
    const std::string number = std::to_string(i + 1);
    m.box("foot " + number, metal, {x - 0.05, -0.35 * depth, glide},
          {x + 0.05, 0.35 * depth, 0.03});
    m.box("column " + number, metal, {x - 0.04, -0.12, 0.03 - joint},
          {x + 0.04, 0.12, top + joint});
  }
}

void make_coffee_table(Maker& m) {
  const int wood = m.material({"beech", "oak", "walnut", "melamine white"});
  const double height = m.size("height", 0.43, 0.04, 0.32, 0.52);
  if (m.is("round")) {
    const double diameter = m.series("diameter", {0.6, 0.7, 0.8, 0.9});
    m.add(
        lathe_part("top", wood, {{0.5 * diameter, height - 0.022}, {0.5 * diameter, height}}, 28));
    for (int i = 0; i < 3; ++i) {
      const SinCos sc = portable_sincos(2.0 * pi * i / 3.0 + 0.5);
      const Eigen::Vector3d head(0.28 * diameter * sc.cos, 0.28 * diameter * sc.sin,
                                 height - 0.022 + joint);
      m.leg("leg " + std::to_string(i + 1), wood, 0.40 * diameter * sc.cos,
            0.40 * diameter * sc.sin, head, 0.016);
    }
    return;
  }
  const double width = m.series("width", {0.9, 1.0, 1.1, 1.2});
  const double depth = m.series("depth", {0.5, 0.55, 0.6, 0.7});
  top_board(m, wood, width, depth, height, 0.022);
  corner_legs(m, wood, width, depth, height - 0.022, 0.05, 0.015);
  if (m.is("with tray")) {
    const double x = 0.5 * width - 0.015 - 0.05 + joint;
    m.box("tray", wood, {-x, -0.5 * depth + 0.02, 0.14}, {x, 0.5 * depth - 0.02, 0.158});
  }
}

void make_workbench(Maker& m) {
  const int wood = m.material({"beech", "oak", "melamine grey"});
  const int metal = m.material({"steel painted", "steel blue", "paint grey"});
  const double width = m.series("width", {1.5, 1.5, 1.8, 2.0});
  const double depth = m.series("depth", {0.7, 0.75, 0.8});
  const double height = m.size("height", 0.87, 0.03, 0.8, 0.95);
  const double top = height - 0.04;
  top_board(m, wood, width, depth, height, 0.04);
  corner_legs(m, metal, width, depth, top, 0.06, 0.02);
  rails(m, metal, width, depth, top, 0.06, 0.02);
  const double x = 0.5 * width - 0.08 + joint;
  if (m.is("with shelf")) {
    m.box("lower board", wood, {-x, -0.5 * depth + 0.10, 0.2}, {x, 0.5 * depth - 0.04, 0.22});
  } else if (m.is("with drawers")) {
    m.box("drawer box", metal, {x - 0.5, -0.5 * depth + 0.05, top - 0.45},
          {x + joint, 0.5 * depth - 0.1, top - joint * 2});
    for (int i = 0; i < 3; ++i) {
      const double z = top - 0.445 + 0.145 * i;
      m.box("drawer " + std::to_string(i + 1), metal, {x - 0.49, -0.5 * depth + 0.032, z},
            {x - 0.012, -0.5 * depth + 0.05 + joint, z + 0.14});
    }
  }
}

}  // namespace

std::vector<CatalogueEntry> table_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"desk",
        id("desk"),
        {"four legs", "panel legs", "L-shape", "height-adjustable"},
        Place::floor,
        false,
        600},
       make_desk},
      {{"table",
        id("table"),
        {"four legs", "trestles", "round pedestal"},
        Place::floor,
        false,
        600},
       make_table},
      {{"meeting table",
        id("meeting table"),
        {"columns", "four legs", "boat shape"},
        Place::floor,
        false,
        600},
       make_meeting_table},
      {{"coffee table",
        id("coffee table"),
        {"four legs", "with tray", "round"},
        Place::floor,
        false,
        600},
       make_coffee_table},
      {{"workbench",
        id("workbench"),
        {"plain", "with shelf", "with drawers"},
        Place::floor,
        false,
        700},
       make_workbench},
  };
}

}  // namespace scanchor
