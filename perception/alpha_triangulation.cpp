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

/// The curve's square has 2^bits cells a side, four or more for each point: finer ones would only
/// cost time.
int bits_for(std::size_t points) {
  int bits = 3;
  while (bits < 16 && (points >> (2 * bits - 2)) > 0) ++bits;
  return bits;
}

/// Place of cell (x, y) on the curve; see Warren, Hacker's Delight, section 16-3. The turns of the
/// curve so far are kept as one swap and one complement of what is still to come.
std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y, int bits) {
  std::uint32_t place = 0;
  std::uint32_t swapped = 0;
  std::uint32_t complement = 0;
  for (int s = bits - 1; s >= 0; --s) {
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

/// Stable, by place, whose last `bits` count.
void sort_by_place(std::vector<Key>& keys, int bits) {
  constexpr std::size_t few = 256;
  const auto before = [](const Key& a, const Key& b) {
    return a.place != b.place ? a.place < b.place : a.index < b.index;
  };
  if (keys.size() < few) {
    std::sort(keys.begin(), keys.end(), before);
    return;
  }
  constexpr int digit_bits = 8;
  constexpr std::uint32_t digits = 1U << digit_bits;
  std::vector<Key> other(keys.size());
  for (int shift = 0; shift < bits; shift += digit_bits) {
    std::array<std::uint32_t, digits> begin{};
    for (const Key& k : keys) ++begin[(k.place >> shift) % digits];
    std::uint32_t sum = 0;
    for (std::uint32_t& b : begin) sum += std::exchange(b, sum);
    for (const Key& k : keys) other[begin[(k.place >> shift) % digits]++] = k;
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
  /// No two points may be equal.
  explicit Growing(const std::vector<Eigen::Vector2d>& points) : points_(points) {
    faces_.reserve(2 * points.size() + 4);
    Eigen::AlignedBox2d box;
    for (const auto& p : points) box.extend(p);
    const double extent = box.sizes().maxCoeff();
    certain_ = 12.0 * in_circle_error * extent * extent * extent * extent;
  }

  /// The first triangle: corners counter-clockwise.
  void begin(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    faces_ = {{{a, b, c}, {link(1, 0), link(2, 0), link(3, 0)}},
              {{infinite, c, b}, {link(0, 0), link(3, 2), link(2, 1)}},
              {{infinite, a, c}, {link(0, 1), link(1, 2), link(3, 1)}},
              {{infinite, b, a}, {link(0, 2), link(2, 2), link(1, 1)}}};
  }

  void insert(std::uint32_t p) {
    const std::uint32_t home = locate(p);
    const Face old = faces_[home];
    const auto second = static_cast<std::uint32_t>(faces_.size());
    const std::uint32_t third = second + 1;
    const auto [a, b, c] = old.corner;
    faces_[home] = {{p, b, c}, {old.beyond[0], link(second, 2), link(third, 1)}};
    faces_.push_back({{p, c, a}, {old.beyond[1], link(third, 2), link(home, 1)}});
    faces_.push_back({{p, a, b}, {old.beyond[2], link(home, 2), link(second, 1)}});
    point_back(old.beyond[0], link(home, 0));
    point_back(old.beyond[1], link(second, 0));
    point_back(old.beyond[2], link(third, 0));
    legalize(home);
    legalize(second);
    legalize(third);
    last_ = home;
  }

  /// order[i]: what point i is called outside.
  [[nodiscard]] Triangulation finished(const std::vector<std::uint32_t>& order) const {
    Triangulation result;
    std::vector<std::int32_t> place(faces_.size(), -1);
    std::int32_t count = 0;
    for (std::size_t t = 0; t < faces_.size(); ++t) {
      if (!is_infinite(faces_[t])) place[t] = count++;
    }
    result.triangles.reserve(static_cast<std::size_t>(count));
    result.neighbours.reserve(static_cast<std::size_t>(count));
    for (std::size_t t = 0; t < faces_.size(); ++t) {
      if (place[t] < 0) continue;
      const auto& [corner, beyond] = faces_[t];
      result.triangles.push_back({order[corner[0]], order[corner[1]], order[corner[2]]});
      result.neighbours.push_back(
          {place[beyond[0] >> 2], place[beyond[1] >> 2], place[beyond[2] >> 2]});
    }
    return result;
  }

 private:
  static constexpr std::uint32_t infinite = 0xffffffffU, none = 0xffffffffU;
  struct Face {
    std::array<std::uint32_t, 3> corner;
    std::array<std::uint32_t, 3> beyond;  ///< link across the edge opposite to corner k
  };
  const std::vector<Eigen::Vector2d>& points_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> todo_;
  std::uint32_t last_ = 0;
  double certain_ = 0.0;  ///< in_circle

  /// A face and which of its edges: no search when one comes over an edge.
  static constexpr std::uint32_t link(std::uint32_t face, std::uint32_t edge) {
    return face << 2 | edge;
  }
  void point_back(std::uint32_t at, std::uint32_t to) { faces_[at >> 2].beyond[at & 3U] = to; }
  static bool is_infinite(const Face& f) {
    return f.corner[0] == infinite || f.corner[1] == infinite || f.corner[2] == infinite;
  }

  /// The triangle that holds the point or, outside the hull, one whose edge sees it.
  [[nodiscard]] std::uint32_t locate(std::uint32_t p) const {
    static constexpr std::uint32_t after[] = {1, 2, 0};
    const Eigen::Vector2d x = points_[p];
    std::uint32_t t = last_;
    const Face& start = faces_[t];
    if (is_infinite(start))
      t = start.beyond[start.corner[0] == infinite ? 0 : (start.corner[1] == infinite ? 1 : 2)] >>
          2;
    std::uint32_t edge = 2;  // looked at last: the one that the way came over
    bool first = true;
    while (true) {
      const Face& f = faces_[t];
      if (is_infinite(f)) return t;
      const std::uint32_t k = after[edge], l = after[k];
      const Eigen::Vector2d& a = points_[f.corner[k]];
      const Eigen::Vector2d& b = points_[f.corner[l]];
      const Eigen::Vector2d& c = points_[f.corner[edge]];
      std::uint32_t next = none;
      if (turn(b, c, x) < 0)
        next = f.beyond[k];
      else if (turn(c, a, x) < 0)
        next = f.beyond[l];
      else if (first && turn(a, b, x) < 0)
        next = f.beyond[edge];
      if (next == none) return t;
      first = false;
      t = next >> 2;
      edge = next & 3U;
    }
  }

  /// Corner 0 of face t is the new point; flips the edge opposite to it where it must not stay, and
  /// what that uncovers.
  void legalize(std::uint32_t t) {
    todo_.clear();
    while (true) {
      Face& f = faces_[t];
      const std::uint32_t across = f.beyond[0], u = across >> 2, k = across & 3U;
      Face& g = faces_[u];
      const auto [p, a, b] = f.corner;
      const std::uint32_t d = g.corner[k];
      if (!must_flip(p, a, b, d)) {
        if (todo_.empty()) return;
        t = todo_.back();
        todo_.pop_back();
        continue;
      }
      // Faces (p, a, b) and (d, b, a) become (p, a, d) and (p, d, b).
      static constexpr std::uint32_t after[] = {1, 2, 0, 1, 2};
      const std::uint32_t ad = g.beyond[after[k]];  // opposite to b: the edge a d
      const std::uint32_t db = g.beyond[after[k + 1]];
      const std::uint32_t beyond_b = f.beyond[1];
      f = {{p, a, d}, {ad, link(u, 2), f.beyond[2]}};
      g = {{p, d, b}, {db, beyond_b, link(t, 1)}};
      point_back(ad, link(t, 0));
      point_back(db, link(u, 0));
      point_back(beyond_b, link(u, 1));
      todo_.push_back(u);
    }
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
  const int bits = bits_for(points.size());
  const double scale = ((1U << bits) - 1) / extent;
  std::vector<Key> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    keys[i] = {hilbert_place(static_cast<std::uint32_t>((points[i].x() - low.x()) * scale),
                             static_cast<std::uint32_t>((points[i].y() - low.y()) * scale), bits),
               static_cast<std::uint32_t>(i)};
  }
  sort_by_place(keys, 2 * bits);
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
  std::vector<std::uint32_t> order = hilbert_order(points);
  // Equal points follow each other, the first of them first.
  order.erase(std::unique(order.begin(), order.end(),
                          [&](auto i, auto k) { return points[i] == points[k]; }),
              order.end());
  std::vector<Eigen::Vector2d> sorted(order.size());  // near in the plane, near in memory
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = points[order[i]];
  // The first three that are no line; what comes before the third lies on a line with the others.
  const auto count = static_cast<std::uint32_t>(sorted.size());
  std::uint32_t third = 2;
  int way = 0;
  for (; third < count; ++third) {
    way = turn(sorted[0], sorted[1], sorted[third]);
    if (way != 0) break;
  }
  if (way == 0) return {};
  Growing growing(sorted);
  growing.begin(0, way > 0 ? 1U : third, way > 0 ? third : 1U);
  // Every fourth first: a new point then has neighbours on all sides, and fewer edges are flipped
  // that the next points would flip again (Amenta, Choi and Rote, "Incremental constructions con
  // BRIO", 2003; more rounds gain nothing here).
  constexpr std::uint32_t coarse = 4;
  for (std::uint32_t i = coarse; i < count; i += coarse) {
    if (i != third) growing.insert(i);
  }
  for (std::uint32_t i = 2; i < count; ++i) {
    if (i % coarse != 0 && i != third) growing.insert(i);
  }
  return growing.finished(order);
}

}  // namespace scanchor
