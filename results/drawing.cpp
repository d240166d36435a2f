#include "results/drawing.hpp"

#include "core/error.hpp"

namespace scanchor {
namespace {

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void extend(Eigen::AlignedBox3d& box, const std::vector<Eigen::Vector3d>& places,
            const char* what) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i].allFinite()) {
      fail_data("", std::string(what) + " " + std::to_string(i),
                "a coordinate is not a finite number and cannot be drawn",
                "set such points aside first");
    }
    box.extend(places[i]);
  }
}

}  // namespace

void Drawing::add(const Drawing& other) {
  append(meshes, other.meshes);
  append(points, other.points);
  append(lines, other.lines);
  append(polygons, other.polygons);
  append(labels, other.labels);
  append(arrows, other.arrows);
  if (title.empty()) title = other.title;
  if (subtitle.empty()) subtitle = other.subtitle;
  if (legend.empty() && !legend_bar) {
    legend = other.legend;
    legend_title = other.legend_title;
    legend_bar = other.legend_bar;
  }
  bounds.extend(other.bounds);
}

void Drawing::move(const Eigen::Isometry3d& T) {
  const auto all = [&](std::vector<Eigen::Vector3d>& places) {
    for (Eigen::Vector3d& p : places) p = T * p;
  };
  for (DrawnMesh& mesh : meshes) {
    all(mesh.vertices);
    for (Eigen::Vector3d& n : mesh.normals) n = T.linear() * n;
  }
  for (DrawnPoints& group : points) all(group.positions);
  for (DrawnLines& group : lines) all(group.ends);
  for (DrawnPolygon& polygon : polygons) {
    all(polygon.outer);
    for (auto& hole : polygon.holes) all(hole);
  }
  for (DrawnLabel& label : labels) label.anchor = T * label.anchor;
  for (DrawnArrow& arrow : arrows) {
    arrow.from = T * arrow.from;
    arrow.to = T * arrow.to;
  }
  if (!bounds.isEmpty()) bounds = bounds.transformed(T);
}

void add_box_lines(DrawnLines& lines, const Eigen::Isometry3d& pose, const Eigen::Vector3d& size) {
  const auto corner = [&](int i) -> Eigen::Vector3d {
    const Eigen::Vector3d half(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    return pose * Eigen::Vector3d(half.cwiseProduct(size));
  };
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if ((i & bit) != 0) continue;
      lines.ends.push_back(corner(i));
      lines.ends.push_back(corner(i | bit));
    }
  }
}

std::vector<Eigen::Vector3d> places_to_frame(const Drawing& drawing) {
  constexpr std::size_t enough = 100000;
  std::vector<Eigen::Vector3d> places;
  const auto take = [&](const std::vector<Eigen::Vector3d>& from) {
    const std::size_t step = 1 + from.size() / enough;
    for (std::size_t i = 0; i < from.size(); i += step) places.push_back(from[i]);
  };
  for (const DrawnMesh& mesh : drawing.meshes) take(mesh.vertices);
  for (const DrawnPoints& group : drawing.points) take(group.positions);
  for (const DrawnPolygon& polygon : drawing.polygons) take(polygon.outer);
  return places;
}

Eigen::AlignedBox3d bounds_of(const Drawing& drawing) {
  Eigen::AlignedBox3d box;
  for (const DrawnMesh& mesh : drawing.meshes) extend(box, mesh.vertices, "vertex");
  for (const DrawnPoints& points : drawing.points) extend(box, points.positions, "point");
  for (const DrawnLines& lines : drawing.lines) extend(box, lines.ends, "line end");
  for (const DrawnPolygon& polygon : drawing.polygons) extend(box, polygon.outer, "corner");
  for (const DrawnLabel& label : drawing.labels) {
    Eigen::AlignedBox3d ignored;
    extend(ignored, {label.anchor}, "anchor of a label");
  }
  for (const DrawnArrow& arrow : drawing.arrows) {
    Eigen::AlignedBox3d ignored;
    extend(ignored, {arrow.from, arrow.to}, "end of an arrow");
  }
  return box;
}

}  // namespace scanchor
