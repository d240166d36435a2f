#include "perception/shape_view.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

constexpr std::uint32_t nowhere = 0xffffffffU;

/// Face 0..5 of the cube (+x -x +y -y +z -z) that a direction passes, and where, in [-1, 1].
struct CubePlace {
  int face;
  double u, v;
};

CubePlace cube_place(const Eigen::Vector3d& d) {
  const Eigen::Vector3d a = d.cwiseAbs();
  if (a.x() >= a.y() && a.x() >= a.z()) return {d.x() > 0 ? 0 : 1, d.y() / a.x(), d.z() / a.x()};
  if (a.y() >= a.z()) return {d.y() > 0 ? 2 : 3, d.x() / a.y(), d.z() / a.y()};
  return {d.z() > 0 ? 4 : 5, d.x() / a.z(), d.y() / a.z()};
}

Eigen::Vector3d cube_direction(const CubePlace& p) {
  const double sign = p.face % 2 == 0 ? 1.0 : -1.0;
  switch (p.face / 2) {
    case 0:
      return {sign, p.u, p.v};
    case 1:
      return {p.u, sign, p.v};
    default:
      return {p.u, p.v, sign};
  }
}

std::uint32_t cell_at(const CubePlace& p, int side) {
  const int x = std::clamp(static_cast<int>((p.u + 1.0) * 0.5 * side), 0, side - 1);
  const int y = std::clamp(static_cast<int>((p.v + 1.0) * 0.5 * side), 0, side - 1);
  return static_cast<std::uint32_t>((p.face * side + y) * side + x);
}

/// Cells along an edge of the cube so that a cell is about two spacings wide, from the density
/// where the median ray lies.
int choose_side(const std::vector<std::uint32_t>& coarse, int coarse_side, std::size_t rays) {
  std::vector<std::uint32_t> counts;
  for (const std::uint32_t c : coarse) {
    if (c > 0) counts.push_back(c);
  }
  std::sort(counts.begin(), counts.end());
  std::size_t below = 0;
  std::uint32_t median = 1;
  for (const std::uint32_t c : counts) {
    below += c;
    median = c;
    if (2 * below >= rays) break;
  }
  constexpr double spacings_per_cell = 2.2;
  return std::clamp(
      static_cast<int>(coarse_side * std::sqrt(static_cast<double>(median)) / spacings_per_cell), 4,
      2048);
}

}  // namespace

ShapeView::ShapeView(const PointCloud& cloud, const Eigen::Vector3d& sensor,
                     const std::vector<std::int32_t>& plane_of_point)
    : sensor_(sensor) {
  constexpr int coarse_side = 48;
  const std::size_t n = cloud.size();
  struct Place {
    float u, v;
    std::uint32_t face;
  };
  std::vector<Place> places(n);
  parallel_blocks(n, 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d d = cloud.points[i] - sensor;
      if (!d.allFinite() || d.squaredNorm() == 0.0) {
        places[i].face = nowhere;
        continue;
      }
      const CubePlace p = cube_place(d);
      places[i] = {static_cast<float>(p.u), static_cast<float>(p.v),
                   static_cast<std::uint32_t>(p.face)};
    }
  });
  const auto cell_in = [&](std::size_t i, int side) {
    return cell_at({static_cast<int>(places[i].face), places[i].u, places[i].v}, side);
  };
  std::vector<std::uint32_t> coarse(6 * coarse_side * coarse_side, 0);
  std::size_t rays = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (places[i].face == nowhere) continue;
    ++coarse[cell_in(i, coarse_side)];
    ++rays;
  }
  side_ = choose_side(coarse, coarse_side, rays);

  const auto cells = static_cast<std::size_t>(6) * static_cast<std::size_t>(side_) *
                     static_cast<std::size_t>(side_);
  std::vector<std::uint32_t> cell_of_point(n);
  begin_.assign(cells + 1, 0);
  owner_.assign(cells, empty);
  for (std::size_t i = 0; i < n; ++i) {
    if (places[i].face == nowhere) {
      cell_of_point[i] = nowhere;
      continue;
    }
    const std::uint32_t cell = cell_in(i, side_);
    cell_of_point[i] = cell;
    ++begin_[cell + 1];
    std::int32_t& owner = owner_[cell];
    owner = owner == empty || owner == plane_of_point[i] ? plane_of_point[i] : mixed;
  }
  for (std::size_t c = 0; c < cells; ++c) begin_[c + 1] += begin_[c];
  fill_cells(cloud, plane_of_point, cell_of_point);
  find_deep_cells();
  list_planes();
}

