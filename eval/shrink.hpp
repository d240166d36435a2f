#pragma once
// The smallest scene and the least noise on which something still fails: Zeller and Hildebrandt,
// "Simplifying and isolating failure-inducing input", IEEE TSE 28(2), 2002.

#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {

/// Indices of a smallest set that still fails: ddmin. `fails` must hold for all indices 0 ..
/// count-1 and is asked at most once for each set; the result is 1-minimal: leaving out any one of
/// its members makes the failure go away. Rising order.
std::vector<std::size_t> shrink_set(
    std::size_t count, const std::function<bool(const std::vector<std::size_t>&)>& fails);

/// A case: a settled scene, how it is scanned, and the seed of the scan.
struct FailingCase {
  Scene scene;
  LidarOptions lidar;
  std::uint64_t seed = 0;
  int pose = 0;  ///< index into Scene::sensor_poses
};

struct ShrinkStep {
  std::string text;  ///< "left out 14 of 20 things", "range_sigma 0.02 -> 0"
};

struct ShrinkResult {
  FailingCase smallest;
  std::vector<ShrinkStep> steps;
  int tried = 0;  ///< cases that were asked
};

/// Leaves out instances (ids stay), then poses that are not used, then sets effects of the LIDAR to
/// nothing or, where the failure needs them, to half as long as it still fails (down to a 16th).
/// `keep`: ids of instances that must stay (the thing that is missed). Throws Error(wrong_usage)
/// where the case does not fail to begin with.
ShrinkResult shrink_case(const FailingCase& start,
                         const std::function<bool(const FailingCase&)>& fails,
                         const std::vector<std::int32_t>& keep = {});

}  // namespace scanchor
