#include "reasoning/item.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "reasoning/likelihood.hpp"
#include "reasoning/plane_error.hpp"

namespace scanchor {

namespace {

constexpr double footprint_margin =
    0.025;  // [m] two of them make the 5 cm by which reasoning.md 2.3 widens

Footprint make_footprint(const Eigen::Vector3d& center, const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b) {
  Footprint foot;
  foot.center = center.head<2>();
  Eigen::Vector2d u = a.head<2>();
  Eigen::Vector2d v = b.head<2>();
  if (u.squaredNorm() < v.squaredNorm()) std::swap(u, v);
  const Eigen::Vector2d direction =
      u.norm() > 1e-6 ? Eigen::Vector2d(u.normalized()) : Eigen::Vector2d::UnitX();
  const Eigen::Vector2d side(-direction.y(), direction.x());
  // A side that is nearly in the direction of the other one adds to its length; what is left is the
  // thickness.
  const double thickness = std::abs(side.dot(v));
  foot.u = direction * (u.norm() + footprint_margin);
  if (thickness < footprint_margin) {
    foot.u += direction * std::abs(direction.dot(v));
    foot.v = side * (thickness + footprint_margin);
  } else {
    foot.v = v * ((thickness + footprint_margin) / thickness);
  }
  return foot;
}

Quantity quantity(const Measured& measured, double fallback_sigma, double hidden) {
  Quantity q;
  q.value = measured.value;
  // A 95 % interval is 2 x 1.96 standard deviations wide. The longer half of a lopsided one stands
  // for another reading, a shadow or a neighbour's points: this thing ends where its points do.
  const double half = std::min(measured.value - measured.low, measured.high - measured.value);
  q.sigma = half > 0.0 ? half / 1.96 : fallback_sigma;
  q.hidden = measured.at_least ? hidden : 0.0;
  return q;
}

/// Item::open of a surface; `x`, `y`: the rectangle's sides in the surface's frame.
std::array<double, 4> open_sides(const Surface& surface, const Eigen::Vector2d& x,
                                 const Eigen::Vector2d& y) {
  std::array<double, 4> hidden = {}, all = {};
  for (const auto& polygon : surface.polygons) {
    const auto& ring = polygon.outer;
    if (polygon.outer_kind.size() != ring.size()) continue;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector2d d = ring[(i + 1) % ring.size()] - ring[i];
      const Eigen::Vector2d outwards(d.y(), -d.x());  // of a counter-clockwise ring
      const bool ends = polygon.outer_kind[i] == EdgeKind::true_edge;
      const std::array<double, 4> faces = {outwards.dot(x), -outwards.dot(x), outwards.dot(y),
                                           -outwards.dot(y)};
      for (std::size_t k = 0; k < 4; ++k) {
        // Steps along the side count where they face it, not where they run past it.
        const double part = std::max(0.0, faces[k] - 0.5 * outwards.norm());
        all[k] += part;
        if (!ends) hidden[k] += part;
      }
    }
  }
  for (std::size_t k = 0; k < 4; ++k)
    hidden[k] = all[k] > 0.0 ? hidden[k] / all[k] : surface.occluded_outline;
  return hidden;
}

void finish(Item& item) {
  item.footprint =
      make_footprint(item.center, item.along * item.half_length, item.across * item.half_width);
}

}  // namespace

double Footprint::area() const { return 4.0 * std::abs(u.x() * v.y() - u.y() * v.x()); }

double tilt_sigma_of(const Eigen::Matrix3d& normal_covariance) {
  return std::sqrt(std::max(0.0, 0.5 * normal_covariance.trace()));
}

Eigen::Matrix3d levelling(const Eigen::Vector3d& up) {
  // Eigen's FromTwoVectors with the one case spelt out that it needs a singular value decomposition
  // for: that template is two thirds of the time to build this file.
  const Eigen::Vector3d from = up.normalized();
  const double cosine = from.z();
  if (cosine < -1.0 + 1e-12) return Eigen::DiagonalMatrix<double, 3>(1.0, -1.0, -1.0);
  const double s = std::sqrt((1.0 + cosine) * 2.0);
  const Eigen::Vector3d axis = from.cross(Eigen::Vector3d::UnitZ()) * (1.0 / s);
  return Eigen::Quaterniond(0.5 * s, axis.x(), axis.y(), axis.z()).toRotationMatrix();
}

