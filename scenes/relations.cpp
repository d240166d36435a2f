#include "scenes/relations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math.hpp"
#include "scenes/truth.hpp"

namespace scanchor {
namespace {

constexpr std::array<std::string_view, relation_count> names = {
    "parallel", "orthogonal", "above",    "below",       "on",
    "supports", "inside",     "near",     "same size",   "vertically aligned",
    "coplanar", "left of",    "right of", "in front of", "behind"};

using Ring2 = std::vector<Eigen::Vector2d>;

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area_of(const Ring2& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    twice += cross2(ring[i], ring[(i + 1) % ring.size()]);
  return ring.size() < 3 ? 0.0 : 0.5 * twice;
}

/// Minkowski sum of a convex polygon with a regular octagon around the circle of radius r.
Ring2 dilated(const Ring2& ring, double r) {
  if (r <= 0) return ring;
  Ring2 points;
  const double s = r * 0.41421356237309503;  // tan(22.5 deg)
  for (const auto& p : ring) {
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        points.emplace_back(p.x() + a * r, p.y() + b * s);
        points.emplace_back(p.x() + a * s, p.y() + b * r);
      }
    }
  }
  return convex_hull(std::move(points));
}

double overlap_area(Ring2 a, const Ring2& b) {
  for (std::size_t i = 0; i < b.size() && !a.empty(); ++i) {
    const Eigen::Vector2d& p = b[i];
    const Eigen::Vector2d d = b[(i + 1) % b.size()] - p;
    Ring2 kept;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const Eigen::Vector2d& u = a[k];
      const Eigen::Vector2d& v = a[(k + 1) % a.size()];
      const double du = cross2(d, u - p);
      const double dv = cross2(d, v - p);
      if (du >= 0) kept.push_back(u);
      if ((du > 0 && dv < 0) || (du < 0 && dv > 0)) kept.push_back(u + (du / (du - dv)) * (v - u));
    }
    a = std::move(kept);
  }
  return area_of(a);
}

/// Share of a's footprint that lies over b's, both grown so that upright faces have an area.
double overlap_share(const Ring2& a, const Ring2& b) {
  const double whole = area_of(a);
  return whole <= 0 ? 0.0 : overlap_area(a, b) / whole;
}

/// Distance between two segments (Ericson, Real-Time Collision Detection, 2005, section 5.1.9).
double segment_distance(const Eigen::Vector3d& p1, const Eigen::Vector3d& d1,
                        const Eigen::Vector3d& p2, const Eigen::Vector3d& d2) {
  const Eigen::Vector3d r = p1 - p2;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(r);
  const double c = d1.dot(r);
  const double b = d1.dot(d2);
  if (a < 1e-18 || e < 1e-18) {
    const double s = a < 1e-18 ? 0.0 : std::clamp(-c / a, 0.0, 1.0);
    const double t = e < 1e-18 ? 0.0 : std::clamp(f / e, 0.0, 1.0);
    return (r + s * d1 - t * d2).norm();
  }
  const double denominator = a * e - b * b;
  double s =
      denominator > 1e-12 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0.0) {
    t = 0.0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1.0) {
    t = 1.0;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return (r + s * d1 - t * d2).norm();
}

