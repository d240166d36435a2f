#include "perception/alpha_triangulation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace scanchor {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::uint32_t side = 1U << 16;
constexpr int side_bits = 16;

/// Place of cell (x, y) on the curve; see Warren, Hacker's Delight, section 16-3. The turns of the
/// curve so far are kept as one swap and one complement of what is still to come.
std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0;
  std::uint32_t swapped = 0;
  std::uint32_t complement = 0;
  for (int s = side_bits - 1; s >= 0; --s) {
    const std::uint32_t x_bit = (x >> s) & 1U;
    const std::uint32_t y_bit = (y >> s) & 1U;
    const std::uint32_t differ = (x_bit ^ y_bit) & swapped;
    const std::uint32_t rx = x_bit ^ differ ^ complement;
    const std::uint32_t ry = y_bit ^ differ ^ complement;
    place = (place << 2) | ((3 * rx) ^ ry);
    complement ^= rx & (ry ^ 1U);
    swapped ^= ry ^ 1U;
  }
  return place;
}

struct Key {
  std::uint32_t place;
  std::uint32_t index;
};

/// Stable, by place: three rounds of eleven bits where that pays.
void sort_by_place(std::vector<Key>& keys) {
  constexpr std::size_t few = 256;
  const auto before = [](const Key& a, const Key& b) {
    return a.place != b.place ? a.place < b.place : a.index < b.index;
  };
  if (keys.size() < few) {
    std::sort(keys.begin(), keys.end(), before);
    return;
  }
  constexpr std::uint32_t digits = 1U << 11;
  std::array<std::array<std::uint32_t, digits>, 3> begin{};
  for (const Key& k : keys) {
    for (std::size_t r = 0; r < 3; ++r) ++begin[r][(k.place >> (11 * r)) % digits];
  }
  std::vector<Key> other(keys.size());
  for (std::size_t r = 0; r < 3; ++r) {
    std::uint32_t sum = 0;
    for (std::uint32_t& b : begin[r]) sum += std::exchange(b, sum);
    for (const Key& k : keys) other[begin[r][(k.place >> (11 * r)) % digits]++] = k;
    keys.swap(other);
  }
}

// What the quick sums below cannot decide; seldom, and kept out of their way.
[[gnu::noinline]] int exact_turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                 const Eigen::Vector2d& c) {
  return CGAL::orientation(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()),
                           Kernel::Point_2(c.x(), c.y()));
}

[[gnu::noinline]] bool exactly_in_circle(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                         const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  return CGAL::side_of_oriented_circle(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()),
                                       Kernel::Point_2(c.x(), c.y()),
                                       Kernel::Point_2(d.x(), d.y())) == CGAL::ON_POSITIVE_SIDE;
}

/// Sign of the turn a -> b -> c, positive to the left. Exact: the quick sum decides where its error
/// cannot (Shewchuk, "Adaptive precision floating-point arithmetic", 1997, bounds A), elsewhere
/// CGAL's exact arithmetic.
inline int turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = 3.4e-16 * (std::abs(left) + std::abs(right));
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return exact_turn(a, b, c);
}

constexpr double in_circle_error = 1.2e-15;  // of the sum of its products

/// Whether d lies inside the circle through a, b, c, counter-clockwise; a side of it where they lie
/// on a line. Exact. `certain`: greatest error of the quick sum over all points.
inline bool in_circle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                      const Eigen::Vector2d& d, double certain) {
  const double ax = a.x() - d.x(), ay = a.y() - d.y();
  const double bx = b.x() - d.x(), by = b.y() - d.y();
  const double cx = c.x() - d.x(), cy = c.y() - d.y();
  const double bc = bx * cy, cb = cx * by, ca = cx * ay, ac = ax * cy, ab = ax * by, ba = bx * ay;
  const double al = ax * ax + ay * ay, bl = bx * bx + by * by, cl = cx * cx + cy * cy;
  const double det = al * (bc - cb) + bl * (ca - ac) + cl * (ab - ba);
  if (det > certain) return true;
  if (det < -certain) return false;
  const double bound =
      in_circle_error * ((std::abs(bc) + std::abs(cb)) * al + (std::abs(ca) + std::abs(ac)) * bl +
                         (std::abs(ab) + std::abs(ba)) * cl);
  if (det > bound) return true;
  if (det < -bound) return false;
  return exactly_in_circle(a, b, c, d);
}

