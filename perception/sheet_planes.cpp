#include "perception/sheet_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "core/parallel.hpp"
#include "perception/height_map.hpp"
#include "perception/thin_planes.hpp"

namespace scanchor {
namespace {

constexpr std::size_t fewest_squares = 12;  // of a sheet

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class SheetFinder {
 public:
  explicit SheetFinder(const HeightMap& map) : map_(map), state(map.weight.size(), rest) {
    for (std::size_t i = 0; i < state.size(); ++i) {
      if (map.weight[i] > 0.0F) squares_.push_back(i);
    }
    tried_.assign(state.size(), 0);
  }

  // Looks for one more sheet in what is left; its squares get the number `id` in `state`.
  // False: there is none.
  bool find(int id, double scatter) {
    for (int attempt = 0; attempt < 6; ++attempt) {
      if (!seed(scatter)) return false;
      for (const auto at : sheet_) tried_[at] = 1;
      for (int round = 0; round < 8 && compete(); ++round) {
      }
      const bool stands = sheet_.size() >= fewest_squares && is_sheet(scatter);
      for (const auto at : sheet_) {
        state[at] = stands ? id : rest;
        tried_[at] = 1;
      }
      if (stands) return true;
    }
    ground_ = all_;
    ground_.fit();
    return false;
  }

  // Finds all sheets, and returns how many there are.
  int find_all(double scatter) {
    constexpr int most_sheets = 16;
    int sheets = 0;
    while (sheets < most_sheets && find(sheets, scatter)) ++sheets;
    return sheets;
  }

  // Do these points share their squares with those of `other`, and are the squares as high as one
  // plane through all? Then two planes parted the points of one by their noise. `scatter`: of that
  // plane, relative to the map's.
  [[nodiscard]] bool is_mixed_in(const CanonicalCloud& cloud, const HeightMap& other,
                                 std::span<const std::uint32_t> points, double scatter) const {
    constexpr std::size_t fewest = 3;
    std::size_t shared = 0;
    for (const auto p : points) shared += other.holds(cloud.point(p)) ? 1 : 0;
    if (10 * shared < points.size()) return false;  // the map may not even reach there
    std::vector<std::size_t> squares;
    for (const auto p : points) squares.push_back(map_.square(cloud.point(p)));
    std::sort(squares.begin(), squares.end());
    squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
    if (squares.size() < fewest) return false;
    double misfit = 0.0;
    for (const auto at : squares) {
      const double d = map_.height[at] - ground_.at(map_.place(at));
      misfit += map_.weight[at] * d * d;
    }
    return misfit < 1.5 * std::max(1.0, scatter * scatter) * static_cast<double>(squares.size());
  }

 private:
  static constexpr int rest = -1, candidate = -2;

  // The connected squares that stand out most on one side of the rest.
  bool seed(double scatter) {
    all_ = Tilt{};
    for (const auto at : squares_) {
      if (state[at] == rest) all_.add(map_.place(at), map_.weight[at], map_.height[at]);
    }
    ground_ = all_;
    ground_.fit();
    // Sums over three by three squares: of rows, then of those.
    std::vector<float> weight(state.size(), 0.0F), moment(state.size(), 0.0F);
    for (const auto at : squares_) {
      if (state[at] != rest) continue;
      const auto d = static_cast<float>(map_.height[at] - ground_.at(map_.place(at)));
      for (const auto i : {at - 1, at, at + 1}) {
        weight[i] += map_.weight[at];
        moment[i] += map_.weight[at] * d;
      }
    }
    std::vector<signed char> side(state.size(), 0);
    std::vector<float> out(state.size(), 0.0F);
    const auto row = static_cast<std::size_t>(map_.columns);
    const auto least = static_cast<float>(0.5 * scatter);
    for (const auto at : squares_) {
      if (state[at] != rest || tried_[at] != 0) continue;
      const float w = weight[at - row] + weight[at] + weight[at + row];
      const float mean = (moment[at - row] + moment[at] + moment[at + row]) / w;
      if (std::abs(mean) < least || mean * mean * w < 12.0F) continue;
      side[at] = mean > 0.0F ? 1 : -1;
      out[at] = mean * mean * map_.weight[at];
    }
    sheet_.clear();
    double best = 0.0;
    std::vector<std::size_t> queue;
    for (const auto first : squares_) {
      if (side[first] == 0) continue;
      const auto sign = side[first];
      double sum = 0.0;
      queue.assign(1, first);
      side[first] = 0;
      for (std::size_t head = 0; head < queue.size(); ++head) {
        sum += out[queue[head]];
        for (const auto next : map_.beside(queue[head])) {
          if (side[next] != sign) continue;
          side[next] = 0;
          queue.push_back(next);
        }
      }
      if (sum <= best || queue.size() < fewest_squares / 2) continue;
      best = sum;
      sheet_ = queue;
    }
    for (const auto at : sheet_) state[at] = candidate;
    return !sheet_.empty();
  }

  void fit_both() {
    lifted_ = Tilt{};
    for (const auto at : sheet_) lifted_.add(map_.place(at), map_.weight[at], map_.height[at]);
    ground_ = all_;
    ground_.remove(lifted_);
    lifted_.fit();
    ground_.fit();
  }

  // Both planes follow their squares, then the squares at the border choose again, each with those
  // around it. False: nothing changed.
  bool compete() {
    fit_both();
    const auto prefers_sheet = [&](std::size_t at) {
      return map_.around(at, [&](std::size_t i) {
        if (map_.weight[i] <= 0.0F || state[i] >= 0) return 0.0;
        const auto place = map_.place(i);
        const double a = map_.height[i] - ground_.at(place), b = map_.height[i] - lifted_.at(place);
        return map_.weight[i] * (a * a - b * b);
      }) > 0.0;
    };
    std::vector<std::size_t> lost, won;
    for (const auto at : sheet_) {
      if (!prefers_sheet(at)) lost.push_back(at);
      for (const auto next : map_.beside(at)) {
        if (state[next] == rest && map_.weight[next] > 0.0F && prefers_sheet(next))
          won.push_back(next);
      }
    }
    for (const auto at : lost) state[at] = rest;
    for (const auto at : won) {
      if (state[at] == candidate) continue;
      state[at] = candidate;
      sheet_.push_back(at);
    }
    sheet_.erase(std::remove_if(sheet_.begin(), sheet_.end(),
                                [&](std::size_t at) { return state[at] != candidate; }),
                 sheet_.end());
    return !lost.empty() || !won.empty();
  }

  bool is_sheet(double scatter) {
    fit_both();
    const auto misfit = [&](std::size_t at, const Tilt& tilt) {
      const double d = map_.height[at] - tilt.at(map_.place(at));
      return map_.weight[at] * d * d;
    };
    double gain = 0.0;
    std::vector<double> inside, outside, steps, rises;
    for (const auto at : sheet_) {
      inside.push_back(misfit(at, lifted_));
      gain += misfit(at, ground_) - inside.back();
    }
    // Across the border, one square left out on each side, since it holds points of both. Medians:
    // a third thing may stand there too.
    double expected = 0.0;
    std::size_t border = 0;
    for (const auto at : sheet_) {
      for (const auto next : map_.beside(at)) {
        if (state[next] != rest) continue;
        ++border;
        const auto across = static_cast<std::ptrdiff_t>(next) - static_cast<std::ptrdiff_t>(at);
        const auto in = at - static_cast<std::size_t>(across),
                   out = next + static_cast<std::size_t>(across);
        if (out >= state.size() || in >= state.size() || map_.weight[next] <= 0.0F ||
            state[in] != candidate || state[out] != rest || map_.weight[out] <= 0.0F)
          continue;
        steps.push_back(map_.height[in] - map_.height[out]);
        rises.push_back(map_.height[at] - map_.height[next]);
        expected += lifted_.at(map_.place(next)) - ground_.at(map_.place(next));
        outside.push_back(misfit(out, ground_));
      }
    }
    if (4 * steps.size() < border || steps.size() < 6) return false;  // it borders on nothing
    expected /= static_cast<double>(steps.size());
    // A slope would rise by a third of the step between the two squares in the middle.
    const double step = median_of(steps) / expected, rise = median_of(rises) / expected;
    return gain > 16.3 + 2.0 * static_cast<double>(border) && std::abs(expected) >= 0.5 * scatter &&
           step >= 0.7 && step <= 1.5 && rise >= 0.45 * step && median_of(inside) < 2.0 &&
           median_of(outside) < 2.0;
  }

  const HeightMap& map_;
  std::vector<std::size_t> squares_, sheet_;
  std::vector<char> tried_;
  Tilt all_, ground_, lifted_;

 public:
  std::vector<int> state;  // by square: the number of its sheet, or `rest`
};

// Are both nearly parallel, and the smaller one within reach of the larger one's noise?
bool lies_close(const GrownPlane& large, const GrownPlane& small, const BeamNoise& noise) {
  constexpr double turn = 0.97, apart = 5.0;
  if (small.moments.n < 3.0) return false;
  if (!(std::abs(large.plane.normal.dot(small.plane.normal)) > turn)) return false;
  const Eigen::Vector3d there = small.moments.mean();
  return std::abs(large.plane.distance(there)) < apart * noise.across(large.plane, there);
}

// What can be said of a plane before its turn comes.
struct Outlook {
  struct Near {
    std::uint32_t plane;
    bool beside;  // of its points a tenth lie where the plane has some
  };
  std::optional<HeightMap> alone;
  std::vector<Near> near;  // smaller planes so close that points of one sheet may be on either
  std::vector<std::uint32_t> points;  // with those of what lies beside; none: nothing does
  std::optional<HeightMap> together;
  std::optional<SheetFinder> finder;
  int sheets = 0;

