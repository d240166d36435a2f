#include "perception/beam_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/parallel.hpp"

namespace scanchor {

BeamGrid::Spot BeamGrid::spot(const Eigen::Vector3f& d, int side) {
  const Eigen::Vector3f a = d.cwiseAbs();
  if (a.maxCoeff() <= 0.0F) return {0, side / 2, side / 2};
  const auto on = [side](int face, float u, float v) {
    const auto half = 0.5F * static_cast<float>(side);
    return Spot{face, std::clamp(static_cast<int>((u + 1.0F) * half), 0, side - 1),
                std::clamp(static_cast<int>((v + 1.0F) * half), 0, side - 1)};
  };
  if (a.x() >= a.y() && a.x() >= a.z()) return on(d.x() > 0 ? 0 : 1, d.y() / a.x(), d.z() / a.x());
  if (a.y() >= a.z()) return on(d.y() > 0 ? 2 : 3, d.x() / a.y(), d.z() / a.y());
  return on(d.z() > 0 ? 4 : 5, d.x() / a.z(), d.y() / a.z());
}

namespace {

// Of the cells beside one that holds points, the share that hold some too: along rows or along
// columns, where it is less; from every seventh point. Cells at the edges of the cube's faces are
// left out.
double share_beside(const std::vector<std::uint32_t>& place_of_point, int side) {
  std::vector<char> holds(static_cast<std::size_t>(6 * side) * static_cast<std::size_t>(side), 0);
  const auto at = [side](std::uint32_t place) {
    return (static_cast<std::size_t>(place >> 20) * static_cast<std::size_t>(side) +
            (place >> 10 & 1023U)) *
               static_cast<std::size_t>(side) +
           (place & 1023U);
  };
  for (const auto place : place_of_point) holds[at(place)] = 1;
  std::size_t asked = 0, full_x = 0, full_y = 0;
  for (std::size_t i = 0; i < place_of_point.size(); i += 7) {
    const auto place = place_of_point[i];
    const auto x = static_cast<int>(place & 1023U), y = static_cast<int>(place >> 10 & 1023U);
    if (x == 0 || y == 0 || x + 1 >= side || y + 1 >= side) continue;
    const char* const here = &holds[at(place)];
    asked += 2;
    full_x += static_cast<std::size_t>(here[-1] + here[1]);
    full_y += static_cast<std::size_t>(here[-side] + here[side]);
  }
  return asked == 0 ? 1.0
                    : static_cast<double>(std::min(full_x, full_y)) / static_cast<double>(asked);
}

}  // namespace

BeamPlaces place_beams(const CanonicalCloud& cloud, const Eigen::Vector3d& sensor) {
  constexpr int coarse_side = 48, finest = 1024;
  constexpr std::size_t block = 16384;
  constexpr double spacings_per_cell = 1.1, growth = 1.25;
  constexpr double least_beside = 0.75;  // 0.83 where beams are spread evenly
  const std::size_t n = cloud.size();
  const Eigen::Vector3f at = sensor.cast<float>();
  BeamPlaces places;
  places.of_point.resize(n);
  // Where the beam of each point meets a face of the cube, as `spot` says; without a branch, so
  // that the compiler can take several at once.
  std::vector<float> u(n), v(n);
  std::vector<std::uint8_t> faces(n);
  parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float x = cloud.x[i] - at.x(), y = cloud.y[i] - at.y(), z = cloud.z[i] - at.z();
      const float ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
      const bool on_y = ay >= az;
      const float most_yz = on_y ? ay : az;
      const bool on_x = ax >= most_yz;
      const float most = on_x ? ax : most_yz;
      const float third = on_x ? x : (on_y ? y : z), far = most > 0.0F ? most : 1.0F;
      u[i] = (on_x ? y : x) / far;
      v[i] = (on_x || on_y ? z : y) / far;
      faces[i] = static_cast<std::uint8_t>((on_x ? 0 : (on_y ? 2 : 4)) +
                                           (third > 0.0F || most <= 0.0F ? 0 : 1));
    }
  });
  // The place of each point in a grid of this side, one after the other: face, row, column.
  const auto place_points = [&](int side) {
    const float half = 0.5F * static_cast<float>(side);
    const auto along = [half, side](float t) {
      return static_cast<std::uint32_t>(
          std::max(std::min(static_cast<int>((t + 1.0F) * half), side - 1), 0));
    };
    parallel_blocks(n, block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        places.of_point[i] = std::uint32_t{faces[i]} << 20 | along(v[i]) << 10 | along(u[i]);
    });
  };
  place_points(coarse_side);
  std::vector<std::uint32_t> coarse(6 * coarse_side * coarse_side, 0);
  for (const auto place : places.of_point)
    ++coarse[((place >> 20) * coarse_side + (place >> 10 & 1023U)) * coarse_side + (place & 1023U)];
  std::sort(coarse.begin(), coarse.end());
  std::size_t below = 0;
  std::uint32_t median = 1;
  for (const auto count : coarse) {
    below += count;
    median = std::max(count, 1U);
    if (2 * below >= n) break;
  }
  places.side = std::clamp(
      static_cast<int>(coarse_side * std::sqrt(static_cast<double>(median)) / spacings_per_cell), 4,
      finest);
  place_points(places.side);
  // Where beams lie closer along a line than lines to each other, cells as large as the mean would
  // allow have empty ones beside them: they grow until few have.
  while (places.side > 4 && share_beside(places.of_point, places.side) < least_beside) {
    places.side = std::max(4, static_cast<int>(places.side / growth));
    place_points(places.side);
  }
  return places;
}