/// Triangulation that grows point by point (Lawson's flips). Outside the hull each of its edges
/// carries a triangle whose third corner is `infinite`, so that no edge is without a neighbour.
class Growing {
 public:
  explicit Growing(const std::vector<Eigen::Vector2d>& points) : points_(points) {
    triangles_.reserve(2 * points.size() + 4);
    Eigen::AlignedBox2d box;
    for (const auto& p : points) box.extend(p);
    const double extent = box.sizes().maxCoeff();
    certain_ = 12.0 * in_circle_error * extent * extent * extent * extent;
  }

  /// The first triangle: corners counter-clockwise.
  void begin(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles_ = {{{a, b, c}, {1, 2, 3}},
                  {{infinite, c, b}, {0, 3, 2}},
                  {{infinite, a, c}, {0, 1, 3}},
                  {{infinite, b, a}, {0, 2, 1}}};
  }

  void insert(std::uint32_t p) {
    const std::int32_t home = locate(p);
    if (home < 0) return;  // equal to a corner
    const Face old = triangles_[static_cast<std::size_t>(home)];
    const auto second = static_cast<std::int32_t>(triangles_.size());
    const std::int32_t third = second + 1;
    triangles_[static_cast<std::size_t>(home)] = {{p, old.corner[1], old.corner[2]},
                                                  {old.beyond[0], second, third}};
    triangles_.push_back({{p, old.corner[2], old.corner[0]}, {old.beyond[1], third, home}});
    triangles_.push_back({{p, old.corner[0], old.corner[1]}, {old.beyond[2], home, second}});
    replace(old.beyond[1], home, second);
    replace(old.beyond[2], home, third);
    todo_ = {home, second, third};
    while (!todo_.empty()) {
      const std::int32_t t = todo_.back();
      todo_.pop_back();
      legalize(t);
    }
    last_ = home;
  }

  [[nodiscard]] Triangulation finished() const {
    Triangulation result;
    std::vector<std::int32_t> place(triangles_.size(), -1);
    std::int32_t count = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!is_infinite(triangles_[t])) place[t] = count++;
    }
    result.triangles.reserve(static_cast<std::size_t>(count));
    result.neighbours.reserve(static_cast<std::size_t>(count));
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (place[t] < 0) continue;
      const Face& f = triangles_[t];
      result.triangles.push_back(f.corner);
      result.neighbours.push_back({place[static_cast<std::size_t>(f.beyond[0])],
                                   place[static_cast<std::size_t>(f.beyond[1])],
                                   place[static_cast<std::size_t>(f.beyond[2])]});
    }
    return result;
  }

 private:
  static constexpr std::uint32_t infinite = 0xffffffffU;
  struct Face {
    std::array<std::uint32_t, 3> corner;
    std::array<std::int32_t, 3> beyond;  ///< the face across the edge opposite to corner k
  };
  const std::vector<Eigen::Vector2d>& points_;
  std::vector<Face> triangles_;
  std::vector<std::int32_t> todo_;
  std::int32_t last_ = 0;
  double certain_ = 0.0;  ///< in_circle

  static bool is_infinite(const Face& f) {
    return f.corner[0] == infinite || f.corner[1] == infinite || f.corner[2] == infinite;
  }
  static std::size_t place_of(const Face& f, std::int32_t neighbour) {
    return f.beyond[0] == neighbour ? 0 : (f.beyond[1] == neighbour ? 1 : 2);
  }
  void replace(std::int32_t at, std::int32_t was, std::int32_t is) {
    Face& f = triangles_[static_cast<std::size_t>(at)];
    f.beyond[place_of(f, was)] = is;
  }

  /// The triangle that holds the point or, outside the hull, one whose edge sees it; -1: a corner.
  [[nodiscard]] std::int32_t locate(std::uint32_t p) const {
    const Eigen::Vector2d& x = points_[p];
    std::int32_t t = last_;
    if (is_infinite(triangles_[static_cast<std::size_t>(t)])) {
      const Face& f = triangles_[static_cast<std::size_t>(t)];
      t = f.beyond[f.corner[0] == infinite ? 0 : (f.corner[1] == infinite ? 1 : 2)];
    }
    std::int32_t from = -1;
    while (true) {
      const Face& f = triangles_[static_cast<std::size_t>(t)];
      if (is_infinite(f)) return t;
      std::int32_t next = -1;
      for (std::size_t k = 0; k < 3 && next < 0; ++k) {
        if (f.beyond[k] == from) continue;
        if (turn(points_[f.corner[(k + 1) % 3]], points_[f.corner[(k + 2) % 3]], x) < 0)
          next = f.beyond[k];
      }
      if (next < 0) {
        const auto equal = [&](std::uint32_t c) { return points_[c] == x; };
        return std::any_of(f.corner.begin(), f.corner.end(), equal) ? -1 : t;
      }
      from = t;
      t = next;
    }
  }

  /// Corner 0 of face t is the new point; flips the edge opposite to it where it must not stay.
  void legalize(std::int32_t t) {
    Face& f = triangles_[static_cast<std::size_t>(t)];
    const std::int32_t u = f.beyond[0];
    Face& g = triangles_[static_cast<std::size_t>(u)];
    const std::size_t k = place_of(g, t);
    const std::uint32_t p = f.corner[0], a = f.corner[1], b = f.corner[2], d = g.corner[k];
    if (!must_flip(p, a, b, d)) return;
    // Faces (p, a, b) and (d, b, a) become (p, a, d) and (p, d, b).
    const std::int32_t beyond_a = f.beyond[2], beyond_b = f.beyond[1];
    const std::int32_t ad = g.beyond[(k + 1) % 3];  // opposite to b: the edge a d
    const std::int32_t db = g.beyond[(k + 2) % 3];
    f = {{p, a, d}, {ad, u, beyond_a}};
    g = {{p, d, b}, {db, beyond_b, t}};
    replace(ad, u, t);
    replace(beyond_b, t, u);
    todo_.push_back(t);
    todo_.push_back(u);
  }

  [[nodiscard]] bool must_flip(std::uint32_t p, std::uint32_t a, std::uint32_t b,
                               std::uint32_t d) const {
    // The circle of an infinite face is the half-plane beyond its edge, and the edge itself.
    if (a == infinite) return d != infinite && turn(points_[p], points_[b], points_[d]) < 0;
    if (b == infinite) return d != infinite && turn(points_[a], points_[p], points_[d]) < 0;
    if (d == infinite) return turn(points_[a], points_[b], points_[p]) == 0;
    return in_circle(points_[p], points_[a], points_[b], points_[d], certain_);
  }
};

}  // namespace