/// Distance between two boxes. Alternating projections give an upper bound and the faces' axes a
/// lower one, which mostly agree at once; where they do not, the nearest pair is a corner against a
/// box or an edge against an edge, and all are looked at.
double box_distance(const OrientedBox& a, const OrientedBox& b) {
  const auto project = [](const OrientedBox& box, const Eigen::Vector3d& p) {
    const Eigen::Vector3d local = box.axes.transpose() * (p - box.center);
    return Eigen::Vector3d(box.center + box.axes * local.cwiseMax(-box.half).cwiseMin(box.half));
  };
  Eigen::Vector3d p = project(a, b.center);
  Eigen::Vector3d q = project(b, p);
  double last = (p - q).norm();
  double apart = 0.0;
  const Eigen::Vector3d d = b.center - a.center;
  for (const OrientedBox* box : {&a, &b}) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d axis = box->axes.col(k);
      const double reach = (a.axes.transpose() * axis).cwiseAbs().dot(a.half) +
                           (b.axes.transpose() * axis).cwiseAbs().dot(b.half);
      apart = std::max(apart, std::abs(axis.dot(d)) - reach);
    }
  }
  for (int i = 0; i < 8; ++i) {
    p = project(a, q);
    q = project(b, p);
    last = std::min(last, (p - q).norm());
    if (last - apart < 1e-10) return last;
  }
  if (boxes_near(a, b, -1e-12)) return 0.0;
  const auto corner = [](const OrientedBox& box, int k) {
    const Eigen::Vector3d sign((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
    return Eigen::Vector3d(box.center + box.axes * sign.cwiseProduct(box.half));
  };
  Eigen::Vector3d of_a[8];
  Eigen::Vector3d of_b[8];
  for (int k = 0; k < 8; ++k) {
    of_a[k] = corner(a, k);
    of_b[k] = corner(b, k);
    last = std::min(
        {last, (project(b, of_a[k]) - of_a[k]).norm(), (project(a, of_b[k]) - of_b[k]).norm()});
  }
  for (int i = 0; i < 12; ++i) {
    // The four corners that have the axis' sign bit clear begin its four edges.
    const int bit = 1 << (i / 4);
    const int low = ((i % 4) & (bit - 1)) | (((i % 4) & ~(bit - 1)) << 1);
    for (int j = 0; j < 12; ++j) {
      const int other = 1 << (j / 4);
      const int begin = ((j % 4) & (other - 1)) | (((j % 4) & ~(other - 1)) << 1);
      last = std::min(last, segment_distance(of_a[low], of_a[low | bit] - of_a[low], of_b[begin],
                                             of_b[begin | other] - of_b[begin]));
    }
  }
  return last;
}

double gap_between(const RelationBody& a, const RelationBody& b) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& first : a.boxes) {
    const Eigen::AlignedBox3d outer = bounds_of(first);
    for (const auto& second : b.boxes) {
      if (outer.exteriorDistance(bounds_of(second)) >= best) continue;
      best = std::min(best, box_distance(first, second));
    }
  }
  return best;
}

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  // Between lines, 0 .. 90; atan2 keeps small angles exact.
  return degrees(std::atan2(a.cross(b).norm(), std::abs(a.dot(b))));
}

/// The worst of several conditions; each adds its own margin.
struct Worst {
  RelationMargin result{1.0, 0.0};
  bool first = true;
  void condition(double margin, double value) {
    if (first || margin < result.margin) result = {margin, value};
    first = false;
  }
  /// value at most limit, scaled by the limit.
  void at_most(double value, double limit) { condition((limit - value) / limit, value); }
};

RelationMargin above_margin(const RelationBody& a, const RelationBody& b,
                            const RelationTolerances& t) {
  Worst worst;
  const double gap = a.z_low - b.z_high;
  worst.condition((gap + t.above_gap) / t.above_gap, gap);
  // Without this, two faces of one board would be above each other.
  const double rise = a.center.z() - b.center.z();
  worst.condition(rise > 0 ? std::max(rise / t.above_gap, 1e-9) : rise / t.above_gap - 1e-9, rise);
  const double share = overlap_share(a.footprint, dilated(b.footprint, t.footprint_dilation));
  worst.condition((share - t.overlap) / (1.0 - t.overlap), share);
  worst.result.margin = std::min(worst.result.margin, 1.0);
  return worst.result;
}

RelationMargin on_margin(const RelationBody& a, const RelationBody& b,
                         const RelationTolerances& t) {
  RelationMargin best{-1e9, 0.0};
  for (const auto& face : b.level_faces) {
    Worst worst;
    const double gap = a.z_low - face.center.z();
    const double middle = 0.5 * (t.on_low + t.on_high);
    const double reach = 0.5 * (t.on_high - t.on_low);
    worst.condition((reach - std::abs(gap - middle)) / reach, gap);
    // A thing is not on what it is higher than only by its foot: its middle lies above the face.
    worst.condition(a.center.z() > face.center.z() ? 1.0 : -1.0, gap);
    const Eigen::Vector3d side = face.normal.cross(face.axis);
    Ring2 carrier;
    for (const auto& [u, v] :
         {std::pair{-0.5, -0.5}, std::pair{0.5, -0.5}, std::pair{0.5, 0.5}, std::pair{-0.5, 0.5}}) {
      carrier.push_back(
          (face.center + u * face.size.x() * face.axis + v * face.size.y() * side).head<2>());
    }
    const double share = overlap_share(a.footprint, convex_hull(carrier));
    worst.condition((share - t.overlap) / (1.0 - t.overlap), share);
    if (worst.result.margin > best.margin) best = worst.result;
  }
  return best;
}

