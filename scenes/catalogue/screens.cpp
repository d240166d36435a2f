// Screens, boards and what lies on desks. Screens are 16:9 of a given diagonal; paper and board
// formats as sold.

#include <algorithm>
#include <cmath>

#include "scenes/catalogue/maker.hpp"
#include "scenes/truth.hpp"

namespace scanchor {
namespace {

/// Width and height of a 16:9 screen from its diagonal in inches, without the bezel.
Eigen::Vector2d sixteen_by_nine(double inches) {
  const double k = inches * 0.0254 / std::sqrt(337.0);
  return {std::floor(16.0 * k * 1000.0 + 0.5) / 1000.0,
          std::floor(9.0 * k * 1000.0 + 0.5) / 1000.0};
}

void make_monitor(Maker& m) {
  const double inches = m.series("diagonal_inch", {21.5, 23.8, 23.8, 23.8, 27.0, 27.0, 31.5});
  const Eigen::Vector2d panel = sixteen_by_nine(inches);
  const double width = panel.x() + 0.014;
  const double height = panel.y() + 0.024;
  const double tilt = m.number("tilt_deg", 0.0, 12.0);
  const double lift = m.size("lift", 0.13, 0.04, 0.06, 0.22);  // lower edge above the desk
  const int screen = m.material({"screen"});
  const int plastic = m.material({"plastic black", "plastic black", "plastic grey"});
  const Eigen::Matrix3d lean = rotation_about(0, -radians(tilt));  // the upper edge goes back
  const double z = lift + 0.5 * height;
  m.add(turned_box_part("screen", screen, {0, -0.02, z}, {width, 0.022, height}, lean));
  const Eigen::Vector3d behind = Eigen::Vector3d(0, -0.02, z) + lean * Eigen::Vector3d(0, 0.02, 0);
  m.add(turned_box_part("housing", plastic, behind, {0.6 * width, 0.022, 0.55 * height}, lean));
  if (m.is("arm")) {
    // Clamped to the back edge of the desk, which lies at y = reach.
    const double reach = m.size("reach", 0.3, 0.05, 0.2, 0.4);
    m.instance.loose = false;
    m.add(cylinder_part("post", plastic, {0, reach, 0.008}, {0, reach, z + 0.05}, 0.018, 12));
    m.add(cylinder_part("arm", plastic, {0, 0.003, z}, {0, reach, z}, 0.016, 10));
    m.add(
        lathe_part("clamp", plastic, {{0.045, glide}, {0.045, 0.02}}, 12, pose_at({0, reach, 0})));
    return;
  }
  const int foot = m.material({"plastic black", "aluminium"});
  const double deep = m.size("foot_depth", 0.2, 0.02, 0.16, 0.25);
  m.box("column", foot, {-0.03, 0.0, 0.012 - joint}, {0.03, 0.035, z});
  if (m.is("round stand")) {
    m.add(lathe_part("foot", foot, {{0.12, 0.0}, {0.12, 0.012}}, 20, pose_at({0, 0.01, 0})));
  } else {
    m.box("foot", foot, {-0.12, 0.03 - 0.6 * deep, 0.0}, {0.12, 0.03 + 0.4 * deep, 0.012});
  }
}

void make_laptop(Maker& m) {
  const double inches = m.series("diagonal_inch", {13.3, 14.0, 15.6, 17.3});
  const Eigen::Vector2d panel = sixteen_by_nine(inches);
  const double width = panel.x() + 0.02;
  const double depth = panel.y() + 0.035;
  const int body = m.material({"aluminium", "plastic black", "plastic grey"});
  const int screen = m.material({"screen"});
  m.box("base", body, {-0.5 * width, -0.5 * depth, 0.0}, {0.5 * width, 0.5 * depth, 0.018});
  if (m.is("closed")) {
    m.box("lid", body, {-0.5 * width + 0.003, -0.5 * depth + 0.003, 0.018 - joint},
          {0.5 * width - 0.003, 0.5 * depth - 0.003, 0.025});
    return;
  }
  const double open = m.number("opening_deg", 95.0, 125.0);
  const Eigen::Matrix3d lean = rotation_about(0, -radians(open - 90.0));
  const Eigen::Vector3d hinge(0, 0.5 * depth - 0.008, 0.016);
  m.add(turned_box_part("screen", screen, hinge + lean * Eigen::Vector3d(0, 0, 0.5 * depth),
                        {width - 0.004, 0.007, depth}, lean));
}

void make_keyboard(Maker& m) {
  const double width =
      m.is("compact") ? m.series("width", {0.28, 0.3}) : m.series("width", {0.43, 0.44, 0.45});
  const double depth = m.size("depth", 0.14, 0.012, 0.11, 0.17);
  const int body = m.material({"plastic black", "plastic white", "plastic grey"});
  m.box("base", body, {-0.5 * width, -0.5 * depth, 0.0}, {0.5 * width, 0.5 * depth, 0.014});
  m.box("keys", body, {-0.5 * width + 0.006, -0.5 * depth + 0.006, 0.014 - joint},
        {0.5 * width - 0.006, 0.5 * depth - 0.02, 0.022});
}

void make_mouse(Maker& m) {
  const int body = m.material({"plastic black", "plastic white", "plastic grey"});
  const double length = m.size("length", 0.115, 0.008, 0.095, 0.13);
  m.add(lathe_part(
      "shell", body,
      m.is("flat")
          ? std::vector<Eigen::Vector2d>{{0.028, 0.0}, {0.029, 0.01}, {0.02, 0.024}, {0.0, 0.026}}
          : std::vector<Eigen::Vector2d>{{0.03, 0.0}, {0.032, 0.014}, {0.024, 0.032}, {0.0, 0.04}},
      12));
  // The turned body is stretched to the mouse's length.
  for (auto& v : m.instance.parts.back().vertices) v.y() *= length / 0.064;
  measure_faces(m.instance.parts.back());
}

void make_telephone(Maker& m) {
  const int body = m.material({"plastic black", "plastic grey"});
  const double width = m.size("width", 0.2, 0.015, 0.16, 0.24);
  const double z = 0.05;
  m.add(prism_part("base", body, {{-0.09, 0.0}, {0.09, 0.0}, {0.09, 0.055}, {-0.09, 0.02}},
                   -0.5 * width, 0.5 * width,
                   pose_at(Eigen::Vector3d::Zero(),
                           (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished())));
  m.add(capsule_part("handset", body, {-0.5 * width + 0.03, -0.06, z},
                     {-0.5 * width + 0.03, 0.06, z + 0.01}, 0.02, 0.02, 10));
  if (m.is("with display"))
    m.box("display", m.material({"screen"}), {0.0, 0.03, 0.03},
          {std::min(0.08, 0.5 * width - 0.012), 0.036, 0.09});
}

void make_printer(Maker& m) {
  const int body = m.material({"plastic white", "plastic grey", "plastic black"});
  const int dark = m.material({"plastic black"});
  const bool large = m.is("multifunction");
  const double width =
      large ? m.size("width", 0.52, 0.04, 0.42, 0.6) : m.size("width", 0.4, 0.03, 0.34, 0.46);
  const double depth = large ? 0.48 : 0.36;
  const double height =
      large ? m.size("height", 0.45, 0.04, 0.36, 0.55) : m.size("height", 0.24, 0.03, 0.18, 0.32);
  m.box("body", body, {-0.5 * width, -0.5 * depth, 0.0}, {0.5 * width, 0.5 * depth, 0.8 * height});
  m.box("lid", dark, {-0.5 * width + 0.012, -0.5 * depth + 0.012, 0.8 * height - joint},
        {0.5 * width - 0.012, 0.5 * depth - 0.012, height});
  m.box("tray", dark, {-0.36 * width, -0.5 * depth - 0.09, 0.05},
        {0.36 * width, -0.5 * depth + joint, 0.065});
}

void make_television(Maker& m) {
  const double inches = m.series("diagonal_inch", {32, 43, 50, 55, 65});
  const Eigen::Vector2d panel = sixteen_by_nine(inches);
  const double width = panel.x() + 0.016;
  const double height = panel.y() + 0.03;
  const int screen = m.material({"screen"});
  const int plastic = m.material({"plastic black"});
  if (m.is("wall mount")) {
    // Origin at the wall, at the middle of the screen's lower edge; the wall is at y = 0.
    m.box("screen", screen, {-0.5 * width, -0.085, 0.0}, {0.5 * width, -0.055, height});
    m.box("mount", plastic, {-0.2, -0.055 - joint, 0.5 * height - 0.1},
          {0.2, -0.003, 0.5 * height + 0.1});
    return;
  }
  m.box("screen", screen, {-0.5 * width, -0.02, 0.07}, {0.5 * width, 0.012, 0.07 + height});
  for (const double s : {-1.0, 1.0}) {
    m.box(s < 0 ? "left foot" : "right foot", plastic, {s * 0.36 * width - 0.015, -0.12, glide},
          {s * 0.36 * width + 0.015, 0.12, 0.012});
    m.box(s < 0 ? "left post" : "right post", plastic,
          {s * 0.36 * width - 0.01, -0.012, 0.012 - joint},
          {s * 0.36 * width + 0.01, 0.006, 0.07 + joint});
  }
}

void make_whiteboard(Maker& m) {
  const double width = m.series("width", {1.2, 1.5, 1.8, 2.0, 2.4});
  const double height = m.series("height", {0.9, 1.0, 1.2});
  const int white = m.material({"enamel white"});
  const int metal = m.material({"aluminium"});
  const double f = 0.015;
  if (m.is("on stand")) {
    const double z = 0.85;
    m.box("board", white, {-0.5 * width, -0.012, z}, {0.5 * width, 0.012, z + height});
    for (const double s : {-1.0, 1.0}) {
      const std::string side = s < 0 ? "left " : "right ";
      const double x = s * (0.5 * width + 0.02 - joint);
      m.box(side + "post", metal, {x - 0.02, -0.02, 0.05 - joint},
            {x + 0.02, 0.02, z + height + 0.03});
      m.box(side + "foot", metal, {x - 0.025, -0.3, glide}, {x + 0.025, 0.3, 0.05});
    }
    return;
  }
  // The wall is at y = 0; the board hangs 6 mm in front of it.
  m.box("board", white, {-0.5 * width, -0.022, 0.0}, {0.5 * width, -0.006, height});
  m.box("upper frame", metal, {-0.5 * width - f, -0.026, height - joint},
        {0.5 * width + f, -0.0075, height + f});
  m.box("lower frame", metal, {-0.5 * width - f, -0.026, -f}, {0.5 * width + f, -0.0075, joint});
  if (m.is("with tray"))
    m.box("tray", metal, {-0.4 * width, -0.09, -0.012}, {0.4 * width, -0.026 + joint, -0.004});
}

void make_picture(Maker& m) {
  // Frames for ISO 216 A3..A0 with a mat, and square canvases.
  const double width = m.series("width", {0.3, 0.4, 0.5, 0.6, 0.7, 0.9});
  const double height = m.is("square") ? width : m.is("portrait") ? 1.4 * width : 0.7 * width;
  const int picture = m.material({"canvas", "paper", "book blue", "fabric red"});
  const int frame = m.material({"oak", "plastic black", "aluminium", "walnut"});
  const double f = 0.025;
  m.box("picture", picture, {-0.5 * width, -0.014, 0.0}, {0.5 * width, -0.0065, height});
  m.box("upper frame", frame, {-0.5 * width - f, -0.022, height - joint},
        {0.5 * width + f, -0.003, height + f});
  m.box("lower frame", frame, {-0.5 * width - f, -0.022, -f}, {0.5 * width + f, -0.003, joint});
  for (const double s : {-1.0, 1.0}) {
    const double a = s < 0 ? -0.5 * width - f + 0.0015 : 0.5 * width - joint;
    const double b = s < 0 ? -0.5 * width + joint : 0.5 * width + f - 0.0015;
    m.box(s < 0 ? "left frame" : "right frame", frame, {a, -0.020, -joint},
          {b, -0.0045, height + joint});
  }
}

}  // namespace

std::vector<CatalogueEntry> screen_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"monitor", id("monitor"), {"stand", "round stand", "arm"}, Place::surface, true, 400},
       make_monitor},
      {{"laptop", id("laptop"), {"open", "closed"}, Place::surface, true, 900}, make_laptop},
      {{"keyboard", id("keyboard"), {"full size", "compact"}, Place::surface, true, 500},
       make_keyboard},
      {{"mouse", id("mouse"), {"round", "flat"}, Place::surface, true, 500}, make_mouse},
      {{"telephone", id("telephone"), {"plain", "with display"}, Place::surface, true, 400},
       make_telephone},
      {{"printer", id("printer"), {"small", "multifunction"}, Place::surface, true, 250},
       make_printer},
      {{"television", id("television"), {"wall mount", "feet"}, Place::wall, false, 300},
       make_television},
      {{"whiteboard",
        id("whiteboard"),
        {"plain", "with tray", "on stand"},
        Place::wall,
        false,
        500},
       make_whiteboard},
      {{"picture", id("picture"), {"landscape", "portrait", "square"}, Place::wall, false, 500},
       make_picture},
  };
}

}  // namespace scanchor
