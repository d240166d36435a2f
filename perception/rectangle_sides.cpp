#include "perception/rectangle_sides.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"

namespace scanchor {
namespace {

constexpr double most_beyond = 0.08;      // of the area may lie beyond a side
constexpr double hardly_anything = 0.01;  // of the area is given up where no side is seen

/// Turn from b to a, modulo a right angle, [-pi/4, pi/4), of angles that lie less than one apart.
double quarter_difference(double a, double b) {
  double d = a - b;
  if (d >= 0.25 * pi) d -= 0.5 * pi;
  if (d < -0.25 * pi) d += 0.5 * pi;
  return d;
}

/// Modulo a right angle, [-pi/4, pi/4).
double within_quarter(double angle) { return quarter_difference(std::fmod(angle, 0.5 * pi), 0.0); }

double trust(EdgeKind kind) {
  // Shadows have straight edges too, but in the direction of what throws them.
  return kind == EdgeKind::true_edge || kind == EdgeKind::unknown ? 1.0 : 0.2;
}

/// An edge as a direction sees it: how far out its ends lie, and its length across.
struct Reach {
  double from, to, across;
};

std::vector<Reach> reaches_of(const std::vector<OutlineEdge>& edges,
                              const Eigen::Vector2d& normal) {
  const Eigen::Vector2d along(-normal.y(), normal.x());
  std::vector<Reach> reaches;
  reaches.reserve(edges.size());
  for (const OutlineEdge& e : edges)
    reaches.push_back({e.from.dot(normal), e.to.dot(normal), (e.to - e.from).dot(along)});
  return reaches;
}

/// An edge that faces the way of a side.
struct Facing {
  double position, length, gap, waver;
  EdgeKind kind;
};

/// What sticks out a little beyond a long straight edge (a handle, the corner of a book behind a
/// screen) is not the side: where at least half of the extent is one true edge, with a small part
/// of the area beyond it and less than a quarter of the extent further out, that edge is. Facing
/// edges come from the outermost inwards; `at` is the first choice.
std::size_t pass_tabs(const std::vector<Facing>& facing, std::size_t at, double extent,
                      double innermost) {
  double outside = 0.0;
  for (std::size_t i = 0; i < facing.size() && facing[i].position >= innermost; ++i) {
    if (i > at && facing[i].kind == EdgeKind::true_edge &&
        facing[at].position - facing[i].position > 1.5 * facing[i].gap) {
      double along = 0.0;
      for (std::size_t k = i; k < facing.size(); ++k) {
        if (facing[i].position - facing[k].position > facing[i].gap) break;
        if (facing[k].kind == EdgeKind::true_edge) along += facing[k].length;
      }
      if (along >= 0.5 * extent) return i;
    }
    outside += facing[i].length;
    if (outside >= 0.25 * extent) break;
  }
  return at;
}

/// [m2] of the outline that lies further out than a position (Green's theorem on the part of each
/// edge beyond it).
double area_beyond(const std::vector<Reach>& reaches, double position) {
  double area = 0.0;
  for (const Reach& e : reaches) {
    const double a = e.from - position;
    const double b = e.to - position;
    if (a <= 0.0 && b <= 0.0) continue;
    // Mean height of the edge above the line, over the share of it that is above.
    const double share = a > 0.0 && b > 0.0 ? 1.0 : std::max(a, b) / std::abs(a - b);
    area += e.across * share * 0.5 * (std::max(a, 0.0) + std::max(b, 0.0));
  }
  return std::max(0.0, area);
}

/// Position beyond which a share of the outline's area lies, between two positions.
double position_of_share(const std::vector<Reach>& reaches, double inner, double outer,
                         double share) {
  const double wanted = share * area_beyond(reaches, inner);
  double low = inner;
  double high = outer;
  for (int i = 0; i < 24; ++i) {
    const double middle = 0.5 * (low + high);
    (area_beyond(reaches, middle) > wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Of a side that no true edge shows: is what lies beyond this position less than half as broad as
/// the outline?
void loosen(const std::vector<Reach>& reaches, double inner, double extent, RectangleSide& side) {
  const double area = area_beyond(reaches, inner);
  if (side.position <= inner || area > 0.5 * extent * (side.position - inner)) return;
  side.loose = side.position - inner;
  side.loose_area = area;
}

}  // namespace

double main_direction(const std::vector<OutlineEdge>& edges) {
  struct Line {
    double angle, length, blur, trust, gap;
  };
  std::vector<Line> lines;
  lines.reserve(edges.size());
  for (const OutlineEdge& e : edges) {
    const double length = (e.to - e.from).norm();
    if (length == 0.0) continue;
    lines.push_back({within_quarter(std::atan2(e.to.y() - e.from.y(), e.to.x() - e.from.x())),
                     length, std::max(radians(2.0), e.gap / length), trust(e.kind), e.gap});
  }
  double best = 0.0;
  double best_score = -1.0;
  for (const Line& candidate : lines) {
    if (candidate.length < 2.0 * candidate.gap) continue;
    double score = 0.0;
    for (const Line& e : lines) {
      const double z = quarter_difference(e.angle, candidate.angle) / e.blur;
      if (std::abs(z) < 1.0) score += e.trust * e.length * (1.0 - z * z);
    }
    // The longest edge knows the direction best.
    score *=
        1.0 + 0.1 * candidate.trust * candidate.length / (candidate.length + 10.0 * candidate.gap);
    if (score > best_score) {
      best_score = score;
      best = candidate.angle;
    }
  }
  // An edge of length l with errors of size g at its ends knows its direction to about g / l;
  // weights are lengths to the third, for the number of samples along it grows with l as well.
  double sum = 0.0;
  double weight = 0.0;
  for (const Line& e : lines) {
    const double d = quarter_difference(e.angle, best);
    if (std::abs(d) > radians(5.0)) continue;
    sum += e.trust * e.length * e.length * e.length * d;
    weight += e.trust * e.length * e.length * e.length;
  }
  return within_quarter(weight > 0.0 ? best + sum / weight : best);
}

void guess_side(const std::vector<OutlineEdge>& edges, double direction, RectangleSide& side) {
  const Eigen::Vector2d normal = unit_vector(direction + side.turn);
  const Eigen::Vector2d along(-normal.y(), normal.x());
  std::vector<Facing> facing;
  double outermost = -1e300;
  double innermost = 1e300;
  side.low = 1e300;
  side.high = -1e300;
  for (const OutlineEdge& e : edges) {
    const Eigen::Vector2d d = e.to - e.from;
    const double length = d.norm();
    outermost = std::max(outermost, e.from.dot(normal));
    innermost = std::min(innermost, e.from.dot(normal));
    side.low = std::min(side.low, e.from.dot(along));
    side.high = std::max(side.high, e.from.dot(along));
    const Eigen::Vector2d outward(d.y(), -d.x());
    if (outward.dot(normal) > 0.85 * length)
      facing.push_back({0.5 * (e.from + e.to).dot(normal), length, e.gap, e.waver, e.kind});
  }
  std::sort(facing.begin(), facing.end(), [](const Facing& a, const Facing& b) {
    return a.position != b.position ? a.position > b.position : a.length > b.length;
  });
  const double extent = side.high - side.low;
  double met = 0.0;
  double met_real = 0.0;
  std::size_t at = facing.size();
  const std::vector<Reach> reaches = reaches_of(edges, normal);
  // Edges of shadows within the outline face this way too. What has much of the area beyond it is
  // no side of it: then the side is where hardly anything is left, wherever its edge is.
  const double much = position_of_share(reaches, innermost, outermost, most_beyond);
  for (std::size_t i = 0; i < facing.size() && facing[i].position >= much; ++i) {
    met += facing[i].length;
    if (facing[i].kind == EdgeKind::true_edge) met_real += facing[i].length;
    // The corner that looks out of a shadow is short, but a true edge of three samples is no
    // accident.
    if (met >= 0.1 * extent || met_real >= std::max(3.0 * facing[i].gap, 0.03 * extent)) {
      at = i;
      break;
    }
  }
  at = pass_tabs(facing, at, extent, much);
  if (at == facing.size()) {
    side.position = position_of_share(reaches, innermost, outermost, hardly_anything);
    side.censored = true;
    loosen(reaches, much, extent, side);
    return;
  }
  side.position = facing[at].position;
  // All that lies along it within the wavering of the outline.
  double sum = 0.0, weight = 0.0, real = 0.0;
  const double reach = std::max(facing[at].gap, 0.01 * extent);
  for (const Facing& f : facing) {
    if (std::abs(f.position - facing[at].position) > reach) continue;
    sum += f.length * f.position;
    weight += f.length;
    side.gap += f.length * f.gap;
    side.waver += f.length * f.waver;
    if (f.kind == EdgeKind::true_edge || f.kind == EdgeKind::unknown) real += f.length;
  }
  side.position = sum / weight;
  side.gap /= weight;
  side.waver /= weight;
  side.support = std::min(1.0, extent > 0.0 ? real / extent : 0.0);
  side.censored = real < 0.5 * weight;
  if (side.censored) {
    loosen(reaches, much, extent, side);
    return;
  }
  // Where most of the true edges lie.
  const auto is_true = [](const Facing& f) {
    return f.kind == EdgeKind::true_edge || f.kind == EdgeKind::unknown;
  };
  double all = 0.0, outer = 0.0;
  for (const Facing& f : facing) all += is_true(f) ? f.length : 0.0;
  for (const Facing& f : facing) {
    outer += is_true(f) ? f.length : 0.0;
    if (outer < 0.5 * all) continue;
    if (side.position - f.position > 1.5 * side.gap) {
      side.loose = side.position - f.position;
      side.loose_area = area_beyond(reaches, f.position);
    }
    break;
  }
}

}  // namespace scanchor