RelationMargin inside_margin(const RelationBody& a, const RelationBody& b,
                             const RelationTolerances& t) {
  const double height = std::max(1e-3, a.z_high - a.z_low);
  const double within = std::max(0.0, std::min(a.z_high, b.z_high + t.footprint_dilation) -
                                          std::max(a.z_low, b.z_low - t.footprint_dilation));
  const double share = std::min(1.0, within / height) *
                       overlap_share(a.footprint, dilated(b.footprint, t.footprint_dilation));
  // What is inside is smaller: otherwise two equal boxes side by side on 5 cm would hold each
  // other.
  const double volume_a = height * area_of(a.footprint);
  const double volume_b = std::max(1e-3, b.z_high - b.z_low) * area_of(b.footprint);
  RelationMargin result{(share - t.inside_share) / (1.0 - t.inside_share), share};
  if (volume_a >= volume_b)
    result.margin = std::min(result.margin, -1e-9 - (volume_a - volume_b) / volume_a);
  return result;
}

RelationMargin view_margin(const RelationBody& a, const RelationBody& b, SpatialRelation relation,
                           const Eigen::Vector3d& viewpoint, const RelationTolerances& t) {
  const Eigen::Vector2d to = (b.center - viewpoint).head<2>();
  const Eigen::Vector2d d = (a.center - b.center).head<2>();
  if (to.norm() < 1e-9 || d.norm() < 1e-9) return {-1.0, 180.0};
  Eigen::Vector2d wanted = to;
  switch (relation) {
    case SpatialRelation::left_of:
      wanted = {-to.y(), to.x()};
      break;
    case SpatialRelation::right_of:
      wanted = {to.y(), -to.x()};
      break;
    case SpatialRelation::in_front_of:
      wanted = -to;
      break;
    default:
      break;
  }
  const double off = degrees(std::atan2(std::abs(cross2(wanted, d)), wanted.dot(d)));
  return {(t.cone_deg - off) / t.cone_deg, off};
}

}  // namespace

std::string_view relation_name(SpatialRelation relation) {
  return names[static_cast<std::size_t>(relation)];
}

std::optional<SpatialRelation> find_relation(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<SpatialRelation>(i);
  }
  return std::nullopt;
}

SpatialRelation inverse(SpatialRelation relation) {
  switch (relation) {
    case SpatialRelation::above:
      return SpatialRelation::below;
    case SpatialRelation::below:
      return SpatialRelation::above;
    case SpatialRelation::on:
      return SpatialRelation::supports;
    case SpatialRelation::supports:
      return SpatialRelation::on;
    default:
      return relation;
  }
}

bool is_symmetric(SpatialRelation relation) {
  switch (relation) {
    case SpatialRelation::parallel:
    case SpatialRelation::orthogonal:
    case SpatialRelation::near:
    case SpatialRelation::same_size:
    case SpatialRelation::vertically_aligned:
    case SpatialRelation::coplanar:
      return true;
    default:
      return false;
  }
}

bool needs_viewpoint(SpatialRelation relation) {
  return relation == SpatialRelation::left_of || relation == SpatialRelation::right_of ||
         relation == SpatialRelation::in_front_of || relation == SpatialRelation::behind;
}

