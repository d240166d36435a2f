#include "perception/chance_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

constexpr float thick = 3.0F;    // the slab that is looked at, in thicknesses of the plane's own
constexpr double enough = 1000;  // points that decide; of larger planes a sample is looked at

// The part of a plane that its points cover, in squares of about one and a half spacings.
class Footprint {
 public:
  Footprint(const CanonicalCloud& cloud, const GrownPlane& grown,
            std::span<const std::uint32_t> members)
      : u_(grown.plane.axes.col(2).cast<float>()), v_(grown.plane.axes.col(1).cast<float>()) {
    float high_u = -3e38F, high_v = -3e38F;
    for (const auto p : members) {
      const Eigen::Vector3f x = cloud.point(p);
      low_u_ = std::min(low_u_, u_.dot(x));
      high_u = std::max(high_u, u_.dot(x));
      low_v_ = std::min(low_v_, v_.dot(x));
      high_v = std::max(high_v, v_.dot(x));
    }
    const auto& variances = grown.plane.variances;  // an even spread has 12 times as much extent^2
    const double area = 12.0 * std::sqrt(std::max(0.0, variances[1] * variances[2]));
    constexpr float most = 1000.0F;
    const float extent = std::max({high_u - low_u_, high_v - low_v_, 1e-6F});
    side_ =
        std::max(1.5F * static_cast<float>(std::sqrt(area / static_cast<double>(members.size()))),
                 extent / most);
    columns_ = static_cast<int>((high_u - low_u_) / side_) + 1;
    rows_ = static_cast<int>((high_v - low_v_) / side_) + 1;
    covered_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    for (const auto p : members) covered_[static_cast<std::size_t>(square(cloud.point(p)))] = 1;
    middle_ = 0.5F * Eigen::Vector2f(low_u_ + high_u, low_v_ + high_v);
    half_ = 0.5F * Eigen::Vector2f(high_u - low_u_, high_v - low_v_);
  }
  [[nodiscard]] bool covers(const Eigen::Vector3f& x) const {
    const int at = square(x);
    return at >= 0 && covered_[static_cast<std::size_t>(at)] != 0;
  }
  /// May a ball reach over the footprint?
  [[nodiscard]] bool near(const Eigen::Vector3f& x, float radius) const {
    return std::abs(u_.dot(x) - middle_.x()) <= half_.x() + radius &&
           std::abs(v_.dot(x) - middle_.y()) <= half_.y() + radius;
  }

 private:
  [[nodiscard]] int square(const Eigen::Vector3f& x) const {
    const float a = (u_.dot(x) - low_u_) / side_, b = (v_.dot(x) - low_v_) / side_;
    if (a < 0.0F || b < 0.0F || a >= static_cast<float>(columns_) || b >= static_cast<float>(rows_))
      return -1;
    return static_cast<int>(b) * columns_ + static_cast<int>(a);
  }
  Eigen::Vector3f u_, v_;
  Eigen::Vector2f middle_, half_;
  float low_u_ = 3e38F, low_v_ = 3e38F, side_ = 1.0F;
  int columns_ = 0, rows_ = 0;
  std::vector<char> covered_;
};

// Points in a plane's slab and on both sides of it, up to three times as far.
struct Profile {
  double inside = 0.0, above = 0.0, below = 0.0;
  void count(bool in, bool up) { (in ? inside : (up ? above : below)) += 1.0; }
  /// The border of something that fills a volume has points on one side only: the fuller side
  /// counts for both. Three points were needed to say where the plane is.
  [[nodiscard]] double log_chance() const {
    const double outside = 2.0 * std::max(above, below);
    return scanchor::log_chance(inside - 3.0, inside + outside - 3.0, 1.0 / thick);
  }
};

}  // namespace

double log_chance(double inside, double total, double share) {
  if (total <= 0.0) return 0.0;
  const double q = std::min(1.0, inside / total);
  if (q <= share) return 0.0;
  double relative = q * std::log(q / share);  // Kullback and Leibler's divergence
  if (q < 1.0) relative += (1.0 - q) * std::log((1.0 - q) / (1.0 - share));
  return -total * relative;
}

namespace {

class Judge {
 public:
  Judge(const CanonicalCloud& cloud, const CellTree& tree, const PlaneLabels& labels,
        const PlaneMembers& members, const std::vector<std::uint32_t>& order)
      : cloud_(cloud),
        tree_(tree),
        labels_(labels),
        members_(members),
        rank_(order.size()),
        balls_(tree.cells.size()),
        trials_(std::log(2.0 * static_cast<double>(tree.cells.size()))) {
    for (std::uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i;
    parallel_blocks(balls_.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) balls_[i] = ball_around(tree.cells[i]);
    });
  }

  struct Verdict {
    bool stands = false;
    std::vector<std::int32_t> trusted;  // planes whose points were taken for explained
  };