BeamGrid::BeamGrid(BeamPlaces places)
    : side_(places.side), cell_of_point_(std::move(places.of_point)) {
  const std::size_t n = cell_of_point_.size();
  const auto spot_of = [](std::uint32_t place) {
    return Spot{static_cast<int>(place >> 20), static_cast<int>(place & 1023U),
                static_cast<int>(place >> 10 & 1023U)};
  };
  tiles_ = (side_ + 7) / 8;
  tile_at_.assign(6 * static_cast<std::size_t>(tiles_) * static_cast<std::size_t>(tiles_), 0);
  const auto tile = [&](const Spot& here) -> std::uint32_t& {
    return tile_at_[static_cast<std::size_t>((here.face * tiles_ + here.y) * tiles_ + here.x)];
  };
  for (const auto place : cell_of_point_) {
    const Spot here = spot_of(place);
    tile({here.face, here.x >> 3, here.y >> 3}) = 1;
  }
  spot_of_tile_.push_back({0, 0, 0});
  for (int face = 0; face < 6; ++face) {
    for (int y = 0; y < tiles_; ++y) {
      for (int x = 0; x < tiles_; ++x) {
        auto& number = tile({face, x, y});
        if (number == 0) continue;
        number = static_cast<std::uint32_t>(spot_of_tile_.size());
        spot_of_tile_.push_back({face, x, y});
      }
    }
  }
  // A counting sort: `start_` is where the next point of a cell goes, and in the end where the next
  // cell begins.
  start_.assign(64 * spot_of_tile_.size() + 1, 0);
  for (auto& cell : cell_of_point_) {
    cell = cell_at(spot_of(cell));
    ++start_[cell];
  }
  std::exclusive_scan(start_.begin(), start_.end(), start_.begin(), 0U);
  order_.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    order_[start_[cell_of_point_[i]]++] = static_cast<std::uint32_t>(i);
  std::move_backward(start_.begin(), start_.end() - 1, start_.end());
  start_[0] = 0;
}

BeamGrid::Spot BeamGrid::beyond_face(int face, int x, int y) const {
  const float u = (static_cast<float>(x) + 0.5F) * 2.0F / static_cast<float>(side_) - 1.0F;
  const float v = (static_cast<float>(y) + 0.5F) * 2.0F / static_cast<float>(side_) - 1.0F;
  const float sign = face % 2 == 0 ? 1.0F : -1.0F;
  switch (face / 2) {
    case 0:
      return spot({sign, u, v}, side_);
    case 1:
      return spot({u, sign, v}, side_);
    default:
      return spot({u, v, sign}, side_);
  }
}

}  // namespace scanchor