RelationBody face_body(const Scene& scene, const FaceAddress& address,
                       const RelationTolerances& tolerances) {
  RelationBody body;
  const Instance& instance = scene.instances[static_cast<std::size_t>(address.instance)];
  const Part& part = instance.parts[static_cast<std::size_t>(address.part)];
  const Eigen::Isometry3d T = instance.T_world_instance * part.T_instance_part;
  body.face = world_face(scene, address);
  body.has_face = part.faces[static_cast<std::size_t>(address.face)].planar;
  body.center = body.face.center;
  OrientedBox flat;
  flat.center = body.face.center;
  flat.axes.col(0) = body.face.axis;
  flat.axes.col(1) = body.face.normal.cross(body.face.axis);
  flat.axes.col(2) = body.face.normal;
  flat.half = {0.5 * body.face.size.x(), 0.5 * body.face.size.y(), 0.0};
  body.boxes.push_back(flat);
  Ring2 points;
  body.z_low = std::numeric_limits<double>::infinity();
  body.z_high = -body.z_low;
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    if (part.triangle_face[t] != address.face) continue;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = T * part.vertices[static_cast<std::size_t>(part.triangles[t][k])];
      points.push_back(p.head<2>());
      body.z_low = std::min(body.z_low, p.z());
      body.z_high = std::max(body.z_high, p.z());
    }
  }
  body.footprint = convex_hull(std::move(points));
  const bool upright =
      std::abs(body.face.normal.z()) < portable_sincos(radians(tolerances.angle_deg)).sin;
  if (upright) body.footprint = dilated(body.footprint, tolerances.upright_footprint);
  if (body.face.normal.z() >= portable_sincos(radians(tolerances.angle_deg)).cos)
    body.level_faces.push_back(body.face);
  return body;
}

RelationBody instance_body(const Scene& scene, std::size_t index,
                           const RelationTolerances& tolerances) {
  RelationBody body;
  const Instance& instance = scene.instances[index];
  body.boxes = part_boxes(instance);
  const Eigen::AlignedBox3d bounds = world_bounds(instance);
  body.center = bounds.center();
  body.z_low = bounds.min().z();
  body.z_high = bounds.max().z();
  Ring2 points;
  double largest = 0.0;
  const double cos_level = portable_sincos(radians(tolerances.angle_deg)).cos;
  for (std::size_t p = 0; p < instance.parts.size(); ++p) {
    const Part& part = instance.parts[p];
    const Eigen::Isometry3d T = instance.T_world_instance * part.T_instance_part;
    for (const auto& v : part.vertices) points.push_back((T * v).head<2>());
    for (std::size_t f = 0; f < part.faces.size(); ++f) {
      if (!part.faces[f].planar) continue;
      const WorldFace face =
          world_face(scene, {static_cast<std::int32_t>(index), static_cast<std::int32_t>(p),
                             static_cast<std::int32_t>(f)});
      if (face.area > largest) {
        largest = face.area;
        body.face = face;
        body.has_face = true;
      }
      if (face.normal.z() >= cos_level && face.size.y() > 0.05) body.level_faces.push_back(face);
    }
  }
  body.footprint = convex_hull(std::move(points));
  if (area_of(body.footprint) < 1e-4)
    body.footprint = dilated(body.footprint, tolerances.upright_footprint);
  return body;
}

