#pragma once
// From the middle of a beam to what comes back from all of it: sub-rays, glass, mirrors, echoes.

#include <cstdint>
#include <span>
#include <vector>

#include "sensors/echo.hpp"
#include "sensors/footprint.hpp"
#include "sensors/kinematics.hpp"
#include "sensors/line_returns.hpp"

namespace scanchor {

/// Traces the middles of beams, and then what more is needed. Const members may be called from any
/// thread.
class BeamTracer {
 public:
  BeamTracer(const World& world, const LidarOptions& options, std::uint64_t seed);

  /// The middles of a line's beams, in the world frame.
  void trace_middles(const BeamColumns& beams, LineReturns& returns) const;

  /// What footprint, glass and mirrors make of them. `straddles[k]` != 0: an edge may be in the
  /// footprint of beam k, so its sub-rays are traced; elsewhere they meet the plane that the middle
  /// met and are computed. Both give the same bytes wherever the footprint does lie on one face.
  void refine(int line, const BeamColumns& beams, std::span<const std::uint8_t> straddles,
              LineReturns& returns) const;

  [[nodiscard]] bool has_footprint() const { return footprint_.size() > 1; }
  [[nodiscard]] const BeamFootprint& footprint() const { return footprint_; }

 private:
  /// A stretch of a path that has still to be traced.
  struct Stretch {
    Ray ray;
    std::uint32_t beam;
    double weight;     // share of the beam's light, there and back
    double travelled;  // [m] so far
    std::uint8_t flags;
  };
  struct BeamSample {
    std::uint32_t beam;
    Sample sample;
  };
  void follow(std::vector<Stretch>& stretches, std::vector<BeamSample>& samples) const;
  void one_plane(int line, std::size_t k, const BeamColumns& beams, LineReturns& returns,
                 std::vector<Sample>& samples) const;
  static void store(const Echo& echo, std::size_t k, LineReturns& returns);

  const World& world_;
  LidarOptions options_;
  BeamFootprint footprint_;
};

}  // namespace scanchor