bool same_geometry(const Item& a, const Item& b) {
  const auto same = [](const Quantity& x, const Quantity& y) {
    return x.value == y.value && x.sigma == y.sigma && x.hidden == y.hidden;
  };
  return a.group == b.group && a.has_shape == b.has_shape && a.center == b.center &&
         a.centroid == b.centroid && a.normal == b.normal &&
         a.normal_covariance == b.normal_covariance && a.offset_sigma == b.offset_sigma &&
         a.along == b.along && a.across == b.across && a.half_length == b.half_length &&
         a.half_width == b.half_width && same(a.area, b.area) && same(a.extension, b.extension) &&
         same(a.width, b.width) && same(a.height, b.height) && a.open == b.open &&
         a.edge_sigma == b.edge_sigma && same(a.rectangularness, b.rectangularness) &&
         a.z_low == b.z_low && a.z_high == b.z_high && a.z == b.z && a.z_sigma == b.z_sigma &&
         a.box.min() == b.box.min() && a.box.max() == b.box.max() && a.members == b.members;
}

std::vector<std::int32_t> first_of_twins(const std::vector<Item>& items) {
  std::vector<std::int32_t> order(items.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::int32_t i) {
    const Item& item = items[i];
    return std::make_tuple(item.center.x(), item.center.y(), item.center.z(), item.area.value);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return key(a) < key(b); });
  std::vector<std::int32_t> first(items.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && !(key(order[begin]) < key(order[end]))) ++end;
    // Of one middle and area there are hardly ever two that differ otherwise.
    std::vector<std::int32_t> kinds;
    for (std::size_t i = begin; i < end; ++i) {
      const auto twin = std::find_if(kinds.begin(), kinds.end(), [&](std::int32_t k) {
        return same_geometry(items[k], items[order[i]]);
      });
      first[order[i]] = twin != kinds.end() ? *twin : order[i];
      if (twin == kinds.end()) kinds.push_back(order[i]);
    }
    begin = end;
  }
  return first;
}

std::vector<Item> make_items(const Surfaces& surfaces, const Eigen::Matrix3d& R) {
  std::vector<Item> items;
  items.reserve(surfaces.surfaces.size());
  for (const auto& surface : surfaces.surfaces) {
    Item item;
    item.id = static_cast<std::int32_t>(items.size());
    const auto& plane = surface.plane;
    const auto& rectangle = surface.rectangle;
    item.normal = R * plane.normal;
    item.normal_covariance = R * plane_error(surface, surfaces) * R.transpose();
    item.tilt_sigma = tilt_sigma_of(item.normal_covariance);
    item.offset_sigma = plane.centroid_sigma;
    item.centroid = R * plane.centroid;
    const double hidden = std::clamp(surface.occluded_outline, 0.05, 0.95);
    const double edge = std::max(0.005, 0.5 * surfaces.point_spacing);
    item.extension = quantity(rectangle.length, edge, hidden);
    item.width = quantity(rectangle.width, edge, hidden);
    item.edge_sigma = std::max(item.extension.sigma, item.width.sigma);
    item.area =
        quantity(surface.area, edge * (rectangle.length.value + rectangle.width.value), hidden);
    item.has_shape = rectangle.length.value > 0.0 && surface.area.value > 0.0;
    item.rectangularness.value = surface.rectangularness;
    // Of the ratio of two areas that share their outline: half of the area's relative deviation
    // remains.
    item.rectangularness.sigma = item.has_shape ? 0.5 * item.area.sigma / item.area.value : 1.0;
    item.rectangularness.hidden = item.area.hidden;
    const double c = std::cos(rectangle.angle);
    const double s = std::sin(rectangle.angle);
    const Eigen::Matrix3d axes = R * surface.T_cloud_surface.linear();
    item.open = open_sides(surface, {c, s}, {-s, c});
    item.along = axes * Eigen::Vector3d(c, s, 0.0);
    item.across = axes * Eigen::Vector3d(-s, c, 0.0);
    item.center = R * (surface.T_cloud_surface *
                       Eigen::Vector3d(rectangle.center.x(), rectangle.center.y(), 0.0));
    item.half_length = 0.5 * rectangle.length.value;
    item.half_width = 0.5 * rectangle.width.value;
    // The lower and upper end come from the outline itself where it is known: a rectangle on its
    // corner would overstate them.
    for (const auto& polygon : surface.polygons) {
      for (const auto& p : polygon.outer) {
        item.box.extend(R * (surface.T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0)));
      }
    }
    const auto extend_by_rectangle = [&] {
      for (const double a : {-1.0, 1.0}) {
        for (const double b : {-1.0, 1.0}) {
          item.box.extend(item.center + a * item.half_length * item.along +
                          b * item.half_width * item.across);
        }
      }
    };
    if (item.box.isEmpty()) extend_by_rectangle();
    item.z_low = item.box.min().z();
    item.z_high = item.box.max().z();
    item.z = item.center.z();
    // From here on the box holds the whole rectangle, so that it bounds every distance from below.
    extend_by_rectangle();
    item.z_sigma = std::sqrt(sqr(item.offset_sigma) + sqr(item.along.z() * item.extension.sigma) +
                             sqr(item.across.z() * item.width.sigma));
    item.height = {item.z_high - item.z_low, std::max(item.z_sigma, 0.5 * edge),
                   item.extension.hidden > 0.0 || item.width.hidden > 0.0 ? hidden : 0.0};
    finish(item);
    items.push_back(std::move(item));
  }
  return items;
}