RelationMargin relate(const RelationBody& a, const RelationBody& b, SpatialRelation relation,
                      const Eigen::Vector3d& viewpoint, const RelationTolerances& t) {
  const bool faces = a.has_face && b.has_face;
  Worst worst;
  switch (relation) {
    case SpatialRelation::parallel:
      if (!faces) return {};
      worst.at_most(angle_deg(a.face.normal, b.face.normal), t.angle_deg);
      return worst.result;
    case SpatialRelation::orthogonal:
      if (!faces) return {};
      worst.at_most(90.0 - angle_deg(a.face.normal, b.face.normal), t.angle_deg);
      return worst.result;
    case SpatialRelation::above:
      return above_margin(a, b, t);
    case SpatialRelation::below:
      return above_margin(b, a, t);
    case SpatialRelation::on:
      return on_margin(a, b, t);
    case SpatialRelation::supports:
      return on_margin(b, a, t);
    case SpatialRelation::inside:
      return inside_margin(a, b, t);
    case SpatialRelation::near:
      worst.at_most(gap_between(a, b), t.near);
      return worst.result;
    case SpatialRelation::same_size: {
      if (!faces || a.face.size.x() <= 0 || b.face.size.x() <= 0) return {};
      const double length =
          std::max(a.face.size.x(), b.face.size.x()) / std::min(a.face.size.x(), b.face.size.x());
      const double area =
          std::max(a.face.area, b.face.area) / std::max(1e-12, std::min(a.face.area, b.face.area));
      worst.condition(1.0 - std::log(length) / std::log(t.same_length), length);
      worst.condition(1.0 - std::log(area) / std::log(t.same_area), area);
      return worst.result;
    }
    case SpatialRelation::vertically_aligned: {
      if (!faces) return {};
      const double shorter = std::min(a.face.size.x(), b.face.size.x());
      if (shorter <= 0) return {};
      worst.at_most((a.face.center - b.face.center).head<2>().norm() / shorter, t.aligned);
      if (a.face.size.x() > t.elongated * a.face.size.y() &&
          b.face.size.x() > t.elongated * b.face.size.y()) {
        worst.at_most(angle_deg(a.face.axis, b.face.axis), t.angle_deg);
      }
      return worst.result;
    }
    case SpatialRelation::coplanar: {
      if (!faces) return {};
      worst.at_most(angle_deg(a.face.normal, b.face.normal), t.angle_deg);
      const Eigen::Vector3d d = a.face.center - b.face.center;
      worst.at_most(std::max(std::abs(a.face.normal.dot(d)), std::abs(b.face.normal.dot(d))),
                    t.coplanar);
      return worst.result;
    }
    default:
      return view_margin(a, b, relation, viewpoint, t);
  }
}

namespace {

Eigen::Vector3d viewpoint_of(const Scene& scene, const RelationQuery& query) {
  if (query.viewpoint) return *query.viewpoint;
  if (!scene.sensor_poses.empty()) return scene.sensor_poses.front().translation();
  return scene.bounds.isEmpty() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(scene.bounds.center());
}

std::vector<RelationFact> relations_between(const std::vector<RelationBody>& bodies,
                                            const std::vector<std::int32_t>& ids,
                                            const RelationQuery& query,
                                            const Eigen::Vector3d& viewpoint) {
  std::vector<SpatialRelation> wanted = query.relations;
  if (wanted.empty()) {
    for (std::size_t r = 0; r < relation_count; ++r)
      wanted.push_back(static_cast<SpatialRelation>(r));
  }
  std::vector<RelationFact> facts;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = 0; j < bodies.size(); ++j) {
      if (i == j) continue;
      for (const SpatialRelation relation : wanted) {
        if (is_symmetric(relation) && j < i) continue;
        const RelationMargin value =
            relate(bodies[i], bodies[j], relation, viewpoint, query.tolerances);
        if (value.margin >= query.least_margin) facts.push_back({relation, ids[i], ids[j], value});
      }
    }
  }
  // Of all that could carry a thing, the highest does: a book on a shelf board is not on the board
  // below.
  std::vector<double> height_of(facts.size(), 0.0);
  const auto body_of = [&](std::int32_t id) -> const RelationBody& {
    return bodies[static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) -
                                           ids.begin())];
  };
  const auto carrier_height = [&](const RelationBody& a, const RelationBody& b) {
    double best = -std::numeric_limits<double>::infinity();
    for (const auto& face : b.level_faces) {
      const double gap = a.z_low - face.center.z();
      if (gap >= query.tolerances.on_low && gap <= query.tolerances.on_high)
        best = std::max(best, face.center.z());
    }
    return best;
  };
  std::vector<std::pair<std::int32_t, double>> top;  // thing -> highest carrier
  for (std::size_t k = 0; k < facts.size(); ++k) {
    const RelationFact& f = facts[k];
    if (f.relation != SpatialRelation::on && f.relation != SpatialRelation::supports) continue;
    const std::int32_t thing = f.relation == SpatialRelation::on ? f.a : f.b;
    const std::int32_t carrier = f.relation == SpatialRelation::on ? f.b : f.a;
    height_of[k] = carrier_height(body_of(thing), body_of(carrier));
    if (!f.value.holds()) continue;
    const auto found =
        std::find_if(top.begin(), top.end(), [&](const auto& item) { return item.first == thing; });
    if (found == top.end()) {
      top.emplace_back(thing, height_of[k]);
    } else {
      found->second = std::max(found->second, height_of[k]);
    }
  }
  std::vector<RelationFact> kept;
  for (std::size_t k = 0; k < facts.size(); ++k) {
    const RelationFact& f = facts[k];
    if ((f.relation == SpatialRelation::on || f.relation == SpatialRelation::supports) &&
        f.value.holds()) {
      const std::int32_t thing = f.relation == SpatialRelation::on ? f.a : f.b;
      const auto found = std::find_if(top.begin(), top.end(),
                                      [&](const auto& item) { return item.first == thing; });
      if (found != top.end() && height_of[k] < found->second) continue;
    }
    kept.push_back(f);
  }
  return kept;
}

}  // namespace

