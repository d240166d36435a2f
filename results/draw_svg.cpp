#include "results/draw_svg.hpp"

#include <algorithm>

#include "results/overlay.hpp"

namespace scanchor {
namespace {

struct Piece {
  double distance;
  VectorShape shape;
};

/// The ring on the picture; false if a corner lies behind the eye.
bool project(const Projection& projection, const std::vector<Eigen::Vector3d>& ring, Path& path,
             double& distance) {
  for (const Eigen::Vector3d& p : ring) {
    const Eigen::Vector3d pixel = projection.pixel(p);
    if (!projection.parallel() && pixel.z() < projection.near_plane()) return false;
    path.emplace_back(pixel.head<2>());
    distance += pixel.z();
  }
  return !ring.empty();
}

void add_polygons(std::vector<Piece>& pieces, const Drawing& drawing,
                  const Projection& projection) {
  for (const DrawnPolygon& polygon : drawing.polygons) {
    Piece piece{0.0, {}};
    Path outer;
    if (!project(projection, polygon.outer, outer, piece.distance)) continue;
    piece.distance /= double(polygon.outer.size());
    piece.shape.paths.push_back(std::move(outer));
    for (const auto& hole : polygon.holes) {
      Path ring;
      double ignored = 0.0;
      if (project(projection, hole, ring, ignored)) piece.shape.paths.push_back(std::move(ring));
    }
    piece.shape.fill = polygon.fill;
    piece.shape.stroke = polygon.outline;
    piece.shape.width = polygon.outline_px;
    pieces.push_back(std::move(piece));
  }
}

void add_lines(std::vector<Piece>& pieces, const Drawing& drawing, const Projection& projection) {
  for (const DrawnLines& lines : drawing.lines) {
    for (std::size_t i = 0; i + 1 < lines.ends.size(); i += 2) {
      Piece piece{0.0, {}};
      Path path;
      if (!project(projection, {lines.ends[i], lines.ends[i + 1]}, path, piece.distance)) continue;
      // Half a centimetre nearer, so that a line on a face is seen.
      piece.distance = piece.distance / 2 - (lines.hidden ? 1e6 : 0.005);
      piece.shape.paths = {std::move(path)};
      piece.shape.closed = false;
      piece.shape.stroke = lines.color;
      piece.shape.width = lines.width_px;
      pieces.push_back(std::move(piece));
    }
  }
}

void add_points(std::vector<Piece>& pieces, const Drawing& drawing, const Projection& projection,
                std::size_t most_points) {
  std::size_t total = 0;
  for (const DrawnPoints& group : drawing.points) total += group.positions.size();
  const std::size_t step = most_points == 0 ? total + 1 : 1 + total / (most_points + 1);
  for (const DrawnPoints& group : drawing.points) {
    for (std::size_t i = 0; i < group.positions.size(); i += step) {
      const Eigen::Vector3d pixel = projection.pixel(group.positions[i]);
      if (!projection.parallel() && pixel.z() < projection.near_plane()) continue;
      const double r = 0.5 * std::max(group.size_px, 1.0);
      Piece piece{pixel.z(), {}};
      const double x = pixel.x();
      const double y = pixel.y();
      piece.shape.paths = {{{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}}};
      piece.shape.fill = group.colors[i];
      pieces.push_back(std::move(piece));
    }
  }
}

}  // namespace

VectorPicture draw_outlines(const Drawing& drawing, const View& view, const RenderOptions& options,
                            std::size_t most_points) {
  bounds_of(drawing);  // Refuses what is not finite.
  const Projection projection = projection_for(drawing, view, options);
  std::vector<Piece> pieces;
  add_polygons(pieces, drawing, projection);
  add_points(pieces, drawing, projection, most_points);
  add_lines(pieces, drawing, projection);
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.distance > b.distance; });
  VectorPicture picture{options.width, options.height, {}};
  for (Piece& piece : pieces) picture.items.emplace_back(std::move(piece.shape));
  picture.append(make_overlay(drawing, projection, options, {}).picture, 0.0, 0.0);
  return picture;
}

}  // namespace scanchor