  [[nodiscard]] const HeightMap& map() const { return together ? *together : *alone; }

  // `order`: the plane and all smaller ones.
  void look(const CanonicalCloud& cloud, const std::vector<GrownPlane>& planes,
            const PlaneMembers& members, const BeamNoise& noise,
            std::span<const std::uint32_t> order) {
    const GrownPlane& whole = planes[order[0]];
    alone.emplace(cloud, whole, members[order[0]]);
    for (const auto q : order.subspan(1)) {
      if (members[q].size() < 3) break;
      if (!lies_close(whole, planes[q], noise)) continue;
      std::size_t within = 0;
      for (const auto p : members[q]) within += alone->is_beside(cloud.point(p)) ? 1 : 0;
      near.push_back({q, 10 * within >= members[q].size()});
    }
    find(cloud, whole, order[0], members);
  }

  // Forgets planes that are settled by now.
  void look_again(const CanonicalCloud& cloud, const GrownPlane& whole, std::uint32_t plane,
                  const PlaneMembers& members, const std::vector<char>& settled) {
    const auto is_settled = [&](const Near& other) { return settled[other.plane] != 0; };
    const bool fewer = std::any_of(near.begin(), near.end(), [&](const Near& other) {
      return other.beside && is_settled(other);
    });
    near.erase(std::remove_if(near.begin(), near.end(), is_settled), near.end());
    if (fewer) find(cloud, whole, plane, members);
  }

