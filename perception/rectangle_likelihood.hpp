#pragma once
// How likely each position of a side of a rectangle is, from the samples on both sides of it.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "perception/rectangle_sides.hpp"

namespace scanchor {

struct RectangleEvidence {
  std::vector<Eigen::Vector2d>
      inside;  ///< [m] samples on the surface; those near the edges suffice
  std::vector<Eigen::Vector2d>
      outside;  ///< [m] samples that are known not to be on it, next to the edges
  std::vector<OutlineEdge> edges;
  double sigma = 0.0;  ///< [m] lateral noise of a sample
  /// Where the rays are known: heights of the samples over the plane, positive towards the sensor,
  /// in standard deviations of the noise across it, and the foot of the sensor on the plane [m].
  std::vector<double> inside_height, outside_height;
  std::optional<Eigen::Vector2d> foot;
  /// [m2] variance of the distance between two places of the plane, along a unit vector, that comes
  /// from the plane itself; may be empty.
  std::function<double(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                       const Eigen::Vector2d& along)>
      plane_variance;
};

constexpr int side_bins = 48;  ///< positions of a side that are tried at once
using SideHistogram = std::array<double, side_bins>;

/// Each sample lies on the side of the edge where it was found, but for lateral noise and a share
/// of wrong samples. Where heights are known, what is wrong is weighed: the first row of points of
/// a face that begins at the edge still lies within the noise of this plane and may have been
/// claimed by it, but the points lie behind it (in a corner: before it), as points of its own do
/// not. And a point beyond that lies in this plane may be its own, claimed by the neighbour.
class SideLikelihood {
 public:
  /// `middle` [m]: where positions are counted from. `sigma` [m]: lateral noise.
  SideLikelihood(const RectangleSide& side, double sigma, const RectangleEvidence& evidence,
                 const Eigen::Vector2d& middle, double direction);

  /// There are samples on both sides.
  [[nodiscard]] bool informed() const { return !inside_.value.empty() && !outside_.value.empty(); }

  /// To be called before positions start + (k + 1/2) step are tried, turned by up to `most_turn`
  /// [rad] to either side of `turn`.
  void look_at(double start, double step, double turn, double most_turn);

  /// Likelihoods of the positions of the side, turned by `turn` [rad] against the main direction:
  /// the greatest of them 1; returns the logarithm of the scale.
  double operator()(double turn, SideHistogram& likelihood) const;

 private:
  /// Apart from each other, so that the places of many are reckoned at once.
  struct Samples {
    std::vector<double> across, along;  ///< [m] from the middle
    std::vector<double>
        value;  ///< height [sigma]; then ln P(found here | belongs to the other side)
  };
  /// How many samples lie in a bin, and the sum of their values.
  struct Bin {
    double count = 0.0, value = 0.0;
  };
  using Bins =
      std::array<Bin, side_bins + 2>;  ///< with one before the first and one after the last

  /// Sorts samples, seen in a direction (cosine and sine of its turn), into bins from `start`.
  [[nodiscard]] Bins sort(const Samples& samples, double c, double s) const;
  /// The samples that may lie in a bin; `before` and `after` count the others.
  static void narrow(const Samples& all, double turn, double most_turn, double low, double high,
                     Samples& near, Bin& before, Bin& after);
  double sigma_;
  double start_ = 0.0;
  double step_ = 1.0;
  int window_ = 0;
  std::array<double, 2 * side_bins + 1> soft_{};
  Samples inside_, outside_;
  Samples near_inside_, near_outside_;
  Bin beyond_, before_;  ///< those inside beyond the last bin, those outside before the first
};

}  // namespace scanchor
