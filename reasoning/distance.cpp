#include <algorithm>
#include <array>
#include <cmath>

#include "reasoning/relation.hpp"

namespace scanchor {

namespace {

using Quad = std::array<Eigen::Vector3d, 4>;

Quad corners(const Item& item) {
  const Eigen::Vector3d u = item.along * item.half_length;
  const Eigen::Vector3d v = item.across * item.half_width;
  return {item.center - u - v, item.center + u - v, item.center + u + v, item.center - u + v};
}

/// Shortest step from the first segment to the second; Ericson, Real-Time Collision Detection,
/// 5.1.9.
Eigen::Vector3d segment_segment(const Eigen::Vector3d& p1, const Eigen::Vector3d& q1,
                                const Eigen::Vector3d& p2, const Eigen::Vector3d& q2) {
  const Eigen::Vector3d d1 = q1 - p1;
  const Eigen::Vector3d d2 = q2 - p2;
  const Eigen::Vector3d r = p1 - p2;
  const double a = d1.squaredNorm();
  const double e = d2.squaredNorm();
  const double f = d2.dot(r);
  double s = 0.0;
  double t = 0.0;
  if (a <= 1e-18 && e <= 1e-18) return -r;
  if (a <= 1e-18) {
    t = std::clamp(f / e, 0.0, 1.0);
  } else {
    const double c = d1.dot(r);
    if (e <= 1e-18) {
      s = std::clamp(-c / a, 0.0, 1.0);
    } else {
      const double b = d1.dot(d2);
      const double denominator = a * e - b * b;
      if (denominator > 1e-18) s = std::clamp((b * f - c * e) / denominator, 0.0, 1.0);
      t = (b * s + f) / e;
      if (t < 0.0 || t > 1.0) {
        t = std::clamp(t, 0.0, 1.0);
        s = std::clamp((b * t - c) / a, 0.0, 1.0);
      }
    }
  }
  return p2 + d2 * t - p1 - d1 * s;
}

/// A rectangle with what each distance from it needs.
struct Face {
  const Item& item;
  Quad corner;
  Eigen::Vector3d normal;
  std::array<Eigen::Vector3d, 4> middle;  // of side i, from corner i to the next
  std::array<double, 4> half;             // its half length
};

Face face_of(const Item& item) {
  Face face{item, corners(item), item.along.cross(item.across), {}, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    face.middle[i] = 0.5 * (face.corner[i] + face.corner[(i + 1) % 4]);
    face.half[i] = i % 2 == 0 ? item.half_length : item.half_width;
  }
  return face;
}

bool holds(const Item& face, const Eigen::Vector3d& from_middle) {
  return std::abs(from_middle.dot(face.along)) <= face.half_length &&
         std::abs(from_middle.dot(face.across)) <= face.half_width;
}

/// Heights of another one's corners over the plane of a face.
std::array<double, 4> heights_over(const Face& face, const Quad& corner) {
  std::array<double, 4> heights;
  for (std::size_t i = 0; i < 4; ++i) heights[i] = face.normal.dot(corner[i] - face.item.center);
  return heights;
}

/// True if the side i of a rectangle with these heights runs through the face.
bool pierces(const Quad& corner, const std::array<double, 4>& heights, std::size_t i,
             const Face& face) {
  const std::size_t next = (i + 1) % 4;
  const double a = heights[i], b = heights[next];
  if (a * b > 0.0 || a == b) return false;
  const Eigen::Vector3d at = corner[i] + (corner[next] - corner[i]) * (a / (a - b));
  return holds(face.item, at - face.item.center);
}

Eigen::Vector3d rectangles(const Item& a, const Item& b) {
  const Face fa = face_of(a), fb = face_of(b);
  const auto a_over_b = heights_over(fb, fa.corner), b_over_a = heights_over(fa, fb.corner);
  Eigen::Vector3d best = Eigen::Vector3d::Constant(INFINITY);
  double least = INFINITY;
  const auto offer = [&](const Eigen::Vector3d& step) {
    const double length = step.squaredNorm();
    if (length < least) best = step, least = length;
  };
  // Corners over the other face; where they are not, the sides answer for them.
  for (std::size_t i = 0; i < 4; ++i) {
    if (pierces(fa.corner, a_over_b, i, fb) || pierces(fb.corner, b_over_a, i, fa))
      return Eigen::Vector3d::Zero();
    if (holds(b, fa.corner[i] - b.center)) offer(-fb.normal * a_over_b[i]);
    if (holds(a, fb.corner[i] - a.center)) offer(fa.normal * b_over_a[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      // Sides whose middles are far apart come no nearer than that less their halves.
      const double halves = fa.half[i] + fb.half[j];
      const double apart = (fa.middle[i] - fb.middle[j]).squaredNorm();
      if (apart > halves * halves && std::sqrt(apart) - halves > std::sqrt(least)) continue;
      offer(segment_segment(fa.corner[i], fa.corner[(i + 1) % 4], fb.corner[j],
                            fb.corner[(j + 1) % 4]));
    }
  }
  return best;
}

using Polygon2 = std::array<Eigen::Vector2d, 12>;

std::array<Eigen::Vector2d, 4> footprint_corners(const Footprint& f) {
  std::array<Eigen::Vector2d, 4> c = {f.center - f.u - f.v, f.center + f.u - f.v,
                                      f.center + f.u + f.v, f.center - f.u + f.v};
  if (f.u.x() * f.v.y() - f.u.y() * f.v.x() < 0.0) std::swap(c[1], c[3]);  // counter-clockwise
  return c;
}

double footprint_gap(const Footprint& a, const Footprint& b) {
  if (footprint_overlap(a, b) > 0.0) return 0.0;
  const auto ca = footprint_corners(a);
  const auto cb = footprint_corners(b);
  const auto lift = [](const Eigen::Vector2d& p) { return Eigen::Vector3d(p.x(), p.y(), 0.0); };
  double best = INFINITY;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      best = std::min(best, segment_segment(lift(ca[i]), lift(ca[(i + 1) % 4]), lift(cb[j]),
                                            lift(cb[(j + 1) % 4]))
                                .squaredNorm());
    }
  }
  return std::sqrt(best);
}

}  // namespace

