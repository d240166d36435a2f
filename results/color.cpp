#include "results/color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace scanchor {
namespace {

constexpr std::array<Color, 7> okabe_ito = {{{0, 114, 178},
                                             {230, 159, 0},
                                             {0, 158, 115},
                                             {204, 121, 167},
                                             {86, 180, 233},
                                             {213, 94, 0},
                                             {240, 228, 66}}};

// Nine equidistant samples of the published maps; linear between them is within 3/255 of the
// originals.
constexpr std::array<Color, 9> cividis_map = {{{0, 34, 78},
                                               {26, 56, 111},
                                               {67, 78, 108},
                                               {97, 100, 112},
                                               {125, 124, 120},
                                               {156, 149, 117},
                                               {190, 175, 106},
                                               {225, 204, 85},
                                               {254, 232, 56}}};
constexpr std::array<Color, 9> viridis_map = {{{68, 1, 84},
                                               {71, 45, 123},
                                               {59, 82, 139},
                                               {44, 114, 142},
                                               {33, 145, 140},
                                               {40, 174, 128},
                                               {94, 201, 98},
                                               {173, 220, 48},
                                               {253, 231, 37}}};
constexpr std::array<Color, 5> balance_map = {
    {{0, 63, 115}, {86, 160, 211}, {242, 242, 240}, {235, 143, 84}, {150, 52, 0}}};

template <std::size_t N>
Color along(const std::array<Color, N>& map, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * double(N - 1);
  const std::size_t i = std::min(N - 2, std::size_t(place));
  return mix(map[i], map[i + 1], place - double(i));
}

std::uint8_t blend(std::uint8_t a, std::uint8_t b, double share) {
  return std::uint8_t(std::lround(double(a) + (double(b) - double(a)) * share));
}

double linear(std::uint8_t channel) {
  const double c = double(channel) / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

}  // namespace

Color mix(Color a, Color b, double share) {
  return {blend(a.r, b.r, share), blend(a.g, b.g, share), blend(a.b, b.b, share), a.a};
}

Color with_alpha(Color color, std::uint8_t alpha) {
  color.a = alpha;
  return color;
}

Color palette(std::size_t index) {
  const Color base = okabe_ito[index % okabe_ito.size()];
  switch (index / okabe_ito.size() % 3) {
    case 1:
      return mix(base, ink, 0.4);
    case 2:
      return mix(base, paper_white, 0.45);
    default:
      return base;
  }
}

Color color_of_number(std::int64_t number) {
  if (number < 0) return {173, 181, 189};
  // 8 has no divisor in common with the list's 21, so 21 numbers in a row have 21 colours.
  return palette(std::size_t(number) * 8 % 21);
}

Color color_of_class(ClassId id) {
  const auto& rgb = class_info(id).color;
  return {rgb[0], rgb[1], rgb[2]};
}

Color color_map(ColorMap map, double t) {
  if (std::isnan(t)) return {173, 181, 189};
  switch (map) {
    case ColorMap::viridis:
      return along(viridis_map, t);
    case ColorMap::balance:
      return along(balance_map, t);
    case ColorMap::cividis:
      break;
  }
  return along(cividis_map, t);
}

Color readable_on(Color ground) {
  const double luminance =
      0.2126 * linear(ground.r) + 0.7152 * linear(ground.g) + 0.0722 * linear(ground.b);
  return luminance > 0.22 ? ink : paper_white;
}

std::string hex(Color color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
  return text;
}

}  // namespace scanchor
