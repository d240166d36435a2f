#pragma once
// Text as outlines: a font that is part of the program, so that a picture never depends on what a
// machine has installed.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace scanchor {

enum class FontWeight { regular, bold };

/// Width in pixels of a line of UTF-8 text. A character that the font does not have counts (and is
/// drawn) as an empty box.
double text_width(std::string_view text, double size, FontWeight weight = FontWeight::regular);

/// Closed rings of the text's outlines in picture coordinates (y down), the baseline starting at
/// the origin. `size`: pixels an em; capitals are 0.73 of it high. To be filled where the winding
/// number is not zero.
std::vector<std::vector<Eigen::Vector2d>> text_rings(std::string_view text, double size,
                                                     FontWeight weight = FontWeight::regular);

/// The text cut to a width with an ellipsis at its end.
std::string fit_text(std::string_view text, double width, double size,
                     FontWeight weight = FontWeight::regular);

}  // namespace scanchor
