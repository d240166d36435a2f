#pragma once
// How far measured planes, rectangles and groups are off, and whether their stated intervals hold.

#include <cstdint>
#include <map>
#include <vector>

#include "eval/fixed_sum.hpp"
#include "eval/objects.hpp"
#include "eval/planes.hpp"

namespace scanchor {

/// Errors of one quantity: exact sums, and a histogram with 20 bins a decade for the quantiles.
struct ErrorStats {
  std::int64_t count = 0;
  FixedSum absolute;
  FixedSum squared;
  FixedSum signed_sum;
  std::map<std::int32_t, std::int64_t>
      histogram;                   ///< floor(20 log10 |error|), clamped to [-140, 60]
  std::int64_t with_interval = 0;  ///< errors whose quantity came with a 95 % interval
  std::int64_t covered = 0;        ///< of them: the interval holds the truth
  void add(double error);
  void add_interval(bool holds);
  void add(const ErrorStats& other);
  [[nodiscard]] double mean() const;  ///< of |error|
  [[nodiscard]] double bias() const;  ///< of error
  [[nodiscard]] double rms() const;
  [[nodiscard]] double quantile(
      double share) const;  ///< of |error|; upper edge of its bin, within 12 %
  [[nodiscard]] double coverage() const;
  friend bool operator==(const ErrorStats&, const ErrorStats&) = default;
};

struct GeometryScore {
  ErrorStats normal_deg;  ///< [deg] angle between measured and true normal, sign left out
  ErrorStats
      offset;  ///< [m] of the measured centroid from the true plane; interval from centroid_sigma
  ErrorStats length;     ///< [m] measured - true longer side, of faces seen nearly whole
  ErrorStats width;      ///< [m] shorter side
  ErrorStats area;       ///< [m2]
  ErrorStats elevation;  ///< [m] height of horizontal planes in the world
  ErrorStats
      group_center;       ///< [m] centre of a found group's box from the centre of the thing's box
  ErrorStats group_size;  ///< [m] longest side of the group's box - that of the thing
  void add(const GeometryScore& other);
  friend bool operator==(const GeometryScore&, const GeometryScore&) = default;
};

/// Planes that were found correctly at Protocol::geometry_tolerance and whose truth has geometry.
/// Sizes are compared where the face is one face, at least `full_view` of it was seen. A `Measured`
/// that is only a lower bound holds when its low end does.
GeometryScore score_geometry(const ScanTruth& truth, const PlaneMatch& match,
                             const Surfaces& surfaces, const Scan& scan, const Protocol& protocol);
/// Groups (entities with members) that found a thing, against the box of that thing.
void score_groups(const ObjectSummary& summary, const Labelling& labelling, const Scan& scan,
                  const Scene& scene, GeometryScore& score);

}  // namespace scanchor
