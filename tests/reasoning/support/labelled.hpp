#pragma once
// A labelled scene by hand: what each surface is, and how surely.

#include "tests/reasoning/support/built.hpp"

namespace scanchor::test {

struct Named {
  Plate plate;
  std::string label;
  double probability = 0.9;  ///< the rest is unknown
};

struct LabelledScene {
  Surfaces surfaces;
  Labelling labelling;
};

/// One thing a surface; the sensor stands at `eye`.
LabelledScene labelled(const std::vector<Named>& things, const Eigen::Vector3d& eye = {0, 0, 1.4});

/// Makes the last `members` surfaces one group of this class.
void add_group(LabelledScene& scene, const std::vector<std::int32_t>& members,
               const std::string& label, double probability = 0.9);

}  // namespace scanchor::test
