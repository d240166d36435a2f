#pragma once
// What is to be drawn, as a plain value: the builders draw_*.hpp make it, render.hpp turns it into
// pixels, draw_svg.hpp into paths. Coordinates in metres in one frame with z up.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "results/color.hpp"

namespace scanchor {

/// Triangles with a normal and a colour a vertex. Vertices are not shared between differently
/// shaded faces.
struct DrawnMesh {
  std::vector<Eigen::Vector3d> vertices;  ///< [m]
  std::vector<Eigen::Vector3d> normals;   ///< unit, one a vertex; empty: not shaded
  std::vector<Color> colors;  ///< one a vertex; an opacity below 255 is blended over what is opaque
  std::vector<Eigen::Vector3i> triangles;
};

struct DrawnPoints {
  std::vector<Eigen::Vector3d> positions;  ///< [m]
  std::vector<Color> colors;               ///< one a point
  double size_px = 2.5;                    ///< diameter of the disc
  double size_m =
      0.0;  ///< [m] if above 0: the diameter in space, never below size_px on the picture
};

/// Straight pieces with a constant width on the picture.
struct DrawnLines {
  std::vector<Eigen::Vector3d> ends;  ///< two a piece
  Color color = ink;
  double width_px = 1.5;
  bool hidden = false;  ///< true: also drawn where something stands in front
};

/// A polygon with holes in a plane, for SVG (render() draws its triangles and outline).
struct DrawnPolygon {
  std::vector<Eigen::Vector3d> outer;
  std::vector<std::vector<Eigen::Vector3d>> holes;
  Color fill;
  Color outline;
  double outline_px = 1.5;
};

struct DrawnLabel {
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  ///< [m] what the label points at
  std::string text;                                  ///< one line
  Color color = ink;                                 ///< of the mark and the border
  double priority = 0.0;                             ///< larger ones are placed first
  double extent =
      0.0;  ///< [m] of the thing; names of what is too small to see are left out. 0: unknown
};

/// An arrow between two things, with a word at its middle.
struct DrawnArrow {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  Color color = ink;
  double width_px = 1.6;
  std::string text;
};

struct LegendEntry {
  std::string text;
  Color color;
};

struct LegendBar {
  std::string title;  ///< with unit: "height [m]"
  ColorMap map = ColorMap::cividis;
  double low = 0.0;  ///< value at the map's start
  double high = 1.0;
};

struct Drawing {
  std::string title;
  std::string subtitle;
  std::vector<DrawnMesh> meshes;
  std::vector<DrawnPoints> points;
  std::vector<DrawnLines> lines;
  std::vector<DrawnPolygon> polygons;
  std::vector<DrawnLabel> labels;
  std::vector<DrawnArrow> arrows;
  std::vector<LegendEntry> legend;
  std::string legend_title;
  std::optional<LegendBar> legend_bar;
  /// [m] of what a view should frame; empty: nothing to see.
  Eigen::AlignedBox3d bounds;

  /// Adds all of the other's contents; titles and legend only where this has none.
  void add(const Drawing& other);
  /// Moves everything: from the frame it is in to the frame `T` leads to.
  void move(const Eigen::Isometry3d& T);
};

/// The twelve edges of an oriented box: `pose` is its centre, `size` its sides [m].
void add_box_lines(DrawnLines& lines, const Eigen::Isometry3d& pose, const Eigen::Vector3d& size);

/// What a view should keep inside: vertices, points (of a large cloud an even sample), corners.
std::vector<Eigen::Vector3d> places_to_frame(const Drawing& drawing);

/// Box of all vertices, points, polygon corners and line ends. Throws Error(bad_data) naming the
/// first that is not finite.
Eigen::AlignedBox3d bounds_of(const Drawing& drawing);

}  // namespace scanchor
