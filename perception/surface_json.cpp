// surfaces.json: docs/reference/surfaces-format.md. Doubles are written as the shortest text that
// reads back to the same bits, and the frame as its axes rather than a quaternion, so that reading
// and writing again gives the same bytes.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "core/json.hpp"
#include "perception/surface.hpp"

namespace scanchor {
namespace {

constexpr const char* format_name = "scanchor surfaces";
constexpr int format_version = 1;
constexpr std::array kinds = {EdgeKind::true_edge, EdgeKind::occlusion, EdgeKind::view_limit,
                              EdgeKind::unknown};

Json measured_to_json(const Measured& m) {
  return {{"value", m.value}, {"low", m.low}, {"high", m.high}, {"at_least", m.at_least}};
}

Measured measured_from_json(const JsonReader& json) {
  json.only({"value", "low", "high", "at_least"});
  Measured m;
  m.value = json.at("value").number();
  m.low = json.at("low").number();
  m.high = json.at("high").number();
  m.at_least = json.at("at_least").boolean();
  if (m.low > m.high) json.fail("low must not lie above high");
  return m;
}

Json ring_to_json(const Ring& ring) {
  Json json = Json::array();
  for (const auto& p : ring) json.push_back(to_json(p));
  return json;
}

Ring ring_from_json(const JsonReader& json) {
  Ring ring(json.size());
  if (ring.size() < 3) json.fail("a ring has at least three vertices");
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = json.at(i).vector2();
  return ring;
}

EdgeKind kind_from_json(const JsonReader& json) {
  const std::string name = json.text();
  for (const EdgeKind kind : kinds) {
    if (edge_kind_name(kind) == name) return kind;
  }
  json.fail(fmt::format("unknown kind of edge '{}'", name),
            "true_edge, occlusion, view_limit or unknown");
}

Json polygon_to_json(const Polygon& polygon) {
  Json json = {{"outer", ring_to_json(polygon.outer)},
               {"holes", Json::array()},
               {"outer_kind", Json::array()}};
  for (const Ring& hole : polygon.holes) json["holes"].push_back(ring_to_json(hole));
  for (const EdgeKind kind : polygon.outer_kind) json["outer_kind"].push_back(edge_kind_name(kind));
  return json;
}

Polygon polygon_from_json(const JsonReader& json) {
  json.only({"outer", "holes", "outer_kind"});
  Polygon polygon;
  polygon.outer = ring_from_json(json.at("outer"));
  const JsonReader holes = json.at("holes");
  for (std::size_t i = 0; i < holes.size(); ++i)
    polygon.holes.push_back(ring_from_json(holes.at(i)));
  const JsonReader names = json.at("outer_kind");
  for (std::size_t i = 0; i < names.size(); ++i)
    polygon.outer_kind.push_back(kind_from_json(names.at(i)));
  if (!polygon.outer_kind.empty() && polygon.outer_kind.size() != polygon.outer.size()) {
    names.fail(
        fmt::format("{} kinds for {} edges", polygon.outer_kind.size(), polygon.outer.size()));
  }
  return polygon;
}

Json matrix_to_json(const Eigen::Matrix3d& m) {
  Json json = Json::array();
  for (int row = 0; row < 3; ++row) json.push_back(to_json(Eigen::Vector3d(m.row(row))));
  return json;
}

Eigen::Matrix3d matrix_from_json(const JsonReader& json) {
  if (json.size() != 3) json.fail("must be three rows");
  Eigen::Matrix3d m;
  for (std::size_t row = 0; row < 3; ++row) m.row(static_cast<int>(row)) = json.at(row).vector3();
  return m;
}

Json plane_to_json(const Plane& plane) {
  return {{"normal", to_json(plane.normal)},
          {"offset", plane.offset},
          {"centroid", to_json(plane.centroid)},
          {"residual_sigma", plane.residual_sigma},
          {"normal_covariance", matrix_to_json(plane.normal_covariance)},
          {"centroid_sigma", plane.centroid_sigma}};
}

Plane plane_from_json(const JsonReader& json) {
  json.only(
      {"normal", "offset", "centroid", "residual_sigma", "normal_covariance", "centroid_sigma"});
  Plane plane;
  plane.normal = json.at("normal").vector3();
  if (std::abs(plane.normal.norm() - 1.0) > 1e-6) json.at("normal").fail("must have length 1");
  plane.offset = json.at("offset").number();
  plane.centroid = json.at("centroid").vector3();
  plane.residual_sigma = json.at("residual_sigma").number();
  plane.normal_covariance = matrix_from_json(json.at("normal_covariance"));
  plane.centroid_sigma = json.at("centroid_sigma").number();
  return plane;
}

Json frame_to_json(const Eigen::Isometry3d& T) {
  return {{"origin", to_json(Eigen::Vector3d(T.translation()))},
          {"x_axis", to_json(Eigen::Vector3d(T.linear().col(0)))},
          {"y_axis", to_json(Eigen::Vector3d(T.linear().col(1)))},
          {"z_axis", to_json(Eigen::Vector3d(T.linear().col(2)))}};
}

Eigen::Isometry3d frame_from_json(const JsonReader& json) {
  json.only({"origin", "x_axis", "y_axis", "z_axis"});
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = json.at("origin").vector3();
  T.linear().col(0) = json.at("x_axis").vector3();
  T.linear().col(1) = json.at("y_axis").vector3();
  T.linear().col(2) = json.at("z_axis").vector3();
  const Eigen::Matrix3d gram = T.linear().transpose() * T.linear();
  if (!gram.isIdentity(1e-6) || T.linear().determinant() < 0.0) {
    json.fail("the axes must be of length 1, at right angles and right-handed");
  }
  return T;
}

Json surface_to_json(const Surface& s, bool with_inliers) {
  Json json;
  json["id"] = s.id;
  json["plane"] = plane_to_json(s.plane);
  json["T_cloud_surface"] = frame_to_json(s.T_cloud_surface);
  json["inlier_count"] = s.inliers.empty() ? s.inlier_count : s.inliers.size();
  json["area"] = measured_to_json(s.area);
  json["rectangle"] = {{"center", to_json(s.rectangle.center)},
                       {"angle", s.rectangle.angle},
                       {"length", measured_to_json(s.rectangle.length)},
                       {"width", measured_to_json(s.rectangle.width)}};
  json["rectangularness"] = s.rectangularness;
  json["is_rectangle"] = s.is_rectangle;
  json["eccentricity"] = s.eccentricity;
  json["occluded_outline"] = s.occluded_outline;
  json["confidence"] = s.confidence;
  json["polygons"] = Json::array();
  for (const Polygon& polygon : s.polygons) json["polygons"].push_back(polygon_to_json(polygon));
  if (with_inliers) json["inliers"] = s.inliers;
  return json;
}

Surface surface_from_json(const JsonReader& json, std::size_t points) {
  json.only({"id", "plane", "T_cloud_surface", "inlier_count", "area", "rectangle",
             "rectangularness", "is_rectangle", "eccentricity", "occluded_outline", "confidence",
             "polygons", "inliers"});
  Surface s;
  s.id = static_cast<std::int32_t>(json.at("id").integer());
  s.plane = plane_from_json(json.at("plane"));
  s.T_cloud_surface = frame_from_json(json.at("T_cloud_surface"));
  s.inlier_count = static_cast<std::size_t>(json.at("inlier_count").integer());
  s.area = measured_from_json(json.at("area"));
  const JsonReader rectangle = json.at("rectangle");
  rectangle.only({"center", "angle", "length", "width"});
  s.rectangle.center = rectangle.at("center").vector2();
  s.rectangle.angle = rectangle.at("angle").number();
  s.rectangle.length = measured_from_json(rectangle.at("length"));
  s.rectangle.width = measured_from_json(rectangle.at("width"));
  s.rectangularness = json.at("rectangularness").number_in(0.0, 1.0);
  s.is_rectangle = json.at("is_rectangle").boolean();
  s.eccentricity = json.at("eccentricity").number_in(0.0, 1.0);
  s.occluded_outline = json.at("occluded_outline").number_in(0.0, 1.0);
  s.confidence = json.at("confidence").number_in(0.0, 1.0);
  const JsonReader polygons = json.at("polygons");
  for (std::size_t i = 0; i < polygons.size(); ++i)
    s.polygons.push_back(polygon_from_json(polygons.at(i)));
  if (json.has("inliers")) {
    const JsonReader inliers = json.at("inliers");
    s.inliers.reserve(inliers.size());
    for (std::size_t i = 0; i < inliers.size(); ++i) {
      const auto index = inliers.at(i).integer();
      if (index < 0 || static_cast<std::size_t>(index) >= points) {
        inliers.at(i).fail(fmt::format("must be the index of one of {} points", points));
      }
      if (!s.inliers.empty() && static_cast<std::uint32_t>(index) <= s.inliers.back()) {
        inliers.at(i).fail("indices must rise");
      }
      s.inliers.push_back(static_cast<std::uint32_t>(index));
    }
    if (s.inliers.size() != s.inlier_count) {
      inliers.fail(
          fmt::format("holds {} indices, inlier_count says {}", s.inliers.size(), s.inlier_count));
    }
  }
  return s;
}

}  // namespace

Json surfaces_to_json(const Surfaces& surfaces, bool with_inliers) {
  Json json;
  json["format"] = format_name;
  json["version"] = format_version;
  json["point_count"] = surfaces.plane_of_point.size();
  json["noise_sigma"] = surfaces.noise_sigma;
  json["point_spacing"] = surfaces.point_spacing;
  json["set_aside"] = {{"not_finite", surfaces.set_aside.not_finite},
                       {"out_of_range", surfaces.set_aside.out_of_range},
                       {"scanner_body", surfaces.set_aside.scanner_body}};
  json["sensor_positions"] = Json::array();
  for (const auto& p : surfaces.sensor_positions) json["sensor_positions"].push_back(to_json(p));
  json["surfaces"] = Json::array();
  for (const Surface& s : surfaces.surfaces)
    json["surfaces"].push_back(surface_to_json(s, with_inliers));
  return json;
}

Surfaces surfaces_from_json(const Json& raw, const std::string& file) {
  const JsonReader json(raw, file);
  if (!json.has("format") || !json.raw()["format"].is_string() ||
      json.at("format").text() != format_name) {
    json.fail("is no list of surfaces", fmt::format("\"format\" must be \"{}\"", format_name));
  }
  if (json.at("version").integer() != format_version) {
    json.at("version").fail(fmt::format("is {}, this program reads version {}",
                                        json.at("version").integer(), format_version));
  }
  json.only({"format", "version", "point_count", "noise_sigma", "point_spacing", "set_aside",
             "sensor_positions", "surfaces"});
  Surfaces all;
  const auto points = json.at("point_count").integer();
  if (points < 0 || points > std::numeric_limits<std::int32_t>::max())
    json.at("point_count").fail("is no number of points");
  all.plane_of_point.assign(static_cast<std::size_t>(points), -1);
  all.noise_sigma = json.at("noise_sigma").number();
  all.point_spacing = json.at("point_spacing").number();
  const JsonReader aside = json.at("set_aside");
  aside.only({"not_finite", "out_of_range", "scanner_body"});
  all.set_aside.not_finite = static_cast<std::size_t>(aside.at("not_finite").integer());
  all.set_aside.out_of_range = static_cast<std::size_t>(aside.at("out_of_range").integer());
  all.set_aside.scanner_body = static_cast<std::size_t>(aside.at("scanner_body").integer());
  const JsonReader positions = json.at("sensor_positions");
  for (std::size_t i = 0; i < positions.size(); ++i)
    all.sensor_positions.push_back(positions.at(i).vector3());
  const JsonReader list = json.at("surfaces");
  for (std::size_t i = 0; i < list.size(); ++i) {
    all.surfaces.push_back(surface_from_json(list.at(i), all.plane_of_point.size()));
    const Surface& s = all.surfaces.back();
    if (s.id != static_cast<std::int32_t>(i))
      list.at(i).at("id").fail(fmt::format("must be {}, its place in the list", i));
    for (const std::uint32_t point : s.inliers) {
      if (all.plane_of_point[point] >= 0) {
        list.at(i).at("inliers").fail(fmt::format("point {} belongs to surface {} already", point,
                                                  all.plane_of_point[point]));
      }
      all.plane_of_point[point] = s.id;
    }
  }
  return all;
}

void write_surfaces(const std::filesystem::path& path, const Surfaces& surfaces,
                    bool with_inliers) {
  write_json(path, surfaces_to_json(surfaces, with_inliers));
}

Surfaces read_surfaces(const std::filesystem::path& path) {
  return surfaces_from_json(read_json(path), path.string());
}

}  // namespace scanchor