Eigen::Vector3d nearest_step(const Item& a, const Item& b) { return rectangles(a, b); }

double gap_distance(const Item& a, const Item& b) {
  if (!a.group && !b.group) return rectangles(a, b).norm();
  const double flat = footprint_gap(a.footprint, b.footprint);
  const double heights = std::max({0.0, a.z_low - b.z_high, b.z_low - a.z_high});
  return std::hypot(flat, heights);
}

double footprint_overlap(const Footprint& a, const Footprint& b) {
  const double reach = a.u.norm() + a.v.norm() + b.u.norm() + b.v.norm();
  if ((a.center - b.center).squaredNorm() > reach * reach) return 0.0;
  // Sutherland-Hodgman: the footprint of a is cut by the four sides of b.
  const auto ca = footprint_corners(a);
  const auto cb = footprint_corners(b);
  Polygon2 polygon;
  Polygon2 next;
  int count = 4;
  std::copy(ca.begin(), ca.end(), polygon.begin());
  for (int side = 0; side < 4 && count > 0; ++side) {
    const Eigen::Vector2d p = cb[side];
    const Eigen::Vector2d d = cb[(side + 1) % 4] - p;
    const auto inside = [&](const Eigen::Vector2d& q) {
      return d.x() * (q.y() - p.y()) - d.y() * (q.x() - p.x());
    };
    int kept = 0;
    double here = inside(polygon[0]);
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d& from = polygon[i];
      const Eigen::Vector2d& to = polygon[(i + 1) % count];
      const double there = inside(to);
      if (here >= 0.0) next[kept++] = from;
      if ((here >= 0.0) != (there >= 0.0))
        next[kept++] = from + (to - from) * (here / (here - there));
      here = there;
    }
    count = kept;
    polygon = next;
  }
  double twice = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % count];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  const double smaller = std::min(a.area(), b.area());
  return smaller > 0.0 ? std::clamp(0.5 * twice / smaller, 0.0, 1.0) : 0.0;
}

}  // namespace scanchor
