#pragma once
// Where the scene ends: below, above and around. What "lowest", "highest" and "outermost" are held
// against.

#include <vector>

#include "reasoning/item.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {

class SceneExtent {
 public:
  SceneExtent() = default;
  /// Of all items with a shape; `horizontal`: their evidence at the default tolerance, one an item.
  SceneExtent(const std::vector<Item>& items, const std::vector<Evidence>& horizontal);

  /// Lowest, highest or outermost, for items and groups of this scene; certain of nothing (0) for
  /// the other extrema and for what has no shape.
  [[nodiscard]] Evidence extremum(Extremum which, const Item& item,
                                  const Surrounding& around) const;

 private:
  [[nodiscard]] double outside_share(const Item& item) const;

  /// A large surface as "outermost" sees it.
  struct Patch {
    Eigen::Vector3d center, along, across;
    double area;  ///< [m2] beyond doubt
  };
  double low_level_ = 0.0,
         high_level_ = 0.0;  ///< [m] the 1st and 99th percentile of observed area over height
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();
  std::vector<Patch> largest_;
};

}  // namespace scanchor