 private:
  void find(const CanonicalCloud& cloud, const GrownPlane& whole, std::uint32_t plane,
            const PlaneMembers& members) {
    points.clear();
    for (const auto& other : near) {
      if (!other.beside) continue;
      if (points.empty()) points.assign(members[plane].begin(), members[plane].end());
      points.insert(points.end(), members[other.plane].begin(), members[other.plane].end());
    }
    together.reset();
    if (!points.empty()) together.emplace(cloud, whole, points);
    finder.emplace(map());
    sheets = finder->find_all(whole.sigma);
  }
};

}  // namespace

void split_sheets(const CanonicalCloud& cloud, PlaneLabels& labels, const BeamNoise& noise) {
  constexpr auto fewest =
      static_cast<std::size_t>(3.0 * HeightMap::points_per_square * fewest_squares);
  const PlaneMembers members(labels);
  std::vector<std::uint32_t> order(labels.planes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return members[a].size() > members[b].size(); });
  std::vector<char> settled(labels.planes.size(), 0);
  // A plane that no other gave points to or took from is as it was, so much can be known
  // beforehand.
  std::vector<Outlook> outlooks(order.size());
  parallel_blocks(order.size(), 1, [&](std::size_t i, std::size_t) {
    if (members[order[i]].size() >= fewest)
      outlooks[i].look(cloud, labels.planes, members, noise, {&order[i], order.size() - i});
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto r = order[i];
    if (members[r].size() < fewest) break;
    if (settled[r] != 0) continue;
    const GrownPlane whole = labels.planes[r];
    Outlook& outlook = outlooks[i];
    outlook.look_again(cloud, whole, r, members, settled);
    const std::span<const std::uint32_t> points =
        outlook.points.empty() ? members[r] : outlook.points;
    const HeightMap& map = outlook.map();
    const SheetFinder& finder = *outlook.finder;
    const int sheets = outlook.sheets;
    if (sheets == 0) {
      for (const auto& [q, beside] : outlook.near) {
        Moments both = labels.planes[r].moments;
        both.add(labels.planes[q].moments);
        const GrownPlane one = grown_plane(both, noise);
        // The halves of a wall that noise parted scatter by less than the wall does.
        if (!finder.is_mixed_in(cloud, *outlook.alone, members[q], one.sigma / whole.sigma))
          continue;
        labels.planes[r] = one;
        labels.planes[q].moments = Moments{};
        settled[q] = 1;
        for (const auto p : members[q]) labels.of_point[p] = static_cast<std::int32_t>(r);
      }
      continue;
    }
    std::vector<Moments> sums(static_cast<std::size_t>(sheets) + 1);
    std::vector<GrownPlane> planes;
    for (const auto p : points) {
      const int sheet = finder.state[map.square(cloud.point(p))];
      sums[static_cast<std::size_t>(sheet + 1)].add(cloud.x[p], cloud.y[p], cloud.z[p]);
    }
    for (const auto& sum : sums) planes.push_back(grown_plane(sum, noise));
    std::vector<PlaneReach> reach(planes.begin(), planes.end());
    for (const auto p : points) {
      const auto k = static_cast<std::size_t>(finder.state[map.square(cloud.point(p))] + 1);
      auto& label = labels.of_point[p];
      // What stands out from its sheet and was another plane's stays there.
      if (label != static_cast<std::int32_t>(r) &&
          !reach[k].holds(cloud.x[p], cloud.y[p], cloud.z[p], cloud.inverse_range[p]))
        continue;
      label = k == 0 ? static_cast<std::int32_t>(r)
                     : static_cast<std::int32_t>(labels.planes.size() + k - 1);
    }
    labels.planes[r] = planes[0];
    labels.planes.insert(labels.planes.end(), planes.begin() + 1, planes.end());
    // Those that gave points follow what they kept.
    for (const auto& [q, beside] : outlook.near) {
      Moments left;
      for (const auto p : members[q]) {
        if (labels.of_point[p] == static_cast<std::int32_t>(q))
          left.add(cloud.x[p], cloud.y[p], cloud.z[p]);
      }
      if (left.n == labels.planes[q].moments.n) continue;
      settled[q] = 1;
      if (left.n >= static_cast<double>(fewest_points)) {
        labels.planes[q] = grown_plane(left, noise);
        continue;
      }
      labels.planes[q].moments = Moments{};
      for (const auto p : members[q]) {
        if (labels.of_point[p] == static_cast<std::int32_t>(q)) labels.of_point[p] = -1;
      }
    }
  }
}

}  // namespace scanchor