void ShapeView::fill_cells(const PointCloud& cloud, const std::vector<std::int32_t>& plane_of_point,
                           const std::vector<std::uint32_t>& cell_of_point) {
  std::vector<std::uint32_t> order(begin_.back());
  std::vector<std::uint32_t> fill(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < cell_of_point.size(); ++i) {
    if (cell_of_point[i] != nowhere)
      order[fill[cell_of_point[i]]++] = static_cast<std::uint32_t>(i);
  }
  rays_.resize(order.size());
  parallel_blocks(owner_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      std::sort(order.begin() + begin_[c], order.begin() + begin_[c + 1],
                [&](std::uint32_t a, std::uint32_t b) {
                  const Eigen::Vector3d& p = cloud.points[a];
                  const Eigen::Vector3d& q = cloud.points[b];
                  if (p.x() != q.x()) return p.x() < q.x();
                  if (p.y() != q.y()) return p.y() < q.y();
                  return p.z() < q.z();
                });
      for (std::uint32_t k = begin_[c]; k < begin_[c + 1]; ++k) {
        const Eigen::Vector3d d = cloud.points[order[k]] - sensor_;
        const double range = d.norm();
        rays_[k] = {cloud.points[order[k]], d / range, range, order[k], plane_of_point[order[k]]};
      }
    }
  });
}

void ShapeView::find_deep_cells() {
  deep_.assign(owner_.size(), 0);
  const auto side = static_cast<std::size_t>(side_);
  parallel_blocks(6 * side, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (std::size_t x = 0; x < side; ++x) {
        const std::size_t c = row * side + x;
        const std::int32_t owner = owner_[c];
        if (owner < 0) continue;
        bool deep = true;
        const std::size_t y = row % side;
        if (x > 0 && x + 1 < side && y > 0 && y + 1 < side) {
          for (const std::size_t middle : {c - side, c, c + side}) {
            deep = deep && owner_[middle - 1] == owner && owner_[middle] == owner &&
                   owner_[middle + 1] == owner;
          }
        } else {
          for (const std::uint32_t a : around(static_cast<std::uint32_t>(c)))
            deep = deep && owner_[a] == owner;
        }
        deep_[c] = deep ? 1 : 0;
      }
    }
  });
}

void ShapeView::list_planes() {
  std::int32_t planes = 0;
  for (const ShapeRay& ray : rays_) planes = std::max(planes, ray.plane + 1);
  plane_begin_.assign(static_cast<std::size_t>(planes) + 1, 0);
  plane_cell_begin_ = plane_begin_;
  const auto each_ray_of_a_plane = [&](const auto& visit) {  // (plane, place, cell, first there)
    std::vector<std::uint32_t> last(static_cast<std::size_t>(planes), nowhere);
    for (std::uint32_t c = 0; c < owner_.size(); ++c) {
      for (std::uint32_t k = begin_[c]; k < begin_[c + 1]; ++k) {
        if (rays_[k].plane < 0) continue;
        const auto p = static_cast<std::size_t>(rays_[k].plane);
        visit(p, k, c, last[p] != c);
        last[p] = c;
      }
    }
  };
  each_ray_of_a_plane([&](std::size_t p, std::uint32_t, std::uint32_t, bool first) {
    ++plane_begin_[p + 1];
    if (first) ++plane_cell_begin_[p + 1];
  });
  for (std::size_t p = 1; p < plane_begin_.size(); ++p) {
    plane_begin_[p] += plane_begin_[p - 1];
    plane_cell_begin_[p] += plane_cell_begin_[p - 1];
  }
  plane_order_.resize(plane_begin_.back());
  plane_cell_.resize(plane_cell_begin_.back());
  std::vector<std::uint32_t> fill(plane_begin_.begin(), plane_begin_.end() - 1);
  std::vector<std::uint32_t> fill_cell(plane_cell_begin_.begin(), plane_cell_begin_.end() - 1);
  each_ray_of_a_plane([&](std::size_t p, std::uint32_t k, std::uint32_t c, bool first) {
    plane_order_[fill[p]++] = k;
    if (first) plane_cell_[fill_cell[p]++] = c;
  });
}

std::uint32_t ShapeView::cell_of(const Eigen::Vector3d& direction) const {
  return cell_at(cube_place(direction), side_);
}

std::array<std::uint32_t, 8> ShapeView::around(std::uint32_t cell) const {
  const int side = side_;
  const int face = static_cast<int>(cell) / (side * side);
  const int y = static_cast<int>(cell) / side % side;
  const int x = static_cast<int>(cell) % side;
  std::array<std::uint32_t, 8> result{};
  std::size_t k = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const int nx = x + dx;
      const int ny = y + dy;
      if (nx >= 0 && ny >= 0 && nx < side && ny < side) {
        result[k++] = static_cast<std::uint32_t>((face * side + ny) * side + nx);
      } else {  // over the edge of the cube: the middle of that cell, had the face gone on, seen
                // from the centre
        const CubePlace beyond{face, (nx + 0.5) * 2.0 / side - 1.0, (ny + 0.5) * 2.0 / side - 1.0};
        result[k++] = cell_of(cube_direction(beyond));
      }
    }
  }
  return result;
}

}  // namespace scanchor
