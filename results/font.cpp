#include "results/font.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>

namespace scanchor {
namespace {

#include "results/font/outlines.inc"

constexpr double em = 2048.0;

struct OutlinePoint {
  double x, y;
  bool on;
};

struct Glyph {
  double advance = 0.0;
  std::vector<std::vector<OutlinePoint>> contours;
};

using Face = std::map<char32_t, Glyph>;

Face decode(std::span<const std::int16_t> numbers, int glyphs) {
  Face face;
  std::size_t at = 0;
  for (int g = 0; g < glyphs; ++g) {
    Glyph& glyph = face[char32_t(numbers[at])];
    glyph.advance = numbers[at + 1];
    glyph.contours.resize(std::size_t(numbers[at + 2]));
    at += 3;
    for (auto& contour : glyph.contours) {
      const int count = numbers[at++];
      int x = 0;
      int y = 0;
      for (int i = 0; i < count; ++i, at += 2) {
        x += numbers[at] >> 1;
        y += numbers[at + 1];
        contour.push_back({double(x), double(y), (numbers[at] & 1) != 0});
      }
    }
  }
  return face;
}

const Glyph& glyph_of(char32_t character, FontWeight weight) {
  static const std::array<Face, 2> faces = {decode(regular_outlines, regular_glyphs),
                                            decode(bold_outlines, bold_glyphs)};
  static const Glyph box = {
      1229.0,
      {{{150, 0, true}, {150, 1400, true}, {1079, 1400, true}, {1079, 0, true}},
       {{250, 100, true}, {979, 100, true}, {979, 1300, true}, {250, 1300, true}}}};
  for (const FontWeight w : {weight, FontWeight::regular}) {
    const Face& face = faces[w == FontWeight::bold ? 1 : 0];
    if (const auto found = face.find(character); found != face.end()) return found->second;
  }
  return box;
}

/// Next code point of UTF-8 text; a malformed byte gives U+FFFD and moves one byte on.
char32_t next_character(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  const int extra = first < 0x80       ? 0
                    : first >> 5 == 6  ? 1
                    : first >> 4 == 14 ? 2
                    : first >> 3 == 30 ? 3
                                       : -1;
  if (extra < 0 || at + std::size_t(extra) >= text.size()) {
    ++at;
    return 0xFFFD;
  }
  char32_t result = extra == 0 ? first : first & (0x3FU >> extra);
  for (int i = 1; i <= extra; ++i) {
    const unsigned next = byte(at + std::size_t(i));
    if (next >> 6 != 2) {
      ++at;
      return 0xFFFD;
    }
    result = result << 6 | (next & 0x3FU);
  }
  at += std::size_t(extra) + 1;
  return result;
}

/// A quadratic TrueType contour as a polyline; two off-curve points in a row have an on-curve point
/// in their middle.
std::vector<Eigen::Vector2d> flatten(const std::vector<OutlinePoint>& contour, double shift,
                                     double scale) {
  const auto place = [&](double x, double y) {
    return Eigen::Vector2d((x + shift) * scale, -y * scale);
  };
  const std::size_t n = contour.size();
  const auto on_point = [&](std::size_t i) {
    const OutlinePoint& p = contour[i % n];
    const OutlinePoint& q = contour[(i + n - 1) % n];
    return p.on ? Eigen::Vector2d(p.x, p.y) : Eigen::Vector2d((p.x + q.x) / 2, (p.y + q.y) / 2);
  };
  std::vector<Eigen::Vector2d> ring;
  const int steps = scale * em > 40.0 ? 8 : 4;
  for (std::size_t i = 0; i < n; ++i) {
    const OutlinePoint& p = contour[i];
    if (p.on) {
      ring.push_back(place(p.x, p.y));
      continue;
    }
    const Eigen::Vector2d a = on_point(i);
    const OutlinePoint& after = contour[(i + 1) % n];
    const Eigen::Vector2d b = after.on ? Eigen::Vector2d(after.x, after.y)
                                       : Eigen::Vector2d((p.x + after.x) / 2, (p.y + after.y) / 2);
    const Eigen::Vector2d from =
        contour[(i + n - 1) % n].on
            ? Eigen::Vector2d(contour[(i + n - 1) % n].x, contour[(i + n - 1) % n].y)
            : a;
    for (int s = 0; s < steps; ++s) {
      const double t = double(s) / double(steps);
      const Eigen::Vector2d q =
          (1 - t) * (1 - t) * from + 2 * t * (1 - t) * Eigen::Vector2d(p.x, p.y) + t * t * b;
      if (s > 0 || !contour[(i + n - 1) % n].on) ring.push_back(place(q.x(), q.y()));
    }
  }
  return ring;
}

}  // namespace

double text_width(std::string_view text, double size, FontWeight weight) {
  double advance = 0.0;
  for (std::size_t at = 0; at < text.size();) {
    advance += glyph_of(next_character(text, at), weight).advance;
  }
  return advance * size / em;
}

std::vector<std::vector<Eigen::Vector2d>> text_rings(std::string_view text, double size,
                                                     FontWeight weight) {
  std::vector<std::vector<Eigen::Vector2d>> rings;
  double pen = 0.0;
  for (std::size_t at = 0; at < text.size();) {
    const Glyph& glyph = glyph_of(next_character(text, at), weight);
    for (const auto& contour : glyph.contours) rings.push_back(flatten(contour, pen, size / em));
    pen += glyph.advance;
  }
  return rings;
}

std::string fit_text(std::string_view text, double width, double size, FontWeight weight) {
  if (text_width(text, size, weight) <= width) return std::string(text);
  std::size_t end = 0;
  double advance = glyph_of(U'…', weight).advance;
  for (std::size_t at = 0; at < text.size(); end = at) {
    std::size_t next = at;
    advance += glyph_of(next_character(text, next), weight).advance;
    if (advance * size / em > width) break;
    at = next;
  }
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace scanchor
