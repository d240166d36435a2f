#pragma once
// The last word at the level of points: each point of the pool chooses between the planes around
// it.

#include <cstdint>
#include <vector>

#include "perception/point_pool.hpp"

namespace scanchor {

/// Adds the points of the pool to the sums of their planes, each in the order of the points.
void add_by_label(const CanonicalCloud& cloud, const std::vector<std::int32_t>& label,
                  std::vector<Moments>& sums);

/// A point takes the plane with the least   r^2 / (2 s^2) + ln s - ln(votes)   among those within
/// 3 s, where r is its distance, s the plane's scatter and the votes are the points in its own and
/// the neighbouring leaves that chose it before: iterated conditional modes (J. Besag, "On the
/// statistical analysis of dirty pictures", JRSS B 48, 1986). After each round the planes follow
/// their points. Votes are kept from round to round: few of them change.
class PlaneChoice {
 public:
  PlaneChoice(const PointPool& pool, const BeamNoise& noise);

  /// `label`: plane of each pool point, -1 none; `fixed`: moments of the points that do not choose,
  /// a plane.
  void choose(const std::vector<Moments>& fixed, int rounds, std::vector<GrownPlane>& planes,
              std::vector<std::int32_t>& label);

 private:
  struct Vote {
    std::int32_t id;
    float votes;
    bool operator==(const Vote&) const = default;
  };
  static constexpr std::size_t kept = 6;  ///< candidates a leaf; where there are more, none is kept
  static constexpr std::uint8_t not_kept = 255;

  const PointPool& pool_;
  const BeamNoise& noise_;
  std::vector<std::uint32_t> start_;  ///< of leaf i: votes_[start_[i] .. start_[i + 1])
  std::vector<Vote> votes_;           ///< points by label within each leaf
  std::vector<char> changed_;         ///< a leaf: its votes are not those of the round before
  std::vector<Vote> candidates_;      ///< `kept` a leaf: the votes around it
  std::vector<std::uint8_t> candidate_count_;

  class Ballot;
  void count_votes(const std::vector<std::int32_t>& label);
  void count_around(std::uint32_t leaf, Ballot& ballot);
};

}  // namespace scanchor
