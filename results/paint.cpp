#include "results/paint.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

/// Signed area accumulation: each edge adds what it covers to the right of itself, a running sum
/// along the row gives the coverage (the method of R. Levien's font-rs, 2016).
class Accumulator {
 public:
  Accumulator(int w, int h)
      : width_(w), height_(h), cells_(std::size_t(w + 2) * std::size_t(h), 0.0F) {}

  void edge(Eigen::Vector2d p, Eigen::Vector2d q) {
    if (p.y() == q.y()) return;
    const double sign = p.y() < q.y() ? 1.0 : -1.0;
    if (sign < 0.0) std::swap(p, q);
    const double slope = (q.x() - p.x()) / (q.y() - p.y());
    const int first = std::max(0, int(std::floor(std::max(p.y(), 0.0))));
    const int last = int(std::min(double(height_), std::ceil(q.y())));
    for (int row = first; row < last; ++row) {
      const double top = std::max(double(row), p.y());
      const double bottom = std::min(double(row + 1), q.y());
      if (bottom <= top) continue;
      span(row, p.x() + (top - p.y()) * slope, p.x() + (bottom - p.y()) * slope,
           sign * (bottom - top));
    }
  }

  [[nodiscard]] std::vector<float> finish() const {
    std::vector<float> result(std::size_t(width_) * std::size_t(height_));
    for (int row = 0; row < height_; ++row) {
      float sum = 0.0F;
      for (int x = 0; x < width_; ++x) {
        sum += cells_[std::size_t(row) * std::size_t(width_ + 2) + std::size_t(x)];
        result[std::size_t(row) * std::size_t(width_) + std::size_t(x)] =
            std::min(1.0F, std::abs(sum));
      }
    }
    return result;
  }

 private:
  /// An edge piece inside one row from x0 to x1 that covers `area` of the row's height.
  void span(int row, double xa, double xb, double area) {
    const double x0 = std::clamp(std::min(xa, xb), 0.0, double(width_));
    const double x1 = std::clamp(std::max(xa, xb), 0.0, double(width_));
    float* cell = &cells_[std::size_t(row) * std::size_t(width_ + 2)];
    const int i0 = int(x0);
    const int i1 = std::max(int(std::ceil(x1)), i0 + 1);
    if (i1 == i0 + 1) {
      const double right = 0.5 * (x0 + x1) - i0;
      cell[i0] += float(area * (1.0 - right));
      cell[i0 + 1] += float(area * right);
      return;
    }
    // The integral of the covered share up to column i, differenced from column to column.
    const double per_x = 1.0 / (x1 - x0);
    double before = 0.0;
    for (int i = i0; i < i1; ++i) {
      const double from = std::max(double(i), x0);
      const double to = std::min(double(i + 1), x1);
      const double covered = 0.5 * ((from - x0) + (to - x0)) * per_x * (to - from) + (i + 1 - to);
      cell[i] += float(area * (covered - before));
      before = covered;
    }
    cell[i1] += float(area * (1.0 - before));
  }

  int width_, height_;
  std::vector<float> cells_;
};

void blend_pixel(std::uint8_t* pixel, Color color, float share) {
  const float a = share * float(color.a) / 255.0F;
  const std::uint8_t channels[] = {color.r, color.g, color.b};
  for (int c = 0; c < 3; ++c) {
    pixel[c] = std::uint8_t(float(pixel[c]) + (float(channels[c]) - float(pixel[c])) * a + 0.5F);
  }
}

void fill(Image& image, std::vector<Path> rings, Color color) {
  double x0 = image.width, y0 = image.height, x1 = 0, y1 = 0;
  for (const Path& ring : rings) {
    for (const Eigen::Vector2d& p : ring) {
      if (!p.allFinite()) return;
      x0 = std::min(x0, p.x());
      x1 = std::max(x1, p.x());
      y0 = std::min(y0, p.y());
      y1 = std::max(y1, p.y());
    }
  }
  const int left = int(std::floor(std::max(x0, 0.0)));
  const int top = int(std::floor(std::max(y0, 0.0)));
  const int w = int(std::ceil(std::min(x1, double(image.width)))) - left;
  const int h = int(std::ceil(std::min(y1, double(image.height)))) - top;
  if (w <= 0 || h <= 0) return;
  for (Path& ring : rings) {
    for (Eigen::Vector2d& p : ring) p -= Eigen::Vector2d(left, top);
  }
  const std::vector<float> share = coverage(rings, w, h);
  for (int y = 0; y < h; ++y) {
    std::uint8_t* row =
        &image.rgb[3 * (std::size_t(top + y) * std::size_t(image.width) + std::size_t(left))];
    for (int x = 0; x < w; ++x) {
      const float s = share[std::size_t(y) * std::size_t(w) + std::size_t(x)];
      if (s > 0.002F) blend_pixel(row + 3 * x, color, s);
    }
  }
}