std::vector<std::uint32_t> hilbert_order(const std::vector<Eigen::Vector2d>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  if (points.size() < 2) return order;
  Eigen::Vector2d low = points.front();
  Eigen::Vector2d high = points.front();
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = std::max((high - low).maxCoeff(), 1e-300);
  const double scale = (side - 1) / extent;
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    keys[i] = {hilbert_place(static_cast<std::uint32_t>((points[i].x() - low.x()) * scale),
                             static_cast<std::uint32_t>((points[i].y() - low.y()) * scale)),
               static_cast<std::uint32_t>(i)};
  }
  sort_by_place(keys);
  for (std::size_t first = 0; first < keys.size();) {  // ties
    std::size_t last = first + 1;
    while (last < keys.size() && keys[last].place == keys[first].place) ++last;
    if (last - first > 1) {
      std::sort(keys.begin() + static_cast<std::ptrdiff_t>(first),
                keys.begin() + static_cast<std::ptrdiff_t>(last), [&](const Key& a, const Key& b) {
                  const auto& p = points[a.index];
                  const auto& q = points[b.index];
                  if (p.x() != q.x()) return p.x() < q.x();
                  if (p.y() != q.y()) return p.y() < q.y();
                  return a.index < b.index;
                });
    }
    first = last;
  }
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].index;
  return order;
}

Triangulation delaunay(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return {};
  const std::vector<std::uint32_t> order = hilbert_order(points);
  // The first three that are no line; what comes before the third lies on a line with the others.
  const std::uint32_t a = order.front();
  std::size_t second = 1;
  while (second < order.size() && points[order[second]] == points[a]) ++second;
  std::size_t third = second + 1;
  int way = 0;
  for (; third < order.size(); ++third) {
    way = turn(points[a], points[order[second]], points[order[third]]);
    if (way != 0) break;
  }
  if (way == 0) return {};
  const std::uint32_t b = order[second];
  const std::uint32_t c = order[third];
  Growing growing(points);
  growing.begin(a, way > 0 ? b : c, way > 0 ? c : b);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (i != second && i != third) growing.insert(order[i]);
  }
  return growing.finished();
}

}  // namespace scanchor
