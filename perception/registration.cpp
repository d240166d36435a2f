#include "perception/registration.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nanoflann.hpp>

#include "core/error.hpp"
#include "core/parallel.hpp"

namespace scanchor {
namespace {

using Points = std::vector<Eigen::Vector3d>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct PointAdaptor {
  const Points* points;
  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points->size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return (*points)[i][static_cast<Eigen::Index>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PointAdaptor>,
                                                 PointAdaptor, 3, std::size_t>;

/// Points with normals, searchable.
struct Shape {
  Points points;
  Points normals;  // unit; zero where there is no plane
  PointAdaptor adaptor{&points};
  std::unique_ptr<Tree> tree;
};

Points finite(const PointCloud& cloud) {
  Points points;
  for (const auto& p : cloud.points) {
    if (p.allFinite()) points.push_back(p);
  }
  if (points.size() < 50) {
    fail_data("registration", "", fmt::format("a cloud has {} finite points", points.size()),
              "at least 50 are needed");
  }
  return points;
}

double diagonal(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const auto& p : points) box.extend(p);
  return box.diagonal().norm();
}

/// The mean of the points of each cell, cells in the order of their place: the order of the input
/// does not matter.
Points thin(const Points& points, double voxel) {
  struct Entry {
    std::array<std::int64_t, 3> cell;
    std::size_t index;
  };
  std::vector<Entry> entries(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      entries[i].cell[axis] =
          static_cast<std::int64_t>(std::floor(points[i][static_cast<Eigen::Index>(axis)] / voxel));
    }
    entries[i].index = i;
  }
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    if (a.cell != b.cell) return a.cell < b.cell;
    const Eigen::Vector3d &p = points[a.index], &q = points[b.index];
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  });
  Points thinned;
  for (std::size_t i = 0; i < entries.size();) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const std::size_t begin = i;
    for (; i < entries.size() && entries[i].cell == entries[begin].cell; ++i) {
      sum += points[entries[i].index];
    }
    thinned.push_back(sum / static_cast<double>(i - begin));
  }
  return thinned;
}

std::unique_ptr<Shape> make_shape(Points points, int neighbours) {
  auto shape = std::make_unique<Shape>();
  shape->points = std::move(points);
  shape->tree =
      std::make_unique<Tree>(3, shape->adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(16));
  const std::size_t count = shape->points.size();
  const std::size_t k = std::min(static_cast<std::size_t>(neighbours), count);
  shape->normals.assign(count, Eigen::Vector3d::Zero());
  parallel_blocks(count, 512, [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> index(k);
    std::vector<double> squared(k);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t found =
          shape->tree->knnSearch(shape->points[i].data(), k, index.data(), squared.data());
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (std::size_t j = 0; j < found; ++j) mean += shape->points[index[j]];
      mean /= static_cast<double>(found);
      Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
      for (std::size_t j = 0; j < found; ++j) {
        const Eigen::Vector3d d = shape->points[index[j]] - mean;
        scatter += d * d.transpose();
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter);
      const Eigen::Vector3d l = eigen.eigenvalues();
      // A plane: thin against its narrower side, and not a line.
      if (l[0] < 0.1 * l[1] && l[1] > 0.02 * l[2]) shape->normals[i] = eigen.eigenvectors().col(0);
    }
  });
  return shape;
}

struct Pair {
  Eigen::Vector3d point, normal;  // moved source point and plane of its partner
  double distance = 0.0;          // across the plane
  bool valid = false;
};

void find_pairs(const Shape& target, const Shape& source, const Eigen::Isometry3d& T, double reach,
                std::vector<Pair>& pairs) {
  pairs.resize(source.points.size());
  parallel_blocks(pairs.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Pair& pair = pairs[i];
      pair.valid = false;
      if (source.normals[i].isZero()) continue;
      pair.point = T * source.points[i];
      std::size_t j = 0;
      double squared = 0.0;
      target.tree->knnSearch(pair.point.data(), 1, &j, &squared);
      if (squared > reach * reach || target.normals[j].isZero()) continue;
      // Two sides of a corner are near each other and yet no pair.
      const double along = std::fabs((T.linear() * source.normals[i]).dot(target.normals[j]));
      if (along < 0.7) continue;
      pair.normal = target.normals[j];
      pair.distance = pair.normal.dot(pair.point - target.points[j]);
      pair.valid = true;
    }
  });
}

/// 1.4826 times the median of |distance|: the standard deviation of a normal core, whatever the
/// tails.
double robust_deviation(const std::vector<Pair>& pairs) {
  std::vector<double> sizes;
  for (const Pair& pair : pairs) {
    if (pair.valid) sizes.push_back(std::fabs(pair.distance));
  }
  if (sizes.empty()) return 0.0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return 1.4826 * *middle;
}

Eigen::Isometry3d exponential(const Vector6& step) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d turn = step.head<3>();
  const double angle = turn.norm();
  if (angle > 0.0) T.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  T.translation() = step.tail<3>();
  return T;
}