/// One piece of a stroke; all pieces turn the same way, so that they unite.
void add_segment(std::vector<Path>& pieces, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                 double width) {
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  if (!(length > 1e-9)) return;
  const Eigen::Vector2d n = Eigen::Vector2d(-along.y(), along.x()) * (0.5 * width / length);
  pieces.push_back({a + n, a - n, b - n, b + n});
}

void add_joint(std::vector<Path>& pieces, const Eigen::Vector2d& center, double width) {
  Path disc;
  for (int i = 0; i < 12; ++i) {
    const SinCos turn = portable_sincos(2 * pi * i / 12);
    disc.emplace_back(center + 0.5 * width * Eigen::Vector2d(turn.cos, turn.sin));
  }
  pieces.push_back(std::move(disc));
}

void add_dashed(std::vector<Path>& pieces, const Path& path, const std::vector<double>& dash,
                double width) {
  std::size_t phase = 0;
  double left = dash[0];
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    Eigen::Vector2d from = path[i];
    double rest = (path[i + 1] - from).norm();
    while (rest > 1e-9) {
      const double step = std::min(rest, std::max(left, 0.1));
      const Eigen::Vector2d to = from + (path[i + 1] - from) * (step / rest);
      if (phase % 2 == 0) add_segment(pieces, from, to, width);
      from = to;
      rest -= step;
      left -= step;
      if (left <= 1e-9) left = dash[++phase % dash.size()];
    }
  }
}

void paint_item(const VectorShape& shape, Image& image, double scale) {
  std::vector<Path> paths = shape.paths;
  for (Path& path : paths) {
    for (Eigen::Vector2d& p : path) p *= scale;
  }
  if (shape.closed && shape.fill.a > 0) fill(image, paths, shape.fill);
  if (shape.stroke.a == 0) return;
  const double width = shape.width * scale;
  std::vector<double> dash = shape.dash;
  for (double& d : dash) d *= scale;
  for (Path& path : paths) {
    if (path.empty()) continue;
    std::vector<Path> pieces;
    if (shape.closed) path.push_back(path.front());
    if (!dash.empty()) {
      add_dashed(pieces, path, dash, width);
    } else {
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        add_segment(pieces, path[i], path[i + 1], width);
        if (width > 1.2 && (i > 0 || shape.closed)) add_joint(pieces, path[i], width);
      }
    }
    fill(image, std::move(pieces), shape.stroke);
  }
}

void paint_item(const VectorText& text, Image& image, double scale) {
  const double size = text.size * scale;
  const double width = text_width(text.text, size, text.weight);
  const double shift = text.anchor == TextAnchor::start    ? 0.0
                       : text.anchor == TextAnchor::middle ? -width / 2
                                                           : -width;
  std::vector<Path> rings = text_rings(text.text, size, text.weight);
  const SinCos turn = portable_sincos(radians(-text.turn_deg));
  for (Path& ring : rings) {
    for (Eigen::Vector2d& p : ring) {
      const double x = p.x() + shift;
      p = text.position * scale +
          Eigen::Vector2d(turn.cos * x - turn.sin * p.y(), turn.sin * x + turn.cos * p.y());
    }
  }
  fill(image, std::move(rings), text.color);
}

}  // namespace

std::vector<float> coverage(const std::vector<Path>& rings, int w, int h) {
  Accumulator accumulator(w, h);
  for (const Path& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      accumulator.edge(ring[i], ring[(i + 1) % ring.size()]);
    }
  }
  return accumulator.finish();
}

Image blank_image(int width, int height, Color color) {
  Image image{width, height, {}};
  image.rgb.resize(3 * std::size_t(width) * std::size_t(height));
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    image.rgb[i] = color.r;
    image.rgb[i + 1] = color.g;
    image.rgb[i + 2] = color.b;
  }
  return image;
}

void paint(const VectorPicture& picture, Image& image, double scale) {
  for (const auto& item : picture.items) {
    std::visit([&](const auto& value) { paint_item(value, image, scale); }, item);
  }
}

Image to_image(const VectorPicture& picture, double scale, Color background) {
  Image image = blank_image(int(std::lround(picture.width * scale)),
                            int(std::lround(picture.height * scale)), background);
  paint(picture, image, scale);
  return image;
}

void copy_into(Image& image, const Image& source, int x, int y) {
  const int left = std::max(0, x);
  const int right = std::min(image.width, x + source.width);
  if (left >= right) return;
  for (int row = std::max(0, y); row < std::min(image.height, y + source.height); ++row) {
    const auto from =
        source.rgb.begin() + 3 * (std::ptrdiff_t(row - y) * source.width + (left - x));
    std::copy(from, from + 3 * std::ptrdiff_t(right - left),
              image.rgb.begin() + 3 * (std::ptrdiff_t(row) * image.width + left));
  }
}

}  // namespace scanchor
