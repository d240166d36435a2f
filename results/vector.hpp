#pragma once
// A flat picture of paths and text, written once and put out twice: as SVG (to_svg) and painted
// over pixels (paint.hpp). Coordinates are pixels, x to the right, y down, (0, 0) the upper left
// corner of the upper left pixel.

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "results/color.hpp"
#include "results/font.hpp"

namespace scanchor {

using Path = std::vector<Eigen::Vector2d>;

/// Rings or open lines with a filling and a stroke; an opacity of 0 leaves either out. Filled by
/// the non-zero winding rule.
struct VectorShape {
  std::vector<Path> paths;
  bool closed = true;
  Color fill{0, 0, 0, 0};
  Color stroke{0, 0, 0, 0};
  double width = 1.0;        ///< [px] of the stroke
  std::vector<double> dash;  ///< [px] on, off, ...; empty: solid
};

enum class TextAnchor { start, middle, end };

struct VectorText {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< of the baseline at the anchor
  std::string text;                                    ///< UTF-8, one line
  double size = 14.0;                                  ///< [px] an em
  Color color = ink;
  TextAnchor anchor = TextAnchor::start;
  FontWeight weight = FontWeight::regular;
  double turn_deg = 0.0;  ///< counter-clockwise about `position`
};

struct VectorPicture {
  int width = 0;
  int height = 0;
  std::vector<std::variant<VectorShape, VectorText>> items;  ///< painted in this order

  void fill_rectangle(double x, double y, double w, double h, Color fill, double radius = 0.0);
  void stroke_rectangle(double x, double y, double w, double h, Color stroke, double width = 1.0,
                        double radius = 0.0);
  void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Color stroke, double width = 1.0,
            std::vector<double> dash = {});
  void polyline(Path path, Color stroke, double width = 1.0, std::vector<double> dash = {});
  void disc(const Eigen::Vector2d& center, double radius, Color fill);
  /// A line with a filled head at b.
  void arrow(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Color stroke, double width = 1.0);
  void text(double x, double y, std::string words, double size, Color color = ink,
            TextAnchor anchor = TextAnchor::start, FontWeight weight = FontWeight::regular);
  void append(const VectorPicture& other, double dx, double dy);
};

/// A standalone SVG 1.1 document with the same look as painting. Same bytes for the same picture.
std::string to_svg(const VectorPicture& picture, Color background = paper_white);
/// Whole or not at all. Throws Error(bad_data).
void write_svg(const std::filesystem::path& path, const VectorPicture& picture,
               Color background = paper_white);

}  // namespace scanchor
