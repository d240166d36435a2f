// Chairs, stools, sofas, beds. Seat heights: EN 1335-1 (office work chairs: from 400 mm, at least
// 120 mm of travel); see docs/reference/furniture.md.

#include <algorithm>

#include "scenes/catalogue/maker.hpp"

namespace scanchor {
namespace {

/// Five arms with castors and a gas column up to `top`.
void star_base(Maker& m, int metal, int rubber, double radius, double top) {
  m.add(lathe_part("column", metal,
                   {{0.03, 0.06}, {0.03, 0.5 * top}, {0.022, 0.5 * top + 0.02}, {0.022, top}}, 12));
  m.add(lathe_part("hub", metal, {{0.05, 0.068}, {0.05, 0.112}}, 12));
  for (int i = 0; i < 5; ++i) {
    const std::string number = std::to_string(i + 1);
    const double angle = 2.0 * pi * i / 5.0 + 0.31;
    const SinCos sc = portable_sincos(angle);
    const Eigen::Matrix3d turn = rotation_about(2, angle);
    // The arms begin in the hub, where they do not reach each other.
    const double middle = 0.5 * (radius + 0.032);
    m.add(turned_box_part("arm " + number, metal,
                          Eigen::Vector3d(middle * sc.cos, middle * sc.sin, 0.09),
                          {radius - 0.032, 0.035, 0.03}, turn));
    const Eigen::Vector3d hub(0.94 * radius * sc.cos, 0.94 * radius * sc.sin, 0.029 + glide);
    const Eigen::Vector3d axle(-0.022 * sc.sin, 0.022 * sc.cos, 0.0);
    m.add(cylinder_part("castor " + number, rubber, hub - axle, hub + axle, 0.029, 12));
    m.add(cylinder_part("pin " + number, metal, {hub.x(), hub.y(), 0.035}, {hub.x(), hub.y(), 0.08},
                        0.008, 6));
  }
}

void make_chair(Maker& m) {
  const double width = m.size("width", 0.45, 0.02, 0.40, 0.50);
  const double depth = m.size("depth", 0.43, 0.02, 0.38, 0.47);
  const double back = m.size("back_height", 0.42, 0.05, 0.32, 0.6);
  const double lean = radians(m.number("lean_deg", 4.0, 12.0));
  const Eigen::Matrix3d tilt = rotation_about(0, -lean);
  if (m.is("office star base")) {
    const double seat = m.size("seat_height", 0.47, 0.025, 0.40, 0.52);
    const int cloth = m.material({"fabric black", "fabric blue", "fabric grey", "fabric red"});
    const int metal = m.material({"plastic black", "aluminium", "chrome"});
    const int rubber = m.material({"rubber"});
    star_base(m, metal, rubber, m.size("base_radius", 0.32, 0.01, 0.29, 0.35), seat - 0.05);
    m.add(cushion_part("seat", cloth, {0, 0, seat - 0.03}, {width, depth, 0.08}, 0.35, 16));
    const Eigen::Vector3d root(0, 0.5 * depth + 0.01, seat + 0.12);
    m.add(cushion_part("backrest", cloth, Eigen::Vector3d::Zero(), {0.94 * width, 0.06, back}, 0.4,
                       16));
    m.instance.parts.back().T_instance_part =
        pose_at(root + tilt * Eigen::Vector3d(0, 0, 0.5 * back), tilt);
    m.box("spine", metal, {-0.03, 0.5 * depth - 0.12, seat - 0.085},
          {0.03, 0.5 * depth + 0.05, seat - 0.06});
    m.add(cylinder_part("bracket", metal, {0, 0.5 * depth + 0.03, seat - 0.08},
                        {0, 0.5 * depth + 0.05, seat + 0.2}, 0.016, 8));
    if (m.random.chance(0.6)) {
      for (const double s : {-1.0, 1.0}) {
        const std::string side = s < 0 ? "left " : "right ";
        const double x = s * (0.5 * width + 0.035);
        m.box(side + "armrest", metal, {x - 0.03, -0.14, seat + 0.18},
              {x + 0.03, 0.12, seat + 0.205});
        m.box(side + "arm post", metal, {x - 0.018, -0.03, seat - 0.07},
              {x + 0.018, 0.03, seat + 0.18 + joint});
        const double inner = s * (0.5 * width - 0.08);
        m.box(side + "arm bar", metal, {std::min(inner, x), -0.02, seat - 0.066},
              {std::max(inner, x), 0.02, seat - 0.052});
      }
    }
    return;
  }
  const double seat = m.size("seat_height", 0.45, 0.012, 0.42, 0.48);
  const int wood = m.material({"beech", "oak", "plastic black", "plastic white", "fabric grey"});
  const int frame = m.material({"beech", "oak", "chrome", "steel painted"});
  const double t = 0.025;
  m.box("seat", wood, {-0.5 * width, -0.5 * depth, seat - t}, {0.5 * width, 0.5 * depth, seat});
  const Eigen::Vector3d root(0, 0.5 * depth - 0.01, seat + 0.16);
  m.add(turned_box_part("backrest", wood, root + tilt * Eigen::Vector3d(0, 0, 0.5 * back - 0.05),
                        {width - 0.02, 0.02, back - 0.1}, tilt));
  if (m.is("cantilever")) {
    // Two bent tubes: runner, front upright, arm below the seat, back upright.
    for (const double s : {-1.0, 1.0}) {
      const std::string side = s < 0 ? "left " : "right ";
      const double x = s * (0.5 * width - 0.03);
      const double y0 = -0.5 * depth + 0.03;
      const double y1 = 0.5 * depth + 0.02;
      const double r = 0.0125;
      m.add(cylinder_part(side + "runner", frame, {x, y0, r + glide}, {x, y1, r + glide}, r, 8));
      m.add(cylinder_part(side + "upright", frame, {x, y0, r + 0.005}, {x, y0, seat - t - 0.006}, r,
                          8));
      m.add(cylinder_part(side + "bearer", frame, {x, y0, seat - t - 0.010},
                          {x, y1 - 0.016, seat - t - 0.010}, r, 8));  // ends behind the seat
      m.add(cylinder_part(side + "back tube", frame, {x, y1 - 0.03, seat - t - 0.012},
                          root + tilt * Eigen::Vector3d(x, 0.008, back - 0.12), r, 8));
    }
    return;
  }
  int number = 0;
  for (const double sy : {-1.0, 1.0}) {
    for (const double sx : {-1.0, 1.0}) {
      const double x = sx * (0.5 * width - 0.03);
      const double y = sy * (0.5 * depth - 0.03);
      m.box("leg " + std::to_string(++number), frame, {x - 0.018, y - 0.018, glide},
            {x + 0.018, y + 0.018, seat - t + 2 * joint});
    }
  }
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (0.5 * width - 0.045);
    m.add(cylinder_part(s < 0 ? "left stile" : "right stile", frame,
                        {x, 0.5 * depth - 0.03, seat - 0.01},
                        root + tilt * Eigen::Vector3d(x, 0.012, back - 0.14), 0.012, 8));
  }
}

void make_stool(Maker& m) {
  const int wood = m.material({"beech", "oak", "plastic black", "leather black"});
  const int metal = m.material({"chrome", "steel painted", "beech"});
  const double r = m.size("radius", 0.175, 0.012, 0.15, 0.2);
  const double height = m.is("bar") ? m.size("height", 0.74, 0.03, 0.65, 0.82)
                                    : m.size("height", 0.46, 0.03, 0.42, 0.6);
  m.add(lathe_part("seat", wood, {{r, height - 0.035}, {r, height}}, 20));
  if (m.is("laboratory")) {
    star_base(m, metal, m.material({"rubber"}), 0.27, height - 0.035 + joint);
    return;
  }
  for (int i = 0; i < 4; ++i) {
    const SinCos sc = portable_sincos(0.5 * pi * i + 0.25 * pi);
    m.leg("leg " + std::to_string(i + 1), metal, 1.05 * r * sc.cos, 1.05 * r * sc.sin,
          {0.75 * r * sc.cos, 0.75 * r * sc.sin, height - 0.035 + joint}, 0.013);
  }
}

void make_sofa(Maker& m) {
  const int seats = m.is("armchair") ? 1 : m.count("seats", 2, 3);
  const double seat_width = m.size("seat_width", 0.64, 0.04, 0.55, 0.75);
  const double arm = m.is("without arms") ? 0.0 : m.size("arm_width", 0.16, 0.03, 0.10, 0.24);
  const double width = seats * seat_width + 2 * arm;
  const double depth = m.size("depth", 0.88, 0.05, 0.78, 1.0);
  const double seat = m.size("seat_height", 0.43, 0.02, 0.38, 0.48);
  const double back = m.size("height", 0.82, 0.05, 0.72, 0.95);
  const int cloth =
      m.material({"fabric grey", "fabric blue", "fabric beige", "leather black", "fabric red"});
  const int wood = m.material({"oak", "plastic black"});
  m.box("base", cloth, {-0.5 * width + 0.01, -0.5 * depth + 0.03, 0.08},
        {0.5 * width - 0.01, 0.5 * depth, seat - 0.14});
  m.box("back", cloth, {-0.5 * width + 0.012, 0.5 * depth - 0.2, seat - 0.14 - joint},
        {0.5 * width - 0.012, 0.5 * depth - 0.003, back - 0.05});
  for (const double s : {-1.0, 1.0}) {
    if (arm <= 0) break;
    const double x0 = s < 0 ? -0.5 * width : 0.5 * width - arm;
    m.box(s < 0 ? "left arm" : "right arm", cloth, {x0, -0.5 * depth, 0.06},
          {x0 + arm, 0.5 * depth - 0.006, std::min(seat + 0.18, back - 0.07)});
  }
  for (int i = 0; i < seats; ++i) {
    const double x = -0.5 * width + arm + seat_width * (i + 0.5);
    const std::string number = std::to_string(i + 1);
    m.add(cushion_part("seat cushion " + number, cloth, {x, -0.1, seat - 0.075},
                       {seat_width - 0.01, depth - 0.22, 0.15}, 0.28, 16));
    m.add(cushion_part("back cushion " + number, cloth,
                       {x, 0.5 * depth - 0.27, 0.5 * (seat + back) - 0.01},
                       {seat_width - 0.012, 0.16, back - seat + 0.04}, 0.35, 16));
  }
  int number = 0;
  for (const double sy : {-1.0, 1.0}) {
    for (const double sx : {-1.0, 1.0}) {
      const double x = sx * (0.5 * width - 0.1);
      const double y = sy * (0.5 * depth - 0.1);
      m.add(cylinder_part("foot " + std::to_string(++number), wood, {x, y, glide},
                          {x, y, 0.08 + joint}, 0.025, 8));
    }
  }
}

void make_bed(Maker& m) {
  const double width =
      m.is("single") ? m.series("width", {0.9, 0.9, 1.0}) : m.series("width", {1.4, 1.6, 1.8});
  const double length = m.series("length", {2.0, 2.0, 2.1});
  const double rim = m.size("rim_height", 0.38, 0.03, 0.3, 0.45);
  const int wood = m.material({"beech", "oak", "walnut", "melamine white"});
  const int linen = m.material({"linen white", "fabric blue", "fabric beige"});
  const double w = width + 0.06;
  const double d = length + 0.06;
  // Head at +y, against the wall.
  m.box("frame", wood, {-0.5 * w, -0.5 * d, rim - 0.2}, {0.5 * w, 0.5 * d, rim});
  m.box("mattress", linen, {-0.5 * width, -0.5 * length, rim - joint},
        {0.5 * width, 0.5 * length, rim + 0.16});
  int number = 0;
  for (const double sy : {-1.0, 1.0}) {
    for (const double sx : {-1.0, 1.0}) {
      const double x = sx * (0.5 * w - 0.06);
      const double y = sy * (0.5 * d - 0.06);
      m.box("leg " + std::to_string(++number), wood, {x - 0.03, y - 0.03, glide},
            {x + 0.03, y + 0.03, rim - 0.2 + joint});
    }
  }
  if (m.is("box spring") || m.is("single")) {
    m.box("headboard", wood, {-0.5 * w - 0.01, 0.5 * d - joint, 0.1},
          {0.5 * w + 0.01, 0.5 * d + 0.05, rim + 0.55});
  }
  const int pillows = m.is("single") ? 1 : 2;
  for (int i = 0; i < pillows; ++i) {
    const double x = pillows == 1 ? 0.0 : (i == 0 ? -0.25 : 0.25) * width;
    m.add(cushion_part("pillow " + std::to_string(i + 1), linen,
                       {x, 0.5 * length - 0.28, rim + 0.16 + 0.055}, {0.62, 0.4, 0.13}, 0.45, 14));
  }
  m.add(cushion_part("duvet", linen, {0, -0.2, rim + 0.18}, {width + 0.02, length - 0.6, 0.14},
                     0.25, 16));
}

}  // namespace

std::vector<CatalogueEntry> seating_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"chair",
        id("chair"),
        {"office star base", "four legs", "cantilever"},
        Place::floor,
        false,
        150},
       make_chair},
      {{"stool", id("stool"), {"four legs", "laboratory", "bar"}, Place::floor, false, 200},
       make_stool},
      {{"sofa", id("sofa"), {"with arms", "without arms", "armchair"}, Place::floor, false, 60},
       make_sofa},
      {{"bed", id("bed"), {"single", "double", "box spring"}, Place::floor, false, 60}, make_bed},
  };
}

}  // namespace scanchor
