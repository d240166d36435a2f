#include "scenes/relations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math.hpp"
#include "core/polygons.hpp"
#include "scenes/box_distance.hpp"
#include "scenes/truth.hpp"

namespace scanchor {
namespace {

constexpr std::array<std::string_view, relation_count> relation_names = {
    "parallel", "orthogonal", "above",    "below",       "on",
    "supports", "inside",     "near",     "same size",   "vertically aligned",
    "coplanar", "left of",    "right of", "in front of", "behind"};

/// Distance of the nearest two boxes; what is farther than `enough` need not be exact.
double gap_between(const RelationBody& a, const RelationBody& b, double enough) {
  const double around_all = a.bounds.exteriorDistance(b.bounds);
  if (around_all > enough) return around_all;
  // Nearest bounds first: most pairs are then out of the question.
  struct Pair {
    double least;
    std::size_t first, second;
  };
  std::vector<Pair> pairs;
  std::vector<Eigen::AlignedBox3d> around_b;
  for (const auto& box : b.boxes) around_b.push_back(bounds_of(box));
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    const Eigen::AlignedBox3d around = bounds_of(a.boxes[i]);
    for (std::size_t k = 0; k < b.boxes.size(); ++k) {
      const double least = around.exteriorDistance(around_b[k]);
      if (least <= enough) pairs.push_back({least, i, k});
    }
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair& p, const Pair& q) { return p.least < q.least; });
  double best = std::numeric_limits<double>::infinity();
  for (const Pair& pair : pairs) {
    if (pair.least >= best) break;
    best = std::min(best, box_distance(a.boxes[pair.first], b.boxes[pair.second]));
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
                            const RelationTolerances& t, double least) {
  Worst worst;
  const double gap = a.z_low - b.z_high;
  worst.condition((gap + t.above_gap) / t.above_gap, gap);
  // Without this, two faces of one board would be above each other.
  const double rise = a.center.z() - b.center.z();
  worst.condition(rise > 0 ? std::max(rise / t.above_gap, 1e-9) : rise / t.above_gap - 1e-9, rise);
  if (worst.result.margin < least) return worst.result;
  const double share = overlap_share(a.footprint, b.grown);
  worst.condition((share - t.overlap) / (1.0 - t.overlap), share);
  worst.result.margin = std::min(worst.result.margin, 1.0);
  return worst.result;
}

RelationMargin on_margin(const RelationBody& a, const RelationBody& b, const RelationTolerances& t,
                         double least) {
  RelationMargin best{-1e9, 0.0};
  for (std::size_t i = 0; i < b.level_faces.size(); ++i) {
    const WorldFace& face = b.level_faces[i];
    Worst worst;
    const double gap = a.z_low - face.center.z();
    const double middle = 0.5 * (t.on_low + t.on_high);
    const double reach = 0.5 * (t.on_high - t.on_low);
    worst.condition((reach - std::abs(gap - middle)) / reach, gap);
    // A thing is not on what it is higher than only by its foot: its middle lies above the face.
    worst.condition(a.center.z() > face.center.z() ? 1.0 : -1.0, gap);
    if (worst.result.margin < std::max(least, best.margin)) continue;
    const double share = overlap_share(a.footprint, b.level_shadows[i]);
    worst.condition((share - t.overlap) / (1.0 - t.overlap), share);
    if (worst.result.margin > best.margin) best = worst.result;
  }
  return best;
}

RelationMargin inside_margin(const RelationBody& a, const RelationBody& b,
                             const RelationTolerances& t, double least) {
  const double height = std::max(1e-3, a.z_high - a.z_low);
  const double within = std::max(0.0, std::min(a.z_high, b.z_high + t.footprint_dilation) -
                                          std::max(a.z_low, b.z_low - t.footprint_dilation));
  const double most = std::min(1.0, within / height);
  if ((most - t.inside_share) / (1.0 - t.inside_share) < least) return {-1e9, most};
  const double share = most * overlap_share(a.footprint, b.grown);
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
                           const Eigen::Vector3d& viewpoint, const RelationTolerances& t,
                           double least) {
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
  // Behind the cone's back: 90 degrees off or more.
  if (wanted.dot(d) <= 0 && (t.cone_deg - 90.0) / t.cone_deg < least) return {-1e9, 180.0};
  const double off = degrees(std::atan2(std::abs(cross2(wanted, d)), wanted.dot(d)));
  return {(t.cone_deg - off) / t.cone_deg, off};
}

}  // namespace

std::string_view relation_name(SpatialRelation relation) {
  return relation_names[static_cast<std::size_t>(relation)];
}

std::optional<SpatialRelation> find_relation(std::string_view name) {
  for (std::size_t i = 0; i < relation_names.size(); ++i) {
    if (relation_names[i] == name) return static_cast<SpatialRelation>(i);
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

RelationMargin relate(const RelationBody& a, const RelationBody& b, SpatialRelation relation,
                      const Eigen::Vector3d& viewpoint, const RelationTolerances& t, double least) {
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
      return above_margin(a, b, t, least);
    case SpatialRelation::below:
      return above_margin(b, a, t, least);
    case SpatialRelation::on:
      return on_margin(a, b, t, least);
    case SpatialRelation::supports:
      return on_margin(b, a, t, least);
    case SpatialRelation::inside:
      return inside_margin(a, b, t, least);
    case SpatialRelation::near:
      worst.at_most(gap_between(a, b, t.near * (1.0 - least)), t.near);
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
      // One over the other: two faces in one place are not.
      const double rise = std::abs(a.center.z() - b.center.z());
      worst.condition((rise - t.stacked) / t.stacked, rise);
      worst.result.margin = std::min(worst.result.margin, 1.0);
      return worst.result;
    }
    case SpatialRelation::coplanar: {
      if (!faces) return {};
      worst.at_most(angle_deg(a.face.normal, b.face.normal), t.angle_deg);
      const Eigen::Vector3d d = a.face.center - b.face.center;
      // The larger one carries the plane: where that of a small patch goes far away depends on a
      // hair.
      const double from_a = std::abs(a.face.normal.dot(d)), from_b = std::abs(b.face.normal.dot(d));
      const double more = a.face.area - b.face.area;
      worst.at_most(std::abs(more) < 1e-6 ? std::min(from_a, from_b)  // of one make
                    : more > 0.0          ? from_a
                                          : from_b,
                    t.coplanar);
      return worst.result;
    }
    default:
      return view_margin(a, b, relation, viewpoint, t, least);
  }
}

}  // namespace scanchor
