// Shelves, cabinets, drawers. Sizes are the series that makers sell; see
// docs/reference/furniture.md.

#include <algorithm>

#include "scenes/catalogue/maker.hpp"

namespace scanchor {
namespace {

/// Doors in front of a carcass: `columns` x 1 leaves with seams of 3 mm, and a bar handle each.
void doors(Maker& m, int front, int metal, double width, double y, double z0, double z1,
           int columns) {
  const double seam = 0.003;
  const double leaf = width / columns;
  for (int i = 0; i < columns; ++i) {
    const std::string number = std::to_string(i + 1);
    const double x0 = -0.5 * width + leaf * i + seam;
    const double x1 = x0 + leaf - 2 * seam;
    m.box("door " + number, front, {x0, y - 0.018, z0}, {x1, y + joint, z1});
    const bool hinge_left = i % 2 == 0;
    const double hx = hinge_left ? x1 - 0.05 : x0 + 0.05;
    const double hz = 0.5 * (z0 + z1);
    m.box("handle " + number, metal, {hx - 0.006, y - 0.045, hz - 0.064},
          {hx + 0.006, y - 0.018 + joint, hz + 0.064});
  }
}

/// Drawer fronts one above the other.
void drawers(Maker& m, int front, int metal, double width, double y, double z0, double z1,
             int rows) {
  const double seam = 0.003;
  const double row = (z1 - z0) / rows;
  for (int i = 0; i < rows; ++i) {
    const std::string number = std::to_string(i + 1);
    const double a = z0 + row * i + seam;
    const double b = a + row - 2 * seam;
    m.box("drawer " + number, front, {-0.5 * width + seam, y - 0.018, a},
          {0.5 * width - seam, y + joint, b});
    m.box("handle " + number, metal, {-0.064, y - 0.04, b - 0.04},
          {0.064, y - 0.018 + joint, b - 0.028});
  }
}

/// Sides, boards and perhaps a back. Boards are let into the sides and stand back from their front
/// edges. Returns the tops of the boards, from below.
std::vector<double> rack(Maker& m, int wood, double width, double depth, double height, int boards,
                         double t, bool with_back) {
  for (const double s : {-1.0, 1.0}) {
    const double x = s * 0.5 * (width - t);
    m.box(s < 0 ? "left side" : "right side", wood, {x - 0.5 * t, -0.5 * depth, glide},
          {x + 0.5 * t, 0.5 * depth, height});
  }
  const double reach = 0.5 * width - t + joint;
  const double back = 0.5 * depth - 0.012;
  if (with_back) {
    m.box("back", wood, {-reach - joint, back, 0.05},
          {reach + joint, back + 0.006, height - 0.012});
  }
  std::vector<double> tops;
  const double lowest = 0.07 + t;
  const double highest = height - 0.006;
  for (int i = 0; i < boards; ++i) {
    const double z = boards == 1 ? lowest : lowest + (highest - lowest) * i / (boards - 1);
    m.box("board " + std::to_string(i + 1), wood, {-reach, -0.5 * depth + 0.004, z - t},
          {reach, with_back ? back + joint : 0.5 * depth - 0.004, z});
    tops.push_back(z);
  }
  return tops;
}

void make_shelf(Maker& m) {
  const int boards = m.count("boards", 2, 8);
  const double width = m.series("width", {0.6, 0.8, 0.8, 0.9, 1.0, 1.0, 1.2});
  const double depth = m.series("depth", {0.3, 0.35, 0.4, 0.4, 0.5, 0.6});
  const double spacing = m.size("spacing", 0.36, 0.05, 0.26, 0.5);
  const double t = m.is("open") ? 0.03 : m.series("thickness", {0.016, 0.019, 0.022, 0.025});
  double height = 0.07 + t + spacing * (boards - 1) + 0.006;
  height = std::min(height, 2.4);
  if (m.is("open")) {
    // Steel boards bolted between four angle posts, as in stores and laboratories.
    const int post = m.material({"steel painted", "paint grey", "aluminium"});
    const int board = m.material({"paint grey", "steel painted", "raw wood"});
    const double s = 0.035;
    int number = 0;
    for (const double sy : {-1.0, 1.0}) {
      for (const double sx : {-1.0, 1.0}) {
        const double x = sx * 0.5 * (width - s);
        const double y = sy * 0.5 * (depth - s);
        m.box("post " + std::to_string(++number), post, {x - 0.5 * s, y - 0.5 * s, glide},
              {x + 0.5 * s, y + 0.5 * s, height + 0.03});
      }
    }
    for (int i = 0; i < boards; ++i) {
      const double z = 0.07 + t + (height - 0.076 - t) * i / std::max(1, boards - 1);
      m.box("board " + std::to_string(i + 1), board,
            {-0.5 * width + 0.006, -0.5 * depth + 0.006, z - t},
            {0.5 * width - 0.006, 0.5 * depth - 0.006, z});
    }
    return;
  }
  const int wood = m.material({"beech", "oak", "melamine white", "melamine grey", "walnut"});
  rack(m, wood, width, depth, height, boards, t, m.is("with back"));
}

void make_bookcase(Maker& m) {
  const int boards = m.count("boards", 3, 7);
  const double width = m.series("width", {0.4, 0.6, 0.8, 0.8, 1.0});
  const double depth = m.series("depth", {0.28, 0.3, 0.35});
  const double height = std::min(2.3, 0.11 + 0.35 * (boards - 1));
  const int wood = m.material({"beech", "oak", "melamine white", "walnut"});
  const double t = 0.02;
  const auto tops = rack(m, wood, width, depth, height, boards, t, true);
  const int covers[] = {m.material({"book red"}), m.material({"book green"}),
                        m.material({"book blue"}), m.material({"paper"})};
  const double inner = 0.5 * width - t - 0.003;
  int books = 0;
  for (std::size_t i = 0; i + 1 < tops.size(); ++i) {
    const double room = tops[i + 1] - t - tops[i] - 0.02;
    const double end = -inner + 2 * inner * m.random.uniform(0.3, 1.0);
    double x = -inner;
    // A pack of like volumes stands as one block: 0.1 to 0.3 m of spines, each pack of another
    // height and depth.
    while (books < 40) {
      const double thick =
          m.is("binders") ? m.random.uniform(0.16, 0.32) : m.random.uniform(0.05, 0.2);
      if (x + thick > end) break;
      const double tall =
          m.is("binders") ? std::min(room, 0.318) : std::min(room, m.random.uniform(0.18, 0.30));
      const double deep = m.is("binders") ? 0.285 : m.random.uniform(0.13, 0.24);
      const double y1 = 0.5 * depth - 0.012 - 0.004;
      m.box("books " + std::to_string(++books), covers[m.random.below(4)],
            {x, std::max(-0.5 * depth + 0.01, y1 - deep), tops[i] + glide},
            {x + thick, y1, tops[i] + glide + tall});
      x += thick + 0.003;
    }
  }
  m.instance.parameters["books"] = books;
}

void make_cabinet(Maker& m) {
  const bool tall = m.is("tall");
  const double width = m.series("width", {0.8, 0.8, 1.0, 1.2});
  const double depth = m.series("depth", {0.4, 0.42, 0.45});
  // Ordner heights: 2, 3, 5 or 6 rows of A4 binders.
  const double height =
      tall ? m.series("height", {1.85, 1.95, 2.1}) : m.series("height", {0.75, 0.82, 1.1, 1.15});
  const int body = m.material({"melamine white", "melamine grey", "beech", "oak"});
  const int front = m.material({"melamine white", "melamine grey", "beech", "oak", "paint blue"});
  const int metal = m.material({"aluminium", "plastic black"});
  const double y = -0.5 * depth + 0.018;
  m.box("plinth", body, {-0.5 * width + 0.01, y + 0.02, glide},
        {0.5 * width - 0.01, 0.5 * depth - 0.01, 0.06 + joint});
  m.box("body", body, {-0.5 * width, y, 0.06}, {0.5 * width, 0.5 * depth, height});
  if (m.is("sliding doors")) {
    const double half = 0.5 * width;
    m.box("door 1", front, {-half + 0.004, y - 0.018, 0.066}, {0.04, y + joint, height - 0.006});
    m.box("door 2", front, {0.0 - 0.02, y - 0.033, 0.07},
          {half - 0.004, y - 0.015 - 0.001, height - 0.01});
    return;
  }
  doors(m, front, metal, width, y, 0.064, height - 0.004, 2);
}

void make_drawer_unit(Maker& m) {
  const double width = m.series("width", {0.42, 0.43});
  const double depth = m.is("tall") ? 0.8 : m.series("depth", {0.56, 0.6, 0.8});
  const double height = m.is("tall") ? 0.74 : m.size("height", 0.58, 0.015, 0.53, 0.62);
  const int body = m.material({"melamine white", "melamine grey", "beech", "steel painted"});
  const int metal = m.material({"aluminium", "plastic black"});
  const double y = -0.5 * depth + 0.018;
  const bool rolls = m.is("on castors");
  const double bottom = rolls ? 0.055 : 0.012;
  m.box("body", body, {-0.5 * width, y, bottom}, {0.5 * width, 0.5 * depth, height});
  int number = 0;
  for (const double sy : {-1.0, 1.0}) {
    for (const double sx : {-1.0, 1.0}) {
      const double x = sx * (0.5 * width - 0.05);
      const double z = bottom + joint;
      const double cy = sy * (0.5 * depth - 0.07);
      const std::string name = (rolls ? "castor " : "glide ") + std::to_string(++number);
      if (rolls) {
        m.add(cylinder_part(name, metal, {x - 0.012, cy, 0.026 + glide},
                            {x + 0.012, cy, 0.026 + glide}, 0.026, 12));
        m.box("fork " + std::to_string(number), metal, {x - 0.016, cy - 0.01, 0.03},
              {x + 0.016, cy + 0.01, z});
      } else {
        m.box(name, metal, {x - 0.015, cy - 0.015, glide}, {x + 0.015, cy + 0.015, z});
      }
    }
  }
  drawers(m, body, metal, width, y, bottom + 0.004, height - 0.004, m.count("drawers", 3, 4));
}

void make_wardrobe(Maker& m) {
  const int leaves = m.is("sliding doors") ? 2 : m.count("leaves", 2, 4);
  const double width = m.is("sliding doors") ? m.series("width", {1.5, 1.8, 2.0}) : 0.5 * leaves;
  const double depth = m.series("depth", {0.58, 0.6, 0.65});
  const double height = m.size("height", 2.0, 0.08, 1.8, 2.3);
  const int body = m.material({"melamine white", "beech", "oak", "walnut"});
  const int front =
      m.is("mirror door") ? m.material({"mirror"}) : m.material({"melamine white", "beech", "oak"});
  const int metal = m.material({"aluminium", "steel painted"});
  const double y = -0.5 * depth + 0.02;
  m.box("plinth", body, {-0.5 * width + 0.01, y + 0.02, glide},
        {0.5 * width - 0.01, 0.5 * depth - 0.01, 0.06 + joint});
  m.box("body", body, {-0.5 * width, y, 0.06}, {0.5 * width, 0.5 * depth, height});
  if (m.is("sliding doors")) {
    m.box("door 1", front, {-0.5 * width + 0.004, y - 0.018, 0.066},
          {0.05, y + joint, height - 0.006});
    m.box("door 2", front, {-0.03, y - 0.038, 0.07},
          {0.5 * width - 0.004, y - 0.02, height - 0.01});
    m.box("rail", metal, {-0.5 * width + 0.01, y - 0.03, height - 0.05},
          {0.5 * width - 0.01, y - 0.008, height - 0.0085});
    return;
  }
  doors(m, front, metal, width, y, 0.064, height - 0.004, leaves);
}

}  // namespace

std::vector<CatalogueEntry> storage_entries() {
  const auto id = [](const char* name) { return *find_class(name); };
  return {
      {{"shelf", id("shelf"), {"open", "with sides", "with back"}, Place::floor, false, 300},
       make_shelf},
      {{"bookcase", id("bookcase"), {"books", "binders"}, Place::floor, false, 400}, make_bookcase},
      {{"cabinet", id("cabinet"), {"low", "tall", "sliding doors"}, Place::floor, false, 200},
       make_cabinet},
      {{"drawer unit",
        id("drawer unit"),
        {"on castors", "on glides", "tall"},
        Place::floor,
        false,
        250},
       make_drawer_unit},
      {{"wardrobe",
        id("wardrobe"),
        {"doors", "sliding doors", "mirror door"},
        Place::floor,
        false,
        150},
       make_wardrobe},
  };
}

}  // namespace scanchor
