#include "perception/connect_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "perception/beam_grid.hpp"
#include "perception/join_planes.hpp"

namespace scanchor {
namespace {

constexpr std::int32_t none = -1;

// What the beams of a cell say of a plane.
enum class Sight : std::uint8_t { empty, passed, blocked, on };

class Connector {
 public:
  Connector(const CanonicalCloud& cloud, const BeamNoise& noise, PlaneLabels& labels)
      : cloud_(cloud), noise_(noise), labels_(labels), grid_(cloud, noise.sensor) {
    piece_.assign(grid_.cell_count(), none);
    sight_.assign(grid_.cell_count(), 0);
    seen_.assign(grid_.cell_count(), 0);
  }

  void split(std::size_t fewest) {
    const PlaneMembers members(labels_);
    const std::size_t planes = labels_.planes.size();
    for (std::size_t r = 0; r < planes; ++r) {
      if (!members[r].empty()) split_plane(r, members[r], fewest);
    }
  }

  void join() {
    auto& planes = labels_.planes;
    const PlaneMembers members(labels_);
    for (std::uint32_t i = 0; i < cloud_.size(); ++i) {
      if (labels_.of_point[i] >= 0) piece_[grid_.cell_of_point(i)] = labels_.of_point[i];
    }
    std::vector<std::uint32_t> order;
    for (std::uint32_t r = 0; r < planes.size(); ++r) {
      if (!members[r].empty()) order.push_back(r);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return members[a].size() > members[b].size(); });
    std::vector<bool> gone(planes.size(), false);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto a = order[i];
      if (gone[a]) continue;
      ask_about(planes[a]);
      // Twice: with what it won the plane is known farther out.
      for (int round = 0, won = 1; round < 2 && won > 0; ++round) {
        won = 0;
        for (std::size_t j = i + 1; j < order.size(); ++j) {
          const auto b = order[j];
          if (gone[b] || !lie_in_one_plane(planes[a], planes[b], noise_)) continue;
          std::vector<std::uint32_t> cells;
          for (const auto p : members[b]) cells.push_back(grid_.cell_of_point(p));
          std::sort(cells.begin(), cells.end());
          cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
          if (!hidden_path(cells, static_cast<std::int32_t>(a))) continue;
          Moments both = planes[a].moments;
          both.add(planes[b].moments);
          planes[a] = grown_plane(both, noise_);
          for (const auto p : members[b]) {
            labels_.of_point[p] = static_cast<std::int32_t>(a);
            piece_[grid_.cell_of_point(p)] = static_cast<std::int32_t>(a);
          }
          gone[b] = true;
          planes[b].moments = Moments{};
          ++won;
        }
        if (won > 0) ask_about(planes[a]);
      }
    }
  }

 private:
  void ask_about(const GrownPlane& grown) {
    reach_ = PlaneReach(grown);
    side_ = grown.plane.distance(noise_.sensor) >= 0.0 ? 1.0F : -1.0F;
    ++asking_;
  }

  Sight sight(std::uint32_t cell) {
    if (sight_[cell] >> 2 == asking_) return static_cast<Sight>(sight_[cell] & 3U);
    Sight what = Sight::empty;
    for (const auto p : grid_.points(cell)) {
      const float d = side_ * (reach_.a * cloud_.x[p] + reach_.b * cloud_.y[p] +
                               reach_.c * cloud_.z[p] - reach_.offset);
      const float s = 3.5F * reach_.scatter(cloud_.inverse_range[p]);
      what = std::max(what, d < -s ? Sight::passed : (d > s ? Sight::blocked : Sight::on));
      if (what == Sight::on) break;
    }
    sight_[cell] = asking_ << 2 | static_cast<std::uint32_t>(what);
    return what;
  }

