#include "perception/hough_rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/math.hpp"

namespace scanchor {
namespace {

/// The outer rings as cells of a bitmap, each cell once, in rows.
struct Bitmap {
  cv::Mat1b image;
  std::vector<Eigen::Vector2d> cells;                ///< [m] centres of the cells that are set
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< [m] centre of cell (0, 0)
  double cell = 0.01;
};

Bitmap draw_outline(const std::vector<Polygon>& polygons, double cell) {
  Bitmap bitmap;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d high = -low;
  for (const Polygon& polygon : polygons) {
    for (const auto& p : polygon.outer) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  while ((high - low).maxCoeff() / cell > 4090.0) cell *= 2.0;
  const Eigen::Vector2d size = (high - low) / cell;
  bitmap.cell = cell;
  bitmap.origin = low - Eigen::Vector2d::Constant(2.0 * cell);
  bitmap.image = cv::Mat1b::zeros(static_cast<int>(size.y()) + 6, static_cast<int>(size.x()) + 6);
  for (const Polygon& polygon : polygons) {
    std::vector<cv::Point> ring;
    for (const auto& p : polygon.outer) {
      const Eigen::Vector2d q = (p - bitmap.origin) / cell;
      ring.emplace_back(static_cast<int>(std::lround(q.x())), static_cast<int>(std::lround(q.y())));
    }
    cv::polylines(bitmap.image, ring, true, cv::Scalar(255));
  }
  for (int y = 0; y < bitmap.image.rows; ++y) {
    for (int x = 0; x < bitmap.image.cols; ++x) {
      if (bitmap.image(y, x)) bitmap.cells.push_back(bitmap.origin + cell * Eigen::Vector2d(x, y));
    }
  }
  return bitmap;
}

Eigen::Vector2d normal_of(const HoughLine& line) {
  return {std::cos(line.angle), std::sin(line.angle)};
}

/// Angle between two lines without direction, [0, pi/2].
double angle_between(double a, double b) {
  const double d = std::fmod(std::abs(a - b), pi);
  return std::min(d, pi - d);
}

/// Total least squares over the cells within `reach` of the line.
HoughLine refit(const std::vector<Eigen::Vector2d>& cells, HoughLine line, double reach) {
  const Eigen::Vector2d n = normal_of(line);
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  int count = 0;
  for (const auto& p : cells) {
    if (std::abs(n.dot(p) - line.offset) > reach) continue;
    mean += p;
    ++count;
  }
  line.votes = count;
  if (count < 3) return line;
  mean /= count;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const auto& p : cells) {
    if (std::abs(n.dot(p) - line.offset) > reach) continue;
    const Eigen::Vector2d d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  line.angle = 0.5 * std::atan2(2.0 * xy, xx - yy) + 0.5 * pi;  // normal: across the main axis
  if (line.angle >= pi) line.angle -= pi;
  line.offset = normal_of(line).dot(mean);
  return line;
}

std::optional<Eigen::Vector2d> intersection(const HoughLine& a, const HoughLine& b) {
  const Eigen::Vector2d n = normal_of(a);
  const Eigen::Vector2d m = normal_of(b);
  const double det = n.x() * m.y() - n.y() * m.x();
  if (std::abs(det) < 0.5) return std::nullopt;
  return Eigen::Vector2d((a.offset * m.y() - b.offset * n.y()) / det,
                         (n.x() * b.offset - m.x() * a.offset) / det);
}

/// Share of side a-b that has a cell within `reach`, in steps of one cell.
double side_support(const std::vector<Eigen::Vector2d>& cells, const Eigen::Vector2d& a,
                    const Eigen::Vector2d& b, double reach, double cell, std::vector<char>& near) {
  const double length = (b - a).norm();
  const Eigen::Vector2d u = (b - a) / length;
  std::vector<char> covered(static_cast<std::size_t>(length / cell) + 1, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Eigen::Vector2d d = cells[i] - a;
    const double along = d.dot(u);
    if (std::abs(d.x() * u.y() - d.y() * u.x()) > reach || along < -reach || along > length + reach)
      continue;
    near[i] = 1;
    const int middle = static_cast<int>(along / cell);
    for (int k = std::max(0, middle - 1);
         k <= std::min(middle + 1, static_cast<int>(covered.size()) - 1); ++k) {
      covered[static_cast<std::size_t>(k)] = 1;
    }
  }
  return static_cast<double>(std::count(covered.begin(), covered.end(), 1)) /
         static_cast<double>(covered.size());
}

std::vector<HoughLine> lines_of(const Bitmap& bitmap, const HoughOptions& options) {
  // Two cells and two degrees: the outline of a scanned edge wavers by about a cell. An eighth of
  // the shape's height is the shortest side worth a line; below eight cells any two pieces of
  // outline vote for one.
  const double tolerance = radians(options.angle_tolerance_deg);
  const int shortest = std::min(bitmap.image.rows, bitmap.image.cols);
  std::vector<cv::Vec3f> found;
  cv::HoughLines(bitmap.image, found, 2.0, pi / 90.0, std::max(8, shortest / 8));
  std::vector<HoughLine> lines;
  const double reach = 2.5 * bitmap.cell;
  for (const auto& raw : found) {
    HoughLine line;
    line.angle = raw[1];
    line.offset = raw[0] * bitmap.cell + normal_of(line).dot(bitmap.origin);
    // The merge step: the transform answers one edge with a sheaf of lines about the strongest.
    bool merged = false;
    for (const HoughLine& other : lines) {
      if (angle_between(line.angle, other.angle) > 2.0 * tolerance) continue;
      // Same edge if the two run within a tenth of the shape of each other at its middle.
      const Eigen::Vector2d middle =
          bitmap.origin + 0.5 * bitmap.cell * Eigen::Vector2d(bitmap.image.cols, bitmap.image.rows);
      const Eigen::Vector2d foot =
          middle + (other.offset - normal_of(other).dot(middle)) * normal_of(other);
      merged = merged || std::abs(normal_of(line).dot(foot) - line.offset) <
                             std::max(4.0, shortest / 10.0) * bitmap.cell;
    }
    if (merged) continue;
    for (int round = 0; round < 2; ++round) line = refit(bitmap.cells, line, reach);
    lines.push_back(line);
    if (lines.size() == 12) break;  // strongest first: more than twelve edges are no rectangle
  }
  return lines;
}

}  // namespace

std::vector<HoughLine> hough_lines(const std::vector<Polygon>& polygons,
                                   const HoughOptions& options) {
  if (polygons.empty()) return {};
  return lines_of(draw_outline(polygons, options.cell), options);
}

std::optional<std::array<Eigen::Vector2d, 4>> hough_rectangle(const std::vector<Polygon>& polygons,
                                                              const HoughOptions& options) {
  if (polygons.empty()) return std::nullopt;
  const Bitmap bitmap = draw_outline(polygons, options.cell);
  const std::vector<HoughLine> lines = lines_of(bitmap, options);
  const double tolerance = radians(options.angle_tolerance_deg);
  const double reach = 3.0 * bitmap.cell;
  std::optional<std::array<Eigen::Vector2d, 4>> best;
  double best_support = 0.0;
  std::vector<char> near(bitmap.cells.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      if (angle_between(lines[i].angle, lines[j].angle) > tolerance) continue;
      for (std::size_t k = i + 1; k < lines.size(); ++k) {
        for (std::size_t l = k + 1; l < lines.size(); ++l) {
          if (k == j || l == j || angle_between(lines[k].angle, lines[l].angle) > tolerance)
            continue;
          if (angle_between(lines[i].angle, lines[k].angle) < 0.5 * pi - tolerance) continue;
          const std::array corners = {
              intersection(lines[i], lines[k]), intersection(lines[k], lines[j]),
              intersection(lines[j], lines[l]), intersection(lines[l], lines[i])};
          if (!corners[0] || !corners[1] || !corners[2] || !corners[3]) continue;
          std::fill(near.begin(), near.end(), 0);
          double weakest = 1.0;
          double sum = 0.0;
          for (std::size_t s = 0; s < 4; ++s) {
            if ((*corners[s] - *corners[(s + 1) % 4]).norm() < 3.0 * bitmap.cell) {
              weakest = 0.0;
              break;
            }
            const double share = side_support(bitmap.cells, *corners[s], *corners[(s + 1) % 4],
                                              reach, bitmap.cell, near);
            weakest = std::min(weakest, share);
            sum += share;
          }
          const double outline = static_cast<double>(std::count(near.begin(), near.end(), 1)) /
                                 static_cast<double>(near.size());
          if (weakest < options.side_support || outline < options.outline_share ||
              sum * outline <= best_support)
            continue;
          best_support = sum * outline;
          best = {{*corners[0], *corners[1], *corners[2], *corners[3]}};
        }
      }
    }
  }
  if (best && ring_area({best->begin(), best->end()}) < 0.0)
    std::reverse(best->begin(), best->end());
  return best;
}

}  // namespace scanchor