Item make_group(const std::vector<Item>& items, std::vector<std::int32_t> members,
                std::int32_t id) {
  std::sort(members.begin(), members.end(), [&](std::int32_t a, std::int32_t b) {
    return items[a].z != items[b].z ? items[a].z < items[b].z : a < b;
  });
  const std::int32_t main =
      *std::max_element(members.begin(), members.end(), [&](std::int32_t a, std::int32_t b) {
        return items[a].area.value != items[b].area.value
                   ? items[a].area.value < items[b].area.value
                   : a > b;
      });
  Item group;
  group.id = id;
  group.group = true;
  group.normal = items[main].normal;
  group.normal_covariance = items[main].normal_covariance;
  group.tilt_sigma = items[main].tilt_sigma;
  // Sides of the box: the horizontal direction of the main member's longer side, of its shorter
  // one where it stands upright, and the one across.
  Eigen::Vector3d along = items[main].along;
  along.z() = 0.0;
  if (along.norm() < 0.3) {
    along = items[main].across;
    along.z() = 0.0;
  }
  along.normalize();
  const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
  double low_a = 1e300, high_a = -1e300, low_b = 1e300, high_b = -1e300;
  for (const auto m : members) {
    const auto& item = items[m];
    group.box.extend(item.box);
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-1.0, 1.0}) {
        const Eigen::Vector3d corner =
            item.center + a * item.half_length * item.along + b * item.half_width * item.across;
        low_a = std::min(low_a, along.dot(corner));
        high_a = std::max(high_a, along.dot(corner));
        low_b = std::min(low_b, across.dot(corner));
        high_b = std::max(high_b, across.dot(corner));
      }
    }
    group.area.value += item.area.value;
    group.area.sigma = std::hypot(group.area.sigma, item.area.sigma);
    group.area.hidden = std::max(group.area.hidden, item.area.hidden);
    group.edge_sigma = std::max(group.edge_sigma, item.edge_sigma);
    group.extension.sigma = std::max(group.extension.sigma, item.extension.sigma);
    group.width.sigma = std::max(group.width.sigma, item.width.sigma);
    group.extension.hidden = std::max(group.extension.hidden, item.extension.hidden);
    group.width.hidden = std::max(group.width.hidden, item.width.hidden);
    group.offset_sigma = std::max(group.offset_sigma, item.offset_sigma);
    group.z_sigma = std::max(group.z_sigma, item.z_sigma);
    group.has_shape = group.has_shape && item.has_shape;
  }
  group.z_low = INFINITY;
  group.z_high = -INFINITY;
  for (const auto m : members) {
    group.z_low = std::min(group.z_low, items[m].z_low);
    group.z_high = std::max(group.z_high, items[m].z_high);
  }
  group.z = 0.5 * (group.z_low + group.z_high);
  group.center = along * (0.5 * (low_a + high_a)) + across * (0.5 * (low_b + high_b)) +
                 Eigen::Vector3d::UnitZ() * group.z;
  group.centroid = group.center;
  group.along = along;
  group.across = across;
  group.half_length = 0.5 * (high_a - low_a);
  group.half_width = 0.5 * (high_b - low_b);
  if (group.half_length < group.half_width) {
    std::swap(group.half_length, group.half_width);
    std::swap(group.along, group.across);
  }
  group.extension.value = 2.0 * group.half_length;
  group.width.value = 2.0 * group.half_width;
  group.height = {group.z_high - group.z_low, std::max(group.z_sigma, 0.005), group.width.hidden};
  group.rectangularness = {1.0, 0.0, 0.0};
  group.members = std::move(members);
  finish(group);
  return group;
}

}  // namespace scanchor
