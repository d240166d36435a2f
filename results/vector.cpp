#include "results/vector.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/file.hpp"
#include "core/markup.hpp"
#include "core/math.hpp"

namespace scanchor {
namespace {

Path rounded(double x, double y, double w, double h, double radius) {
  if (radius <= 0.0) return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
  Path path;
  const double r = std::min({radius, w / 2, h / 2});
  const Eigen::Vector2d centers[] = {
      {x + w - r, y + r}, {x + w - r, y + h - r}, {x + r, y + h - r}, {x + r, y + r}};
  for (int corner = 0; corner < 4; ++corner) {
    for (int step = 0; step <= 6; ++step) {
      const SinCos turn = portable_sincos(pi / 2 * (corner - 1 + step / 6.0));
      path.emplace_back(centers[corner] + r * Eigen::Vector2d(turn.cos, turn.sin));
    }
  }
  return path;
}

std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string paint_of(const char* property, Color color) {
  if (color.a == 0) return fmt::format(" {}=\"none\"", property);
  std::string text = fmt::format(" {}=\"{}\"", property, hex(color));
  if (color.a < 255) text += fmt::format(" {}-opacity=\"{}\"", property, number(color.a / 255.0));
  return text;
}

void write_item(std::string& out, const VectorShape& shape) {
  out += "<path d=\"";
  for (const Path& path : shape.paths) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      out += i == 0 ? "M" : "L";
      out += number(path[i].x()) + " " + number(path[i].y());
    }
    if (shape.closed) out += "Z";
  }
  out += "\"" + paint_of("fill", shape.closed ? shape.fill : Color{0, 0, 0, 0});
  if (shape.stroke.a > 0) {
    out += paint_of("stroke", shape.stroke) + " stroke-width=\"" + number(shape.width) +
           "\" stroke-linejoin=\"round\"";
    if (!shape.dash.empty()) {
      out += " stroke-dasharray=\"";
      for (std::size_t i = 0; i < shape.dash.size(); ++i) {
        out += (i == 0 ? "" : " ") + number(shape.dash[i]);
      }
      out += "\"";
    }
  }
  out += "/>\n";
}

void write_item(std::string& out, const VectorText& text) {
  static const char* const anchors[] = {"start", "middle", "end"};
  out += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"",
                     number(text.position.x()), number(text.position.y()), number(text.size),
                     anchors[int(text.anchor)]);
  if (text.weight == FontWeight::bold) out += " font-weight=\"bold\"";
  if (text.turn_deg != 0.0) {
    out += fmt::format(" transform=\"rotate({} {} {})\"", number(-text.turn_deg),
                       number(text.position.x()), number(text.position.y()));
  }
  out += paint_of("fill", text.color) + ">" + escape_markup(text.text) + "</text>\n";
}

}  // namespace

void VectorPicture::fill_rectangle(double x, double y, double w, double h, Color fill,
                                   double radius) {
  VectorShape shape;
  shape.paths = {rounded(x, y, w, h, radius)};
  shape.fill = fill;
  items.emplace_back(std::move(shape));
}

void VectorPicture::stroke_rectangle(double x, double y, double w, double h, Color stroke,
                                     double line_width, double radius) {
  VectorShape shape;
  shape.paths = {rounded(x, y, w, h, radius)};
  shape.stroke = stroke;
  shape.width = line_width;
  items.emplace_back(std::move(shape));
}

void VectorPicture::line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Color stroke,
                         double line_width, std::vector<double> dash) {
  polyline({a, b}, stroke, line_width, std::move(dash));
}

void VectorPicture::polyline(Path path, Color stroke, double line_width, std::vector<double> dash) {
  VectorShape shape;
  shape.paths.push_back(std::move(path));
  shape.closed = false;
  shape.stroke = stroke;
  shape.width = line_width;
  shape.dash = std::move(dash);
  items.emplace_back(std::move(shape));
}

void VectorPicture::disc(const Eigen::Vector2d& center, double radius, Color fill) {
  VectorShape shape;
  Path path;
  const int corners = radius < 4.0 ? 16 : 48;
  for (int i = 0; i < corners; ++i) {
    const SinCos turn = portable_sincos(2 * pi * i / corners);
    path.emplace_back(center + radius * Eigen::Vector2d(turn.cos, turn.sin));
  }
  shape.paths.push_back(std::move(path));
  shape.fill = fill;
  items.emplace_back(std::move(shape));
}

void VectorPicture::arrow(const Eigen::Vector2d& a, const Eigen::Vector2d& b, Color stroke,
                          double line_width) {
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  if (!(length > 0.0)) return;
  const Eigen::Vector2d d = along / length;
  const Eigen::Vector2d n(-d.y(), d.x());
  const double head = std::min(length, 4.0 + 3.0 * line_width);
  line(a, b - 0.8 * head * d, stroke, line_width);
  VectorShape shape;
  shape.paths = {{b, b - head * d + 0.42 * head * n, b - head * d - 0.42 * head * n}};
  shape.fill = stroke;
  items.emplace_back(std::move(shape));
}

void VectorPicture::text(double x, double y, std::string words, double size, Color color,
                         TextAnchor anchor, FontWeight weight) {
  items.emplace_back(VectorText{{x, y}, std::move(words), size, color, anchor, weight, 0.0});
}

void VectorPicture::append(const VectorPicture& other, double dx, double dy) {
  const Eigen::Vector2d shift(dx, dy);
  for (const auto& item : other.items) {
    auto moved = item;
    if (auto* shape = std::get_if<VectorShape>(&moved)) {
      for (Path& path : shape->paths) {
        for (Eigen::Vector2d& p : path) p += shift;
      }
    } else {
      std::get<VectorText>(moved).position += shift;
    }
    items.push_back(std::move(moved));
  }
}

std::string to_svg(const VectorPicture& picture, Color background) {
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\">\n",
      picture.width, picture.height);
  if (background.a > 0) {
    out += "<rect width=\"100%\" height=\"100%\"" + paint_of("fill", background) + "/>\n";
  }
  for (const auto& item : picture.items) {
    std::visit([&](const auto& value) { write_item(out, value); }, item);
  }
  return out + "</svg>\n";
}

void write_svg(const std::filesystem::path& path, const VectorPicture& picture, Color background) {
  write_file(path, to_svg(picture, background));
}

}  // namespace scanchor
