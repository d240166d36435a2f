// Boxes, pallets, racks, trolleys. Pallet: EN 13698-1; box footprints: the 600 x 400 mm module of
// ISO 3394.

#include <algorithm>
#include <cmath>

#include "scenes/catalogue/maker.hpp"

namespace scanchor {
namespace {

Eigen::Vector3d box_size(Maker& m, bool small) {
  // Modules of the pallet and what post and shops use.
  static const std::vector<Eigen::Vector2d> modules = {
      {0.2, 0.15}, {0.25, 0.175}, {0.3, 0.2}, {0.35, 0.25}, {0.4, 0.3}, {0.45, 0.35}, {0.6, 0.4}};
  const std::uint32_t top = small ? 4 : static_cast<std::uint32_t>(modules.size());
  const Eigen::Vector2d& base = modules[m.random.below(top)];
  Eigen::Vector3d size;
  const double give = m.random.uniform(0.95, 1.05);
  const auto mm = [](double v) { return std::floor(v * 1000.0 + 0.5) / 1000.0; };
  size.x() = m.size("width", mm(base.x() * give), 1e-6, 0.08, 0.8);
  size.y() = m.size("depth", mm(base.y() * give), 1e-6, 0.08, 0.8);
  size.z() = m.size("height", 0.55 * base.x(), 0.12 * base.x(), 0.06, 0.5);
  return size;
}

void make_box(Maker& m) {
  const Eigen::Vector3d size = box_size(m, m.is("parcel"));
  const int card = m.is("plastic crate") ? m.material({"plastic blue", "plastic grey"})
                                         : m.material({"cardboard", "cardboard", "paper"});
  const Eigen::Vector3d h = 0.5 * size;
  if (m.is("closed") || m.is("parcel")) {
    m.box("box", card, {-h.x(), -h.y(), 0.0}, {h.x(), h.y(), size.z()});
    return;
  }
  const double t = 0.006;
  m.box("bottom", card, {-h.x() + 0.5 * t, -h.y() + 0.002 + 0.5 * t, 0.0},
        {h.x() - 0.5 * t, h.y() - 0.002 - 0.5 * t, 0.008});
  for (const double s : {-1.0, 1.0}) {
    const double x = s * (h.x() - 0.5 * t);
    m.box(s < 0 ? "left wall" : "right wall", card, {x - 0.5 * t, -h.y(), 0.002},
          {x + 0.5 * t, h.y(), size.z()});
  }
  for (const double s : {-1.0, 1.0}) {
    const double y = s * (h.y() - 0.002 - 0.5 * t);
    m.box(s < 0 ? "front wall" : "back wall", card, {-h.x() + t - 0.0015, y - 0.5 * t, 0.004},
          {h.x() - t + 0.0015, y + 0.5 * t, size.z() - 0.002});
  }
  if (m.is("plastic crate")) return;
  // Two flaps stand out to the sides.
  const double lean = radians(m.number("flap_deg", 100.0, 140.0));
  for (const double s : {-1.0, 1.0}) {
    const Eigen::Matrix3d turn = rotation_about(1, s * (lean - 0.5 * pi) + (s > 0 ? 0.0 : pi));
    const Eigen::Vector3d hinge(s * (h.x() - 0.5 * t), 0, size.z() - 0.003);
    const double reach = 0.45 * size.y();
    m.add(turned_box_part(s < 0 ? "left flap" : "right flap", card,
                          hinge + turn * Eigen::Vector3d(0.5 * reach, 0, 0),
                          {reach, size.y() - 0.010, 0.004}, turn));
  }
}

void make_stack(Maker& m) {
  const int levels = m.count("levels", 2, 4);
  const int card = m.material({"cardboard", "cardboard", "paper", "plastic blue"});
  double width = m.series("width", {0.4, 0.4, 0.6});
  double depth = m.series("depth", {0.3, 0.4});
  double z = glide;
  for (int i = 0; i < levels; ++i) {
    const double height = m.size("height_" + std::to_string(i + 1), 0.28, 0.05, 0.15, 0.4);
    const double yaw = m.is("neat") ? 0.0 : radians(m.random.uniform(-6.0, 6.0));
    const double dx = m.is("neat") ? 0.0 : m.random.uniform(-0.02, 0.02);
    m.add(turned_box_part("box " + std::to_string(i + 1), card, {dx, 0.5 * dx, z + 0.5 * height},
                          {width, depth, height}, rotation_about(2, yaw)));
    z += height + glide;
    if (m.is("tapering")) {
      width *= 0.85;
      depth *= 0.85;
    }
  }
}

/// EN 13698-1: 1200 x 800 x 144 mm, eleven boards and nine blocks; the quarter size is the retail
/// display pallet 600 x 400.
void pallet(Maker& m, int wood, double length, double width, double z) {
  const double k = length / 1.2;
  const double w = width / 0.8;
  const double t = 0.022;
  static constexpr double rows[] = {-0.35, 0.0, 0.35};
  static constexpr double foot[] = {0.1, 0.145, 0.1};
  static constexpr double deck[] = {-0.3275, -0.16375, 0.0, 0.16375, 0.3275};
  static constexpr double board[] = {0.145, 0.1, 0.145, 0.1, 0.145};
  const auto low = [&](double x, double y, double a, double b, double z0) {
    return Eigen::Vector3d(x - 0.5 * a, y - 0.5 * b, z + z0);
  };
  const auto high = [&](double x, double y, double a, double b, double z1) {
    return Eigen::Vector3d(x + 0.5 * a, y + 0.5 * b, z + z1);
  };
  for (int r = 0; r < 3; ++r) {
    const double y = rows[r] * w + (r == 0 ? 1 : r == 2 ? -1 : 0) * 0.004;
    const std::string row = std::to_string(r + 1);
    m.box("runner " + row, wood, low(0, y, length - 0.006, foot[r] * w, 0.0),
          high(0, y, length - 0.006, foot[r] * w, t));
    for (int c = 0; c < 3; ++c) {
      const double x = (c - 1) * (0.5 * length - 0.0725 * k - 0.0015);
      m.box("block " + row + "." + std::to_string(c + 1), wood,
            low(x, y, 0.145 * k - 0.012, foot[r] * w - 0.008, t - joint),
            high(x, y, 0.145 * k - 0.012, foot[r] * w - 0.008, 0.1 + joint));
    }
  }
  for (int c = 0; c < 3; ++c) {
    const double x = (c - 1) * (0.5 * length - 0.0725 * k - 0.0015);
    m.box("stringer " + std::to_string(c + 1), wood, low(x, 0, 0.145 * k, width - 0.004, 0.1),
          high(x, 0, 0.145 * k, width - 0.004, 0.122 + joint));
  }
  for (int b = 0; b < 5; ++b) {
    const double y = deck[b] * w;
    m.box("deck board " + std::to_string(b + 1), wood, low(0, y, length, board[b] * w, 0.122),
          high(0, y, length, board[b] * w, 0.144));
  }
}

void make_pallet(Maker& m) {
  const int wood = m.material({"raw wood"});
  if (m.is("half")) {
    pallet(m, wood, 0.8, 0.6, glide);
    return;
  }
  if (m.is("stack")) {
    const int levels = m.count("levels", 2, 6);
    for (int i = 0; i < levels; ++i) pallet(m, wood, 1.2, 0.8, glide + i * (0.144 + glide));
    return;
  }
  pallet(m, wood, 1.2, 0.8, glide);
}

void make_pallet_rack(Maker& m) {
  const double width = m.series("width", {1.8, 2.7, 2.7, 3.6});
  const double depth = m.series("depth", {0.8, 1.0, 1.1});
  const int levels = m.count("levels", 2, 3);
  const double pitch = m.size("pitch", 1.15, 0.15, 0.8, 1.5);
  const int post = m.material({"steel blue", "steel painted"});
  const int beam = m.material({"steel orange"});
  const int deck = m.material({"raw wood", "melamine grey", "stainless steel"});
  const double first = m.is("floor bay") ? pitch + 0.2 : 0.16;
  const double height = first + pitch * (levels - 1) + 0.5;
  m.instance.parameters["first_level"] = first;
  const double s = 0.1;
  int number = 0;
  for (const double sy : {-1.0, 1.0}) {
    for (const double sx : {-1.0, 1.0}) {
      const double x = sx * (0.5 * width - 0.5 * s);
      const double y = sy * (0.5 * depth - 0.035);
      m.box("post " + std::to_string(++number), post, {x - 0.5 * s, y - 0.035, glide},
            {x + 0.5 * s, y + 0.035, height});
    }
  }
  for (const double sx : {-1.0, 1.0}) {
    const double x = sx * (0.5 * width - 0.5 * s);
    const int braces = static_cast<int>(height / 0.6);
    for (int i = 0; i < braces; ++i) {
      const double z = 0.3 + 0.6 * i;
      m.box((sx < 0 ? "left brace " : "right brace ") + std::to_string(i + 1), post,
            {x - 0.015, -0.5 * depth + 0.07 - joint, z},
            {x + 0.015, 0.5 * depth - 0.07 + joint, z + 0.03});
    }
  }
  const double reach = 0.5 * width - s + joint;
  for (int i = 0; i < levels; ++i) {
    const double z = first + pitch * i;  // top of the deck
    const std::string level = std::to_string(i + 1);
    for (const double sy : {-1.0, 1.0}) {
      const double y = sy * (0.5 * depth - 0.03);
      m.box((sy < 0 ? "front beam " : "back beam ") + level, beam,
            {-reach, y - 0.025, z - 0.02 - 0.11}, {reach, y + 0.025, z - 0.02 + joint});
    }
    m.box("deck " + level, deck, {-reach + 0.004, -0.5 * depth + 0.012, z - 0.02},
          {reach - 0.004, 0.5 * depth - 0.012, z});
  }
}

void make_trolley(Maker& m) {
  const double width = m.series("width", {0.5, 0.6, 0.7});
  const double length = m.series("length", {0.8, 0.85, 1.0, 1.2});
  const int deck = m.material({"beech", "melamine grey", "steel blue"});
  const int metal = m.material({"steel blue", "steel painted", "stainless steel"});
  const int rubber = m.material({"rubber"});
  const double z = 0.17;
  m.box("platform", deck, {-0.5 * width, -0.5 * length, z}, {0.5 * width, 0.5 * length, z + 0.03});
  int number = 0;
  for (const double sy : {-1.0, 1.0}) {
    for (const double sx : {-1.0, 1.0}) {
      const double x = sx * (0.5 * width - 0.07);
      const double y = sy * (0.5 * length - 0.12);
      const std::string id = std::to_string(++number);
      m.add(cylinder_part("wheel " + id, rubber, {x - 0.016, y, 0.062 + glide},
                          {x + 0.016, y, 0.062 + glide}, 0.062, 16));
      m.box("fork " + id, metal, {x - 0.022, y - 0.02, 0.055}, {x + 0.022, y + 0.02, z + joint});
    }
  }
  const double top = m.is("platform") ? 0.95 : 0.9;
  const double r = 0.016;
  const int ends = m.is("platform") ? 1 : 2;
  for (int e = 0; e < ends; ++e) {
    const double y = (e == 0 ? 1.0 : -1.0) * (0.5 * length - 0.03);
    const std::string end = e == 0 ? "back " : "front ";
    for (const double s : {-1.0, 1.0}) {
      const double x = s * (0.5 * width - 0.04);
      m.add(cylinder_part(end + (s < 0 ? "left tube" : "right tube"), metal, {x, y, z + 0.012},
                          {x, y, top}, r, 8));
    }
    m.add(cylinder_part(end + "grip", metal, {-0.5 * width + 0.04, y, top - 0.004},
                        {0.5 * width - 0.04, y, top - 0.004}, r, 8));
  }
  if (m.is("platform")) return;
  const int shelves = m.is("three shelves") ? 2 : 1;
  for (int i = 0; i < shelves; ++i) {
    const double h = z + (top - 0.1 - z) * (i + 1) / shelves;
    m.box("shelf " + std::to_string(i + 1), deck,
          {-0.5 * width + 0.01, -0.5 * length + 0.012, h - 0.02},
          {0.5 * width - 0.01, 0.5 * length - 0.012, h});
  }
}

}  // namespace

std::vector<CatalogueEntry> logistics_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"box", id("box"), {"closed", "open", "parcel", "plastic crate"}, Place::surface, true, 120},
       make_box},
      {{"box stack", id("box"), {"neat", "crooked", "tapering"}, Place::floor, false, 120},
       make_stack},
      {{"pallet", id("pallet"), {"euro", "half", "stack"}, Place::floor, false, 500}, make_pallet},
      {{"pallet rack", id("pallet rack"), {"low bay", "floor bay"}, Place::floor, false, 400},
       make_pallet_rack},
      {{"trolley",
        id("trolley"),
        {"platform", "two shelves", "three shelves"},
        Place::floor,
        false,
        300},
       make_trolley},
  };
}

}  // namespace scanchor
