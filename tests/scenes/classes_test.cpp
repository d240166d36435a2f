#include "scenes/classes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace scanchor {
namespace {

TEST(Classes, IdsAreTheirPlacesAndNamesAreUnique) {
  std::set<std::string_view> names;
  const auto& list = class_list();
  ASSERT_GE(list.size(), 41U);
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i].id, static_cast<ClassId>(i));
    EXPECT_TRUE(names.insert(list[i].name).second) << list[i].name;
    EXPECT_EQ(find_class(list[i].name), list[i].id);
    for (const char c : list[i].name)
      EXPECT_TRUE(c == ' ' || (c >= 'a' && c <= 'z')) << list[i].name;
  }
}

// The numbers are a file format: this table is not to be edited when classes are added.
TEST(Classes, NumbersNeverChangeTheirMeaning) {
  const std::pair<ClassId, const char*> fixed[] = {
      {0, "unlabelled"}, {1, "floor"},       {2, "wall"},   {3, "ceiling"},    {6, "door"},
      {8, "desk"},       {9, "table"},       {12, "chair"}, {16, "shelf"},     {18, "cabinet"},
      {21, "monitor"},   {25, "whiteboard"}, {35, "box"},   {39, "mannequin"}, {55, "clutter"}};
  for (const auto& [id, name] : fixed) EXPECT_EQ(class_info(id).name, name);
}

TEST(Classes, UnknownIdsAreUnlabelled) {
  EXPECT_EQ(class_info(-1).id, unlabelled);
  EXPECT_EQ(class_info(100000).id, unlabelled);
  EXPECT_FALSE(find_class("dekc").has_value());
}

TEST(Classes, MapOntoThirteenS3disClasses) {
  EXPECT_EQ(s3dis_classes().size(), 13U);
  std::set<std::int32_t> used;
  for (const auto& info : class_list()) {
    EXPECT_EQ(s3dis_classes()[static_cast<std::size_t>(s3dis_index(info.id))], info.s3dis);
    used.insert(s3dis_index(info.id));
  }
  EXPECT_EQ(used.size(), 13U) << "every S3DIS class has one of ours";
}

TEST(Classes, KittiYamlHasEachClassOnce) {
  const std::string yaml = semantic_kitti_yaml();
  EXPECT_NE(yaml.find("  21: \"monitor\"\n"), std::string::npos);
  EXPECT_NE(yaml.find("  6: [0, 94, 213]\n"), std::string::npos) << "colours run blue, green, red";
  for (const char* key :
       {"labels:", "color_map:", "learning_map:", "learning_map_inv:", "learning_ignore:"}) {
    EXPECT_NE(yaml.find(key), std::string::npos);
  }
}

struct Lab {
  double l, a, b;
};

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

/// CIELAB of linear RGB, D65.
Lab lab(double r, double g, double b) {
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
  const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Machado, Oliveira, Fernandes, "A physiologically-based model for simulation of color vision
// deficiency" (2009), severity 1.
constexpr double protanopia[9] = {0.152286, 1.052583,  -0.204868, 0.114503, 0.786281,
                                  0.099216, -0.003882, -0.048116, 1.051998};
constexpr double deuteranopia[9] = {0.367322, 0.860646,  -0.227968, 0.280085, 0.672501,
                                    0.047413, -0.011820, 0.042940,  0.968881};
constexpr double normal_sight[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

TEST(Classes, CommonColoursStayApartForTheColourBlind) {
  const char* common[] = {"floor", "wall",  "ceiling", "door",    "window",  "desk",
                          "table", "chair", "shelf",   "cabinet", "monitor", "box"};
  for (const auto* sight : {normal_sight, protanopia, deuteranopia}) {
    std::vector<Lab> seen;
    for (const char* name : common) {
      const auto& c = class_info(*find_class(name)).color;
      const double rgb[3] = {linear(c[0] / 255.0), linear(c[1] / 255.0), linear(c[2] / 255.0)};
      double out[3];
      for (int i = 0; i < 3; ++i) {
        out[i] = sight[3 * i] * rgb[0] + sight[3 * i + 1] * rgb[1] + sight[3 * i + 2] * rgb[2];
        out[i] = std::min(1.0, std::max(0.0, out[i]));
      }
      seen.push_back(lab(out[0], out[1], out[2]));
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (std::size_t j = i + 1; j < seen.size(); ++j) {
        const double d =
            std::hypot(seen[i].l - seen[j].l, seen[i].a - seen[j].a, seen[i].b - seen[j].b);
        EXPECT_GT(d, 10.0) << common[i] << " and " << common[j];
      }
    }
  }
}

TEST(Classes, NoTwoShareAColour) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (const auto& info : class_list()) EXPECT_TRUE(colors.insert(info.color).second) << info.name;
}

}  // namespace
}  // namespace scanchor
