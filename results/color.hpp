#pragma once
// Colours that survive colour blindness and printing, on a light ground.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/classes.hpp"

namespace scanchor {

/// 8-bit sRGB with opacity.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Color&) const = default;
};

/// The ground of all pictures, and what stands on it.
inline constexpr Color paper_white{255, 255, 255};
inline constexpr Color ink{33, 37, 41};
inline constexpr Color faint_ink{108, 117, 125};
inline constexpr Color grid_line{222, 226, 230};

/// Okabe and Ito's eight colours ("Color Universal Design", 2008) without black and grey, then the
/// same hues lighter and darker: neighbours in the list differ in hue and lightness. Any index is
/// valid; the list repeats after 21.
Color palette(std::size_t index);
/// A colour that stays the same for the same number: neighbours in number are far apart in the
/// list; negative: grey.
Color color_of_number(std::int64_t number);
/// The class list's colour.
Color color_of_class(ClassId id);

enum class ColorMap {
  cividis,  ///< sequential; even for all kinds of colour vision (Nunez, Anderton, Renslow, PLoS ONE
            ///< 2018)
  viridis,  ///< sequential (Smith, van der Walt 2015)
  balance,  ///< diverging blue - white - vermilion, for signed errors
};
/// Colour of t in [0, 1] (clamped; NaN gives grey).
Color color_map(ColorMap map, double t);

/// (1 - share) * a + share * b, opacity of a.
Color mix(Color a, Color b, double share);
Color with_alpha(Color color, std::uint8_t alpha);
/// Ink or white, whichever reads better on the colour (WCAG 2.1 relative luminance).
Color readable_on(Color ground);
/// "#rrggbb".
std::string hex(Color color);

}  // namespace scanchor