  // Of plane r, if all larger ones that still have their points stand.
  [[nodiscard]] Verdict judge(std::uint32_t r) const {
    Verdict verdict;
    const GrownPlane& grown = labels_.planes[r];
    const PlaneReach reach(grown);
    const Footprint footprint(cloud_, grown, members_[r]);
    const auto stride =
        1 + static_cast<std::uint32_t>(static_cast<double>(members_[r].size()) / enough);
    Profile wide, narrow;
    std::uint32_t leaves = 0;
    std::vector<std::uint32_t> open;
    const auto look_at = [&](std::uint32_t at) {
      if (may_reach(reach, grown, tree_.cells[at], balls_[at]) &&
          footprint.near(balls_[at].middle, balls_[at].radius))
        open.push_back(at);
    };
    look_at(0);
    while (!open.empty()) {
      const Cell& cell = tree_.cells[open.back()];
      open.pop_back();
      if (cell.children != 0) {
        for (std::uint32_t c = 0; c < cell.children; ++c) look_at(cell.child + c);
        continue;
      }
      if (leaves++ % stride != 0) continue;
      for (auto p = cell.begin; p < cell.end; ++p) {
        const auto label = labels_.of_point[p];
        const bool own = label == static_cast<std::int32_t>(r);
        if (!own && label >= 0 && rank_[static_cast<std::size_t>(label)] < rank_[r]) {
          auto& trusted = verdict.trusted;
          if (!trusted.empty() && trusted.back() == label) continue;
          if (std::find(trusted.begin(), trusted.end(), label) == trusted.end())
            trusted.push_back(label);
          continue;
        }
        const float away = reach.distance(cloud_.x[p], cloud_.y[p], cloud_.z[p]) /
                           (3.0F * reach.scatter(cloud_.inverse_range[p]));
        if (away > thick || !footprint.covers(cloud_.point(p))) continue;
        const bool above = reach.above(cloud_.x[p], cloud_.y[p], cloud_.z[p]);
        if (own || away > 1.0F) wide.count(own, above);
        if (away <= 0.5F * thick) narrow.count(away <= 0.5F, above);
      }
    }
    // The plane was moved to where its middle is fullest: one trial for each choice of three
    // points.
    const double moved = 3.0 * std::log(static_cast<double>(members_[r].size()));
    verdict.stands = wide.log_chance() < -trials_ || narrow.log_chance() < -trials_ - moved;
    return verdict;
  }

 private:
  struct Ball {
    Eigen::Vector3f middle;
    float radius;
  };
  // Around the cube of the cell, from the place of its first point.
  [[nodiscard]] Ball ball_around(const Cell& cell) const {
    const float side = cloud_.cell_side(cell.level);
    const Eigen::Array3f first = ((cloud_.point(cell.begin) - cloud_.low) / side).array();
    // A floor: none is negative.
    return {cloud_.low + side * (first.cast<int>().cast<float>() + 0.5F).matrix(), 0.8661F * side};
  }
  [[nodiscard]] bool may_reach(const PlaneReach& reach, const GrownPlane& grown, const Cell& cell,
                               const Ball& ball) const {
    const auto& m = ball.middle;
    const float distance = reach.distance(m.x(), m.y(), m.z()) - ball.radius;
    if (distance <= 3.0F * thick * reach.least) return true;
    if (reach.height <= 0.0F) return false;
    // The nearest point decides; cells near the sensor are small.
    const float inverse = cloud_.inverse_range[cell.begin];
    float widest = 2.0F * reach.scatter(inverse);
    if (cell.children != 0 && cell.size() > 64) {
      // No point of the cell is nearer to the sensor than the first by more than its diagonal.
      const float nearest = 1.0F - 2.0F * ball.radius * inverse;
      widest = nearest > 0.5F ? 2.0F * reach.scatter(inverse / nearest)
                              : std::max(widest, static_cast<float>(grown.sigma) * 4.0F);
    }
    return distance <= 3.0F * thick * widest;
  }

  const CanonicalCloud& cloud_;
  const CellTree& tree_;
  const PlaneLabels& labels_;
  const PlaneMembers& members_;
  std::vector<std::uint32_t> rank_;  // by plane: how many are larger
  std::vector<Ball> balls_;          // by cell
  double trials_;
};

}  // namespace

void drop_chance_planes(const CanonicalCloud& cloud, const CellTree& tree, PlaneLabels& labels) {
  if (tree.cells.empty()) return;
  const PlaneMembers members(labels);
  std::vector<std::uint32_t> order(labels.planes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return members[a].size() > members[b].size(); });
  const Judge judge(cloud, tree, labels, members, order);
  while (!order.empty() && members[order.back()].size() < 3) order.pop_back();
  // Some at a time, as if each larger one stood, which most do; who trusted one that fell is judged
  // again when its turn comes. So the verdicts are those of one plane after the other.
  constexpr std::size_t at_a_time = 32;
  std::vector<char> fell(labels.planes.size(), 0);
  for (std::size_t from = 0; from < order.size(); from += at_a_time) {
    const std::size_t count = std::min(at_a_time, order.size() - from);
    std::array<Judge::Verdict, at_a_time> verdicts;
    parallel_blocks(
        count, 1, [&](std::size_t k, std::size_t) { verdicts[k] = judge.judge(order[from + k]); });
    for (std::size_t k = 0; k < count; ++k) {
      const auto r = order[from + k];
      for (const auto other : verdicts[k].trusted) {
        if (fell[static_cast<std::size_t>(other)] == 0) continue;
        verdicts[k] = judge.judge(r);
        break;
      }
      if (verdicts[k].stands) continue;
      fell[r] = 1;
      for (const auto p : members[r]) labels.of_point[p] = -1;
    }
  }
}

}  // namespace scanchor
