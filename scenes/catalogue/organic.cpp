// Round and grown things: meshes, not boxes. They are what a plane finder must survive.

#include "scenes/catalogue/maker.hpp"

namespace scanchor {
namespace {

/// A hollow vessel: outside up, over the rim, inside down to the bottom.
void vessel(Maker& m, const std::string& name, int material, double r_bottom, double r_top,
            double z, double height, double wall, int segments) {
  m.add(lathe_part(name, material,
                   {{r_bottom, z},
                    {r_top, z + height},
                    {r_top - wall, z + height},
                    {r_bottom - wall, z + 2 * wall},
                    {0.0, z + 2 * wall}},
                   segments));
}

void make_waste_bin(Maker& m) {
  const double r = m.size("radius", 0.14, 0.015, 0.11, 0.18);
  const double height = m.size("height", 0.32, 0.04, 0.25, 0.42);
  const int body = m.material({"plastic black", "plastic grey", "stainless steel"});
  if (m.is("square")) {
    const double a = r;
    m.box("bottom", body, {-a + 0.0005, -a + 0.0005, 0.002}, {a - 0.0005, a - 0.0005, 0.012});
    for (const double s : {-1.0, 1.0}) {
      m.box(s < 0 ? "left wall" : "right wall", body, {s * a - 0.004, -a - 0.0025, 0.0},
            {s * a + 0.004, a + 0.0025, height});
      m.box(s < 0 ? "front wall" : "back wall", body, {-a + joint, s * a - 0.004, 0.004},
            {a - joint, s * a + 0.004, height - 0.002});
    }
    return;
  }
  if (m.is("with lid")) {
    m.add(lathe_part("body", body,
                     {{0.85 * r, 0.0},
                      {r, height},
                      {0.9 * r, height + 0.05},
                      {0.4 * r, height + 0.09},
                      {0.0, height + 0.1}},
                     20));
    return;
  }
  vessel(m, "body", body, 0.8 * r, r, 0.0, height, 0.006, 20);
}

void make_floor_lamp(Maker& m) {
  const double height = m.size("height", 1.55, 0.15, 1.2, 1.9);
  const int metal = m.material({"steel painted", "chrome", "plastic black"});
  const int shade = m.material({"lampshade", "paper"});
  m.add(lathe_part("foot", metal, {{0.14, glide}, {0.14, 0.02}, {0.02, 0.035}, {0.012, 0.05}}, 20));
  m.add(cylinder_part("pole", metal, {0, 0, 0.04}, {0, 0, height - 0.12}, 0.011, 8));
  if (m.is("uplighter")) {
    m.add(lathe_part("bowl", metal,
                     {{0.03, height - 0.13}, {0.19, height}, {0.17, height}, {0.0, height - 0.1}},
                     20));
  } else {
    m.add(lathe_part("shade", shade,
                     {{0.21, height - 0.3},
                      {0.13, height},
                      {0.124, height},
                      {0.204, height - 0.3},
                      {0.21, height - 0.3}},
                     20));
    m.add(lathe_part("socket", metal,
                     {{0.016, height - 0.13},
                      {0.126, height - 0.04},
                      {0.126, height - 0.035},
                      {0.016, height - 0.1}},
                     12));
  }
}

void make_desk_lamp(Maker& m) {
  const int metal = m.material({"steel painted", "chrome", "plastic black"});
  m.add(lathe_part("foot", metal, {{0.085, 0.0}, {0.085, 0.015}, {0.03, 0.028}}, 16));
  const double height = m.size("height", 0.42, 0.05, 0.3, 0.55);
  if (m.is("shade")) {
    m.add(cylinder_part("pole", metal, {0, 0, 0.02}, {0, 0, height - 0.1}, 0.009, 8));
    m.add(lathe_part("shade", m.material({"lampshade"}),
                     {{0.11, height - 0.16}, {0.07, height}, {0.0, height + 0.003}}, 16));
    return;
  }
  const Eigen::Vector3d elbow(0.0, 0.12, 0.6 * height);
  const Eigen::Vector3d head(0.0, -0.1, height);
  m.add(cylinder_part("lower arm", metal, {0, 0, 0.02}, elbow, 0.008, 8));
  m.add(cylinder_part("upper arm", metal, elbow, head, 0.008, 8));
  m.add(lathe_part("head", metal, {{0.065, 0.0}, {0.035, 0.09}, {0.0, 0.1}}, 14,
                   pose_along(head + Eigen::Vector3d(0, -0.03, -0.06), head)));
}

/// Origin at the ceiling; hangs down.
void make_ceiling_lamp(Maker& m) {
  const int white = m.material({"lampshade", "plastic white"});
  const int metal = m.material({"aluminium", "enamel white"});
  const double drop = m.size("drop", 0.5, 0.15, 0.2, 0.9);
  if (m.is("linear")) {
    const double length = m.series("length", {1.2, 1.2, 1.5});
    for (const double s : {-1.0, 1.0}) {
      m.add(cylinder_part(s < 0 ? "left wire" : "right wire", metal,
                          {s * 0.4 * length, 0, -drop + 0.03}, {s * 0.4 * length, 0, -0.003}, 0.003,
                          6));
    }
    m.box("body", metal, {-0.5 * length, -0.08, -drop - 0.02}, {0.5 * length, 0.08, -drop + 0.04});
    m.box("diffuser", white, {-0.5 * length + 0.01, -0.07, -drop - 0.03},
          {0.5 * length - 0.01, 0.07, -drop - 0.02 + joint});
    return;
  }
  m.add(lathe_part("rose", metal, {{0.05, -0.03}, {0.05, -0.003}}, 12));
  m.add(cylinder_part("wire", metal, {0, 0, -drop}, {0, 0, -0.02}, 0.004, 6));
  if (m.is("globe")) {
    m.add(cushion_part("globe", white, {0, 0, -drop - 0.13}, {0.3, 0.3, 0.3}, 1.0, 16));
  } else {
    m.add(lathe_part("shade", white,
                     {{0.2, -drop - 0.2}, {0.05, -drop + 0.01}, {0.0, -drop + 0.02}}, 18));
  }
}

void make_plant(Maker& m) {
  const int pot = m.material({"terracotta", "ceramic", "plastic grey"});
  const int soil = m.material({"soil"});
  const int leaf = m.material({"leaf"});
  const int stem = m.material({"raw wood", "leaf"});
  const double r = m.size("pot_radius", 0.14, 0.03, 0.09, 0.2);
  const double z = 1.7 * r;
  const double height = m.size("height", 1.1, 0.25, 0.6, 1.7);
  vessel(m, "pot", pot, 0.75 * r, r, glide, z, 0.008, 18);
  m.add(lathe_part("soil", soil, {{0.82 * r, 0.4 * z}, {0.93 * r, 0.9 * z}}, 14));
  if (m.is("bush")) {
    for (int i = 0; i < 5; ++i) {
      const double a = m.random.uniform(0.3, 0.5) * height;
      const SinCos sc = portable_sincos(2.0 * pi * i / 5.0 + m.random.uniform(0.0, 1.0));
      const Eigen::Vector3d c(0.7 * r * sc.cos, 0.7 * r * sc.sin,
                              z + 0.5 * (height - z) + m.random.uniform(-0.15, 0.15) * height);
      // Each turned its own way: like facets of like balls would be parallel.
      Part ball = cushion_part("foliage " + std::to_string(i + 1), leaf, Eigen::Vector3d::Zero(),
                               {0.8 * a, 0.8 * a, a}, 1.0, 10);
      ball.T_instance_part = pose_at(c, rotation_about(2, m.random.uniform(0.0, 3.0)) *
                                            rotation_about(0, m.random.uniform(-0.5, 0.5)));
      m.add(std::move(ball));
    }
    m.add(cylinder_part("stem", stem, {0, 0, 0.8 * z}, {0, 0, 0.6 * height}, 0.015, 6));
    return;
  }
  const bool palm = m.is("palm");
  m.add(cylinder_part("stem", stem, {0, 0, 0.8 * z},
                      {0.02, 0.01, palm ? 0.7 * height : 0.95 * height}, palm ? 0.03 : 0.012, 8));
  const int leaves = m.count("leaves", 8, 16);
  for (int i = 0; i < leaves; ++i) {
    const double share = (i + 0.5) / leaves;
    const double zi = palm ? 0.68 * height : z + share * (0.93 * height - z);
    const double length =
        palm ? 0.45 * height * m.random.uniform(0.7, 1.0) : m.random.uniform(0.16, 0.28);
    const double yaw =
        2.399963 * i + m.random.uniform(-0.2, 0.2);  // the golden angle of phyllotaxis
    const double pitch = palm ? m.random.uniform(-0.9, 0.3) : m.random.uniform(-0.6, 0.4);
    const Eigen::Matrix3d turn = rotation_about(2, yaw) * rotation_about(1, pitch);
    Part part = cushion_part("leaf " + std::to_string(i + 1), leaf, Eigen::Vector3d::Zero(),
                             {length, (palm ? 0.12 : 0.5) * length, 0.008}, 1.0, 8);
    part.T_instance_part = pose_at(
        Eigen::Vector3d(0.01, 0.005, zi) + turn * Eigen::Vector3d(0.5 * length, 0, 0), turn);
    m.add(std::move(part));
  }
}

/// Proportions by stature: Drillis and Contini, "Body segment parameters" (1966).
void make_mannequin(Maker& m) {
  const double h = m.size("height", 1.75, 0.08, 1.55, 1.95);
  const int skin = m.material({"skin", "plastic white", "plastic grey"});
  const int cloth = m.material({"fabric blue", "fabric grey", "fabric black", "fabric red"});
  const int base = m.material({"steel painted"});
  m.add(lathe_part("base", base, {{0.19, glide}, {0.19, 0.012}}, 20));
  const double foot = 0.012;
  const double hip = foot + 0.50 * h;
  const double shoulder = foot + 0.81 * h;
  for (const double s : {-1.0, 1.0}) {
    const std::string side = s < 0 ? "left " : "right ";
    const double stride = m.is("walking") ? 0.16 * s : 0.0;
    const Eigen::Vector3d hip_joint(s * 0.055 * h, 0, hip);
    const Eigen::Vector3d knee(s * 0.06 * h, -0.5 * stride - 0.01, foot + 0.275 * h);
    const Eigen::Vector3d ankle(s * 0.055 * h, stride, foot + 0.06);
    m.add(capsule_part(side + "thigh", cloth, hip_joint, knee, 0.048 * h, 0.034 * h, 10));
    m.add(capsule_part(side + "shin", cloth, knee, ankle, 0.034 * h, 0.024 * h, 10));
    m.add(cushion_part(side + "shoe", base, ankle + Eigen::Vector3d(0, -0.05, -0.025),
                       {0.09, 0.26, 0.075}, 0.6, 10));
    const Eigen::Vector3d arm(s * 0.118 * h, 0, shoulder - 0.02 * h);
    const double raise = m.is("arm raised") && s > 0 ? 1.0 : 0.0;
    const Eigen::Vector3d elbow =
        arm + Eigen::Vector3d(s * 0.03 * h, -0.10 * h * raise, -0.185 * h + 0.13 * h * raise);
    const Eigen::Vector3d hand =
        elbow + Eigen::Vector3d(0.0, -0.05 * h, (raise > 0 ? 0.16 : -0.15) * h);
    m.add(capsule_part(side + "upper arm", cloth, arm, elbow, 0.03 * h, 0.024 * h, 8));
    m.add(capsule_part(side + "forearm", skin, elbow, hand, 0.024 * h, 0.018 * h, 8));
  }
  m.add(cushion_part("pelvis", cloth, {0, 0, hip + 0.03 * h}, {0.19 * h, 0.12 * h, 0.15 * h}, 0.7,
                     12));
  m.add(cushion_part("chest", cloth, {0, 0, 0.5 * (hip + shoulder) + 0.03 * h},
                     {0.23 * h, 0.13 * h, 0.32 * h}, 0.6, 14));
  m.add(cylinder_part("neck", skin, {0, 0, shoulder - 0.02 * h}, {0, 0, foot + 0.89 * h}, 0.032 * h,
                      10));
  m.add(cushion_part("head", skin, {0, -0.01, foot + 0.93 * h}, {0.09 * h, 0.11 * h, 0.13 * h}, 0.9,
                     14));
}

void make_bottle(Maker& m) {
  const double height = m.size("height", 0.27, 0.04, 0.18, 0.34);
  const double r = m.size("radius", 0.038, 0.004, 0.03, 0.048);
  const int body = m.is("plastic") ? m.material({"plastic blue", "plastic white"})
                                   : m.material({"bottle glass"});
  if (m.is("thermos")) {
    m.add(lathe_part("body", m.material({"stainless steel"}),
                     {{r, 0.0}, {r, 0.8 * height}, {0.8 * r, 0.83 * height}, {0.8 * r, height}},
                     16));
    return;
  }
  m.add(lathe_part("body", body,
                   {{r, 0.0},
                    {r, 0.58 * height},
                    {0.36 * r, 0.78 * height},
                    {0.36 * r, 0.97 * height},
                    {0.40 * r, 0.975 * height},
                    {0.40 * r, height}},
                   14));
}

void make_cup(Maker& m) {
  const double r = m.size("radius", 0.041, 0.004, 0.033, 0.05);
  const double height = m.size("height", 0.095, 0.01, 0.07, 0.13);
  const int body = m.material({"ceramic", "plastic blue", "paper"});
  vessel(m, "body", body, m.is("paper cup") ? 0.75 * r : 0.9 * r, r, 0.0, height, 0.004, 14);
  if (m.is("mug"))
    m.box("handle", body, {r - 0.004, -0.006, 0.25 * height}, {r + 0.028, 0.006, 0.75 * height});
}

void make_bowl(Maker& m) {
  const double r = m.size("radius", 0.11, 0.025, 0.07, 0.16);
  const double h = m.is("flat") ? 0.4 * r : 0.7 * r;
  m.add(lathe_part("body", m.material({"ceramic", "beech", "stainless steel"}),
                   {{0.4 * r, 0.0},
                    {0.8 * r, 0.45 * h},
                    {r, h},
                    {r - 0.006, h},
                    {0.75 * r, 0.5 * h},
                    {0.35 * r, 0.012},
                    {0.0, 0.01}},
                   18));
}

void make_bag(Maker& m) {
  const int cloth = m.material({"leather black", "fabric blue", "fabric grey", "canvas"});
  const double width = m.size("width", 0.36, 0.04, 0.28, 0.46);
  const double depth = m.size("depth", 0.16, 0.025, 0.1, 0.24);
  const double height = m.size("height", 0.38, 0.05, 0.26, 0.5);
  m.add(cushion_part("body", cloth, {0, 0, 0.5 * height + 0.001}, {width, depth, height},
                     m.is("briefcase") ? 0.2 : 0.5, 14));
  if (m.is("backpack"))
    m.add(cushion_part("pocket", cloth, {0, -0.5 * depth, 0.3 * height},
                       {0.7 * width, 0.5 * depth, 0.45 * height}, 0.5, 12));
}

void make_book(Maker& m) {
  // Trimmed sizes from pocket book to A4.
  const double width = m.series("width", {0.115, 0.135, 0.155, 0.17, 0.21});
  const double height = m.series("height", {0.18, 0.21, 0.23, 0.24, 0.297});
  const double thick = m.size("thickness", 0.025, 0.01, 0.008, 0.06);
  const int cover = m.material({"book red", "book green", "book blue", "paper"});
  if (m.is("binder")) {
    m.box("binder", cover, {-0.14, -0.159, 0.0}, {0.14, 0.159, 0.075});
    return;
  }
  m.box("book", cover, {-0.5 * width, -0.5 * height, 0.0}, {0.5 * width, 0.5 * height, thick});
}

void make_cushion(Maker& m) {
  const double side = m.series("side", {0.4, 0.45, 0.5});
  const double thick = m.size("thickness", 0.14, 0.02, 0.1, 0.2);
  const double other = m.is("oblong") ? 0.65 * side : side;
  m.add(cushion_part("cushion",
                     m.material({"fabric red", "fabric blue", "fabric beige", "linen white"}),
                     {0, 0, 0.5 * thick}, {side, other, thick}, 0.5, 14));
}

}  // namespace

std::vector<CatalogueEntry> organic_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"waste bin", id("waste bin"), {"round", "square", "with lid"}, Place::floor, true, 60},
       make_waste_bin},
      {{"floor lamp", id("lamp"), {"shade", "uplighter"}, Place::floor, false, 100},
       make_floor_lamp},
      {{"desk lamp", id("lamp"), {"jointed", "shade"}, Place::surface, true, 300}, make_desk_lamp},
      {{"ceiling lamp", id("lamp"), {"linear", "globe", "shade"}, Place::ceiling, false, 100},
       make_ceiling_lamp},
      {{"plant", id("plant"), {"stalk", "palm", "bush"}, Place::floor, false, 100}, make_plant},
      {{"mannequin",
        id("mannequin"),
        {"standing", "walking", "arm raised"},
        Place::floor,
        false,
        200},
       make_mannequin},
      {{"bottle", id("bottle"), {"glass", "plastic", "thermos"}, Place::surface, true, 700},
       make_bottle},
      {{"cup", id("cup"), {"mug", "paper cup"}, Place::surface, true, 400}, make_cup},
      {{"bowl", id("bowl"), {"deep", "flat"}, Place::surface, true, 300}, make_bowl},
      {{"bag", id("bag"), {"backpack", "briefcase"}, Place::floor, true, 150}, make_bag},
      {{"book", id("book"), {"book", "binder"}, Place::surface, true, 700}, make_book},
      {{"cushion", id("cushion"), {"square", "oblong"}, Place::surface, true, 60}, make_cushion},
  };
}

}  // namespace scanchor
