#include "scenes/mesh.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "core/polygons.hpp"
#include "scenes/pose.hpp"
#include "scenes/truth.hpp"

namespace scanchor {
namespace {

/// Collects vertices and triangles and knows which face is being built.
struct Builder {
  Part part;

  Builder(const std::string& name, int material, const Eigen::Isometry3d& T_instance_part) {
    part.name = name;
    part.material = material;
    part.T_instance_part = T_instance_part;
  }
  int vertex(const Eigen::Vector3d& p) {
    part.vertices.push_back(p);
    return static_cast<int>(part.vertices.size()) - 1;
  }
  std::int32_t face(const std::string& name, bool planar) {
    Face face;
    face.name = name;
    face.planar = planar;
    part.faces.push_back(face);
    return static_cast<std::int32_t>(part.faces.size()) - 1;
  }
  void triangle(std::int32_t face_index, int a, int b, int c) {
    part.triangles.emplace_back(a, b, c);
    part.triangle_face.push_back(face_index);
  }
  void quad(std::int32_t face_index, int a, int b, int c, int d) {
    triangle(face_index, a, b, c);
    triangle(face_index, a, c, d);
  }
  Part finish() {
    measure_faces(part);
    part.convex = is_convex(part);
    return std::move(part);
  }
};

/// Ear clipping (Meisters 1975); triangles as indices into the outline, counter-clockwise.
std::vector<Eigen::Vector3i> triangulate(const std::vector<Eigen::Vector2d>& outline) {
  std::vector<int> ring(outline.size());
  for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = static_cast<int>(i);
  const auto point = [&](int i) -> const Eigen::Vector2d& {
    return outline[static_cast<std::size_t>(i)];
  };
  std::vector<Eigen::Vector3i> triangles;
  while (ring.size() > 3) {
    bool clipped = false;
    for (std::size_t i = 0; i < ring.size() && !clipped; ++i) {
      const int a = ring[(i + ring.size() - 1) % ring.size()];
      const int b = ring[i];
      const int c = ring[(i + 1) % ring.size()];
      if (cross2(point(b) - point(a), point(c) - point(b)) <= 0) continue;
      bool empty = true;
      for (const int k : ring) {
        if (k == a || k == b || k == c) continue;
        const auto& p = point(k);
        empty = empty && !(cross2(point(b) - point(a), p - point(a)) >= 0 &&
                           cross2(point(c) - point(b), p - point(b)) >= 0 &&
                           cross2(point(a) - point(c), p - point(c)) >= 0);
      }
      if (!empty) continue;
      triangles.emplace_back(a, b, c);
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      clipped = true;
    }
    if (!clipped) break;  // not simple: keep what there is
  }
  triangles.emplace_back(ring[0], ring[1], ring[2]);
  return triangles;
}

double signed_power(double base, double exponent) {
  if (base == 0.0) return 0.0;
  const double magnitude = portable_exp(exponent * portable_log(std::abs(base)));
  return base < 0 ? -magnitude : magnitude;
}

}  // namespace

Part prism_part(const std::string& name, int material, const std::vector<Eigen::Vector2d>& outline,
                double z0, double z1, const Eigen::Isometry3d& T_instance_part) {
  Builder builder(name, material, T_instance_part);
  const int n = static_cast<int>(outline.size());
  for (const double z : {z0, z1}) {
    for (const auto& p : outline) builder.vertex({p.x(), p.y(), z});
  }
  const auto top = builder.face("top", true);
  const auto bottom = builder.face("bottom", true);
  for (const auto& t : triangulate(outline)) {
    builder.triangle(top, n + t[0], n + t[1], n + t[2]);
    builder.triangle(bottom, t[0], t[2], t[1]);
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    builder.quad(builder.face("side " + std::to_string(i + 1), true), i, j, n + j, n + i);
  }
  return builder.finish();
}

Part lathe_part(const std::string& name, int material, const std::vector<Eigen::Vector2d>& profile,
                int segments, const Eigen::Isometry3d& T_instance_part) {
  Builder builder(name, material, T_instance_part);
  std::vector<int> first(
      profile.size());  // first vertex of each ring; a ring of radius 0 is one vertex
  const std::size_t last = profile.size() - 1;
  const bool loop = profile.front() == profile.back() && profile.front().x() > 0;
  for (std::size_t k = 0; k < profile.size(); ++k) {
    if (k == last && loop) {
      first[k] = first[0];
      break;
    }
    const double r = profile[k].x();
    first[k] = static_cast<int>(builder.part.vertices.size());
    for (int s = 0; s < (r > 0 ? segments : 1); ++s) {
      const SinCos sc = portable_sincos(2.0 * pi * s / segments);
      builder.vertex({r * sc.cos, r * sc.sin, profile[k].y()});
    }
  }
  const auto cap = [&](std::size_t k, bool up) {
    const auto face = builder.face(up ? "top" : "bottom", true);
    for (int s = 1; s + 1 < segments; ++s) {
      if (up) {
        builder.triangle(face, first[k], first[k] + s, first[k] + s + 1);
      } else {
        builder.triangle(face, first[k], first[k] + s + 1, first[k] + s);
      }
    }
  };
  if (profile[0].x() > 0 && !loop) cap(0, false);
  if (profile[last].x() > 0 && !loop) cap(last, true);
  std::int32_t wall = -1;
  int rings = 0;
  for (std::size_t k = 0; k < last; ++k) {
    const bool level = profile[k].y() == profile[k + 1].y();
    std::int32_t face = wall;
    if (level) {
      face = builder.face("ring " + std::to_string(++rings), true);
    } else if (wall < 0) {
      face = wall = builder.face("wall", false);
    }
    for (int s = 0; s < segments; ++s) {
      const int t = (s + 1) % segments;
      if (profile[k].x() <= 0 && profile[k + 1].x() <= 0) continue;
      if (profile[k].x() <= 0) {
        builder.triangle(face, first[k], first[k + 1] + t, first[k + 1] + s);
      } else if (profile[k + 1].x() <= 0) {
        builder.triangle(face, first[k] + s, first[k] + t, first[k + 1]);
      } else {
        builder.quad(face, first[k] + s, first[k] + t, first[k + 1] + t, first[k + 1] + s);
      }
    }
  }
  return builder.finish();
}

Part cylinder_part(const std::string& name, int material, const Eigen::Vector3d& p0,
                   const Eigen::Vector3d& p1, double radius, int segments) {
  return lathe_part(name, material, {{radius, 0.0}, {radius, (p1 - p0).norm()}}, segments,
                    pose_along(p0, p1));
}

Part capsule_part(const std::string& name, int material, const Eigen::Vector3d& p0,
                  const Eigen::Vector3d& p1, double r0, double r1, int segments) {
  const double length = (p1 - p0).norm();
  std::vector<Eigen::Vector2d> profile;
  const int arcs = std::max(2, segments / 4);
  for (int k = 0; k <= arcs; ++k) {
    const SinCos sc = portable_sincos(0.5 * pi * k / arcs);
    profile.emplace_back(k == 0 ? 0.0 : r0 * sc.sin, -r0 * sc.cos);
  }
  for (int k = 0; k <= arcs; ++k) {
    const SinCos sc = portable_sincos(0.5 * pi * k / arcs);
    profile.emplace_back(k == arcs ? 0.0 : r1 * sc.cos, length + r1 * sc.sin);
  }
  return lathe_part(name, material, profile, segments, pose_along(p0, p1));
}

Part cushion_part(const std::string& name, int material, const Eigen::Vector3d& center,
                  const Eigen::Vector3d& size, double exponent, int segments) {
  const int levels = std::max(4, segments / 2);
  Builder builder(name, material, pose_at(center));
  const auto skin = builder.face("skin", false);
  std::vector<int> first;
  for (int k = 0; k <= levels; ++k) {
    const SinCos u = portable_sincos(pi * k / levels - 0.5 * pi);
    const bool pole = k == 0 || k == levels;
    const double z = k == 0 ? -1.0 : k == levels ? 1.0 : signed_power(u.sin, exponent);
    const double r = pole ? 0.0 : signed_power(u.cos, exponent);
    first.push_back(static_cast<int>(builder.part.vertices.size()));
    for (int s = 0; s < (pole ? 1 : segments); ++s) {
      // Half a step off the axes: a vertex lies on each rounded corner instead of in the middle of
      // a side.
      const SinCos v = portable_sincos(2.0 * pi * (s + 0.5) / segments);
      builder.vertex({0.5 * size.x() * r * signed_power(v.cos, exponent),
                      0.5 * size.y() * r * signed_power(v.sin, exponent), 0.5 * size.z() * z});
    }
  }
  for (int k = 0; k < levels; ++k) {
    const int lower = first[static_cast<std::size_t>(k)];
    const int upper = first[static_cast<std::size_t>(k) + 1];
    for (int s = 0; s < segments; ++s) {
      const int t = (s + 1) % segments;
      if (k == 0) {
        builder.triangle(skin, lower, upper + t, upper + s);
      } else if (k == levels - 1) {
        builder.triangle(skin, lower + s, lower + t, upper);
      } else {
        builder.quad(skin, lower + s, lower + t, upper + t, upper + s);
      }
    }
  }
  Part part = builder.finish();
  part.convex = true;  // up to the facets of a convex body: the hull is what physics wants
  return part;
}

Part turned_box_part(const std::string& name, int material, const Eigen::Vector3d& center,
                     const Eigen::Vector3d& size, const Eigen::Matrix3d& rotation) {
  Part part = box_part(name, material, Eigen::Vector3d::Zero(), size);
  part.T_instance_part = pose_at(center, rotation);
  return part;
}

Part panel_part(const std::string& name, int material, double width, double height, double depth,
                const std::vector<Opening>& openings, bool closed,
                const Eigen::Isometry3d& T_instance_part) {
  Builder builder(name, material, T_instance_part);
  // Cells between all coordinates of the openings: the grid has no T-junctions.
  std::vector<double> xs = {0.0, width};
  std::vector<double> zs = {0.0, height};
  for (const auto& o : openings) {
    xs.insert(xs.end(), {o.low.x(), o.high.x()});
    zs.insert(zs.end(), {o.low.y(), o.high.y()});
  }
  for (auto* axis : {&xs, &zs}) {
    std::sort(axis->begin(), axis->end());
    axis->erase(std::unique(axis->begin(), axis->end()), axis->end());
  }
  const int nx = static_cast<int>(xs.size());
  const int nz = static_cast<int>(zs.size());
  const auto grid = [&](double y) {
    for (const double z : zs) {
      for (const double x : xs) builder.vertex({x, y, z});
    }
  };
  grid(0.0);
  if (closed) grid(depth);
  const auto at = [&](int side, int i, int k) { return side * nx * nz + k * nx + i; };
  const auto solid = [&](int i, int k) {
    const double x = 0.5 * (xs[static_cast<std::size_t>(i)] + xs[static_cast<std::size_t>(i) + 1]);
    const double z = 0.5 * (zs[static_cast<std::size_t>(k)] + zs[static_cast<std::size_t>(k) + 1]);
    return std::none_of(openings.begin(), openings.end(), [&](const Opening& o) {
      return x > o.low.x() && x < o.high.x() && z > o.low.y() && z < o.high.y();
    });
  };
  const auto front = builder.face("front", true);
  const auto back = closed ? builder.face("back", true) : -1;
  for (int k = 0; k + 1 < nz; ++k) {
    for (int i = 0; i + 1 < nx; ++i) {
      if (!solid(i, k)) continue;
      builder.quad(front, at(0, i, k), at(0, i + 1, k), at(0, i + 1, k + 1), at(0, i, k + 1));
      if (closed)
        builder.quad(back, at(1, i + 1, k), at(1, i, k), at(1, i, k + 1), at(1, i + 1, k + 1));
    }
  }
  const auto index = [](const std::vector<double>& axis, double value) {
    return static_cast<int>(std::lower_bound(axis.begin(), axis.end(), value) - axis.begin());
  };
  if (closed) {
    const auto left = builder.face("left", true);
    const auto right = builder.face("right", true);
    for (int k = 0; k + 1 < nz; ++k) {
      builder.quad(left, at(1, 0, k), at(0, 0, k), at(0, 0, k + 1), at(1, 0, k + 1));
      builder.quad(right, at(0, nx - 1, k), at(1, nx - 1, k), at(1, nx - 1, k + 1),
                   at(0, nx - 1, k + 1));
    }
    const auto top = builder.face("top", true);
    const auto bottom = builder.face("bottom", true);
    for (int i = 0; i + 1 < nx; ++i) {
      builder.quad(top, at(0, i, nz - 1), at(0, i + 1, nz - 1), at(1, i + 1, nz - 1),
                   at(1, i, nz - 1));
      if (solid(i, 0))
        builder.quad(bottom, at(1, i, 0), at(1, i + 1, 0), at(0, i + 1, 0), at(0, i, 0));
    }
  }
  for (std::size_t h = 0; h < openings.size(); ++h) {
    const Opening& o = openings[h];
    const double reach = closed || o.depth < 0 ? depth : o.depth;
    if (reach <= 0) continue;
    const std::string prefix = "opening " + std::to_string(h + 1) + " ";
    const int i0 = index(xs, o.low.x());
    const int i1 = index(xs, o.high.x());
    const int k0 = index(zs, o.low.y());
    const int k1 = index(zs, o.high.y());
    // A closed panel has its back vertices already; an open one gets its own behind each opening.
    const auto back_of = [&](int i, int k) {
      if (closed) return at(1, i, k);
      return builder.vertex(
          {xs[static_cast<std::size_t>(i)], reach, zs[static_cast<std::size_t>(k)]});
    };
    const auto strip = [&](const std::string& side, int ia, int ka, int ib, int kb) {
      // From (ia, ka) to (ib, kb) along the rim; the opening lies on the left as seen from the
      // front.
      const auto face = builder.face(prefix + side, true);
      const int di = ib > ia ? 1 : ib < ia ? -1 : 0;
      const int dk = kb > ka ? 1 : kb < ka ? -1 : 0;
      int last = back_of(ia, ka);
      for (int i = ia, k = ka; i != ib || k != kb; i += di, k += dk) {
        const int next = back_of(i + di, k + dk);
        builder.quad(face, at(0, i, k), at(0, i + di, k + dk), next, last);
        last = next;
      }
    };
    strip("left", i0, k1, i0, k0);
    if (k0 > 0) strip("sill", i0, k0, i1, k0);
    strip("right", i1, k0, i1, k1);
    strip("lintel", i1, k1, i0, k1);
  }
  Part part = builder.finish();
  part.convex = closed && openings.empty();
  return part;
}

}  // namespace scanchor