/// One Gauss-Newton step about `center`; turns and moves that nothing holds are left out and
/// counted.
Vector6 solve(const std::vector<Pair>& pairs, const Eigen::Vector3d& center, double sigma,
              double size, int& free_directions) {
  Matrix6 H = Matrix6::Zero();
  Vector6 g = Vector6::Zero();
  const double width =
      2.385 *
      sigma;  // 95 % efficiency of the Cauchy kernel on normal residuals (Holland & Welsch 1977)
  double weights = 0.0;
  for (const Pair& pair : pairs) {
    if (!pair.valid) continue;
    const double q = pair.distance / width;
    const double w = 1.0 / (1.0 + q * q);
    Vector6 row;
    // Turning measured in metres at the cloud's size, so that the six directions can be compared.
    row << (pair.point - center).cross(pair.normal) / size, pair.normal;
    H += w * row * row.transpose();
    g -= w * pair.distance * row;
    weights += w;
  }
  Vector6 step = Vector6::Zero();
  free_directions = 6;
  if (weights <= 0.0) return step;
  const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(H / weights);
  for (int i = 0; i < 6; ++i) {
    // A share of constraints: a direction that one normal in a thousand speaks for is not held.
    if (eigen.eigenvalues()[i] < 1e-3) continue;
    --free_directions;
    const Vector6 v = eigen.eigenvectors().col(i);
    step += v * (v.dot(g) / weights / eigen.eigenvalues()[i]);
  }
  step.head<3>() /= size;
  return step;
}

Registration align(const Shape& target, const Shape& source, const Eigen::Isometry3d& guess,
                   double voxel, const RegisterOptions& options) {
  Registration result;
  result.T_target_source = guess;
  double reach = options.reach;
  const double size = 0.25 * diagonal(source.points);
  std::vector<Pair> pairs;
  for (result.iterations = 1; result.iterations <= options.maximum_iterations;
       ++result.iterations) {
    find_pairs(target, source, result.T_target_source, reach, pairs);
    const double sigma = std::max(robust_deviation(pairs), 1e-6);
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    std::size_t count = 0;
    for (const Pair& pair : pairs) {
      if (!pair.valid) continue;
      center += pair.point;
      ++count;
    }
    result.overlap = static_cast<double>(count) / static_cast<double>(pairs.size());
    result.residual = sigma;
    if (count < 6) break;
    center /= static_cast<double>(count);
    const Vector6 step = solve(pairs, center, sigma, size, result.free_directions);
    const Eigen::Isometry3d about =
        Eigen::Translation3d(center) * exponential(step) * Eigen::Translation3d(-center);
    result.T_target_source = about * result.T_target_source;
    result.converged = step.head<3>().norm() < 1e-5 && step.tail<3>().norm() < 1e-5;
    // The nearer the clouds, the nearer a partner must be; a cell and a half is where partners are
    // by chance of thinning.
    const double next = std::max(1.5 * voxel, std::min(reach, 0.5 * reach + 3.0 * sigma));
    if (result.converged && next >= 0.999 * reach) break;
    reach = next;
  }
  result.iterations = std::min(result.iterations, options.maximum_iterations);
  // The rotation is a product of many: bring it back onto the group.
  result.T_target_source.linear() =
      Eigen::Quaterniond(result.T_target_source.linear()).normalized().toRotationMatrix();
  return result;
}

double voxel_for(const Points& target, const RegisterOptions& options) {
  return options.voxel > 0.0 ? options.voxel : std::max(diagonal(target) / 200.0, 1e-6);
}

}  // namespace

void RegisterOptions::describe(OptionList& list) {
  list.add("reach", reach, "m", "how far off the first guess may be", 1e-3, 100.0);
  list.add("voxel", voxel, "m", "cell of the thinned clouds; 0: a two-hundredth of the diagonal",
           0.0, 10.0);
  list.add("neighbours", neighbours, "1", "of a point, for its normal", 4, 100);
  list.add("maximum_iterations", maximum_iterations, "1", "of pairing and moving", 1, 1000);
}

Registration register_clouds(const PointCloud& target, const PointCloud& source,
                             const Eigen::Isometry3d& guess, const RegisterOptions& options) {
  const Points target_points = finite(target);
  const double voxel = voxel_for(target_points, options);
  const auto target_shape = make_shape(thin(target_points, voxel), options.neighbours);
  const auto source_shape = make_shape(thin(finite(source), voxel), options.neighbours);
  return align(*target_shape, *source_shape, guess, voxel, options);
}

std::vector<Eigen::Isometry3d> register_all(const std::vector<PointCloud>& clouds,
                                            const std::vector<Eigen::Isometry3d>& guesses,
                                            const RegisterOptions& options) {
  if (clouds.size() != guesses.size()) {
    fail_usage(fmt::format("{} clouds and {} first guesses", clouds.size(), guesses.size()),
               "give one pose a cloud");
  }
  std::vector<Eigen::Isometry3d> poses;
  Points model;
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    Points points = finite(clouds[i]);
    if (i == 0) {
      poses.push_back(guesses[0]);
    } else {
      const double voxel = voxel_for(model, options);
      const auto target = make_shape(thin(model, voxel), options.neighbours);
      const auto source = make_shape(thin(points, voxel), options.neighbours);
      poses.push_back(align(*target, *source, guesses[i], voxel, options).T_target_source);
    }
    for (const auto& p : points) model.push_back(poses.back() * p);
  }
  return poses;
}

}  // namespace scanchor