std::vector<RelationFact> face_relations(const Scene& scene, const RelationQuery& query) {
  std::vector<RelationBody> bodies;
  std::vector<std::int32_t> ids;
  const auto faces = all_faces(scene);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face& face = scene.instances[static_cast<std::size_t>(faces[f].instance)]
                           .parts[static_cast<std::size_t>(faces[f].part)]
                           .faces[static_cast<std::size_t>(faces[f].face)];
    if (!face.planar || face.area < query.least_area) continue;
    bodies.push_back(face_body(scene, faces[f], query.tolerances));
    ids.push_back(static_cast<std::int32_t>(f));
  }
  return relations_between(bodies, ids, query, viewpoint_of(scene, query));
}

std::vector<RelationFact> instance_relations(const Scene& scene, const RelationQuery& query) {
  std::vector<RelationBody> bodies;
  std::vector<std::int32_t> ids;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    bodies.push_back(instance_body(scene, i, query.tolerances));
    ids.push_back(static_cast<std::int32_t>(i));
  }
  return relations_between(bodies, ids, query, viewpoint_of(scene, query));
}

std::vector<std::int32_t> coplanar_groups(const Scene& scene, double gap, double distance,
                                          double angle) {
  const auto faces = all_faces(scene);
  std::vector<RelationBody> bodies(faces.size());
  std::vector<bool> planar(faces.size());
  std::vector<std::int32_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Part& part = scene.instances[static_cast<std::size_t>(faces[f].instance)]
                           .parts[static_cast<std::size_t>(faces[f].part)];
    planar[f] = part.faces[static_cast<std::size_t>(faces[f].face)].planar &&
                part.faces[static_cast<std::size_t>(faces[f].face)].area > 0;
    if (planar[f]) bodies[f] = face_body(scene, faces[f]);
  }
  const auto root = [&](std::int32_t i) {
    while (parent[static_cast<std::size_t>(i)] != i) i = parent[static_cast<std::size_t>(i)];
    return i;
  };
  const double cos_angle = portable_sincos(radians(angle)).cos;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!planar[i]) continue;
    const Eigen::AlignedBox3d outer = bounds_of(bodies[i].boxes[0]);
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      if (!planar[j] || bodies[i].face.normal.dot(bodies[j].face.normal) < cos_angle) continue;
      const Eigen::Vector3d d = bodies[i].face.center - bodies[j].face.center;
      if (std::abs(bodies[i].face.normal.dot(d)) > distance ||
          std::abs(bodies[j].face.normal.dot(d)) > distance)
        continue;
      if (outer.exteriorDistance(bounds_of(bodies[j].boxes[0])) > gap) continue;
      if (box_distance(bodies[i].boxes[0], bodies[j].boxes[0]) > gap) continue;
      const auto a = root(static_cast<std::int32_t>(i));
      const auto b = root(static_cast<std::int32_t>(j));
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<std::int32_t> group(faces.size(), -1);
  std::vector<std::int32_t> number(faces.size(), -1);
  std::int32_t next = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!planar[f]) continue;
    auto& n = number[static_cast<std::size_t>(root(static_cast<std::int32_t>(f)))];
    if (n < 0) n = next++;
    group[f] = n;
  }
  return group;
}

}  // namespace scanchor