  // Calls f for the cells up to two away that are `wanted`, but not across a cell that a beam
  // passed.
  template <class Wanted, class F>
  void around(std::uint32_t cell, const Wanted& wanted, const F& f) {
    const auto cells = grid_.around<2>(cell);
    for (int k = 0; k < 25; ++k) {
      const auto next = cells[static_cast<std::size_t>(k)];
      if (k == 12 || !wanted(next)) continue;
      // One of the cells half-way; where there are two, either would do.
      const int middle = half_way[static_cast<std::size_t>(k)];
      if (middle != 12 && sight(cells[static_cast<std::size_t>(middle)]) == Sight::passed) continue;
      f(next);
    }
  }
  // Of the cells in `around<2>`, the one between each and the middle; the middle itself where there
  // is none.
  static constexpr std::array<int, 25> half_way = [] {
    std::array<int, 25> middle{};
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx)
        middle[static_cast<std::size_t>(12 + 5 * dy + dx)] = 12 + 5 * (dy / 2) + dx / 2;
    }
    return middle;
  }();

  void split_plane(std::size_t r, std::span<const std::uint32_t> members, std::size_t fewest) {
    ask_about(labels_.planes[r]);
    constexpr std::int32_t waiting = -2;
    std::vector<std::uint32_t> cells;
    for (const auto p : members) {
      const auto cell = grid_.cell_of_point(p);
      if (piece_[cell] == waiting) continue;
      piece_[cell] = waiting;
      cells.push_back(cell);
    }
    std::int32_t pieces = 0;
    std::vector<std::uint32_t> rim;  // cells with one beside them that is not the plane's
    for (const auto first : cells) {
      if (piece_[first] != waiting) continue;
      rim.clear();
      queue_.assign(1, first);
      piece_[first] = pieces;
      const auto is_waiting = [&](std::uint32_t next) { return piece_[next] == waiting; };
      const auto reached = [&](std::uint32_t next) {
        piece_[next] = pieces;
        queue_.push_back(next);
      };
      // All that touches first; only then what lies one cell further, of which little is left.
      for (std::size_t head = 0, asked = 0;;) {
        if (head < queue_.size()) {
          const auto cell = queue_[head++];
          bool open = false;
          for (const auto next : grid_.around<1>(cell)) {
            open |= piece_[next] == none;
            if (is_waiting(next)) reached(next);
          }
          if (open) rim.push_back(cell);
        } else if (asked < rim.size()) {
          around(rim[asked++], is_waiting, reached);
        } else {
          break;
        }
      }
      ++pieces;
    }
    if (pieces > 1) {
      std::vector<Moments> sums(static_cast<std::size_t>(pieces));
      for (const auto p : members)
        sums[static_cast<std::size_t>(piece_[grid_.cell_of_point(p)])].add(cloud_.x[p], cloud_.y[p],
                                                                           cloud_.z[p]);
      std::size_t largest = 0;
      for (std::size_t k = 1; k < sums.size(); ++k) {
        if (sums[k].n > sums[largest].n) largest = k;
      }
      std::vector<std::int32_t> id(sums.size(), none);
      for (std::size_t k = 0; k < sums.size(); ++k) {
        if (k == largest) {
          id[k] = static_cast<std::int32_t>(r);
          labels_.planes[r] = grown_plane(sums[k], noise_);
        } else if (sums[k].n >= static_cast<double>(fewest)) {
          id[k] = static_cast<std::int32_t>(labels_.planes.size());
          labels_.planes.push_back(grown_plane(sums[k], noise_));
        } else if (hidden_path(cells_of(cells, static_cast<std::int32_t>(k)),
                               static_cast<std::int32_t>(largest))) {
          id[k] = static_cast<std::int32_t>(r);
        }
      }
      for (const auto p : members)
        labels_.of_point[p] = id[static_cast<std::size_t>(piece_[grid_.cell_of_point(p)])];
    }
    for (const auto cell : cells) piece_[cell] = none;
  }

  [[nodiscard]] std::vector<std::uint32_t> cells_of(const std::vector<std::uint32_t>& cells,
                                                    std::int32_t piece) const {
    std::vector<std::uint32_t> found;
    for (const auto cell : cells) {
      if (piece_[cell] == piece) found.push_back(cell);
    }
    return found;
  }

  // Is there a way from these cells to the piece through cells whose beams met something nearer or
  // the plane itself?
  bool hidden_path(const std::vector<std::uint32_t>& from, std::int32_t to) {
    queue_ = from;
    touched_ = from;
    for (const auto cell : queue_) seen_[cell] = 1;
    const std::size_t most = from.size() + (from.size() < 4 ? 50 : 400 + 4 * from.size());
    bool found = false;
    for (std::size_t head = 0; head < queue_.size() && head < most && !found; ++head) {
      around(
          queue_[head], [&](std::uint32_t next) { return seen_[next] == 0 || piece_[next] == to; },
          [&](std::uint32_t next) {
            if (piece_[next] == to) found = true;
            if (seen_[next] != 0) return;
            seen_[next] = 1;
            touched_.push_back(next);
            if (sight(next) >= Sight::blocked) queue_.push_back(next);
          });
    }
    for (const auto cell : touched_) seen_[cell] = 0;
    return found;
  }

  const CanonicalCloud& cloud_;
  const BeamNoise& noise_;
  PlaneLabels& labels_;
  BeamGrid grid_;
  std::vector<std::int32_t> piece_;
  std::vector<std::uint32_t> queue_, touched_;
  std::vector<char> seen_;            // by the search for a path
  std::vector<std::uint32_t> sight_;  // a Sight, and above it the number of the plane it is of
  std::uint32_t asking_ = 0;
  PlaneReach reach_{GrownPlane{}};
  float side_ = 1.0F;
};

}  // namespace

void connect_planes(const CanonicalCloud& cloud, const BeamNoise& noise, std::size_t fewest,
                    PlaneLabels& labels) {
  Connector connector(cloud, noise, labels);
  connector.split(fewest);
  connector.join();
}

}  // namespace scanchor
