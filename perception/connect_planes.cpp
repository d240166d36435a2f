#include "perception/connect_planes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <mutex>
#include <numeric>

#include "core/parallel.hpp"
#include "perception/join_planes.hpp"
#include "perception/tile_fill.hpp"

namespace scanchor {
namespace {

constexpr std::int32_t no_piece = -1;

// What the beams of a cell say of a plane.
enum class Sight : std::uint8_t { empty, passed, blocked, on };

// What a search over the grid keeps of each cell.
class CellSearch {
 public:
  CellSearch(const CanonicalCloud& cloud, const BeamGrid& grid)
      : piece(grid.cell_count(), no_piece),
        cloud_(cloud),
        grid_(grid),
        sight_(grid.cell_count(), 0),
        seen_(grid.cell_count(), 0),
        fill_(grid) {}

  void ask_about(const GrownPlane& grown, const BeamNoise& noise) {
    reach_ = PlaneReach(grown);
    side_ = grown.plane.distance(noise.sensor) >= 0.0 ? 1.0F : -1.0F;
    ++asking_;
  }

  // Parts the cells of a plane's points by what hangs together, and returns how many parts there
  // are. Of more than one, `piece` of each cell is its number, from 0. Also returns the cells.
  std::int32_t find_pieces(std::span<const std::uint32_t> members,
                           std::vector<std::uint32_t>& cells) {
    cells.clear();
    fill_.clear();
    for (const auto p : members) {
      const auto cell = grid_.cell_of_point(p);
      if (fill_.add(cell)) cells.push_back(cell);
    }
    std::int32_t pieces = 0;
    std::size_t left = cells.size();
    const auto is_waiting = [&](std::uint32_t next) { return fill_.is_waiting(next); };
    std::vector<std::pair<std::uint32_t, std::uint64_t>> taken;  // tile and cells
    std::vector<std::uint32_t> rim;  // with a cell beside them that is not the plane's
    for (const auto first : cells) {
      if (!fill_.is_waiting(first)) continue;
      taken.clear();
      rim.clear();
      std::size_t size = 0;
      fill_.reach(first);
      // All that touches first; only then what lies one cell further, of which little is left.
      for (std::size_t asked = 0;;) {
        fill_.take([&](std::uint32_t tile, std::uint64_t some, std::uint64_t at_rim) {
          taken.emplace_back(tile, some);
          size += static_cast<std::size_t>(std::popcount(some));
          TileFill::each_cell(tile, at_rim, [&](std::uint32_t cell) { rim.push_back(cell); });
        });
        if (asked == rim.size() || size == left) break;
        const auto cell = rim[asked++];
        if (fill_.waits_near(cell))
          around(cell, is_waiting, [&](std::uint32_t next) { fill_.reach(next); });
      }
      if (size < cells.size()) {
        for (const auto& [tile, some] : taken)
          TileFill::each_cell(tile, some, [&](std::uint32_t cell) { piece[cell] = pieces; });
      }
      left -= size;
      ++pieces;
    }
    return pieces;
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
          queue_[head], [&](std::uint32_t next) { return seen_[next] == 0 || piece[next] == to; },
          [&](std::uint32_t next) {
            if (piece[next] == to) found = true;
            if (seen_[next] != 0) return;
            seen_[next] = 1;
            touched_.push_back(next);
            if (sight(next) >= Sight::blocked) queue_.push_back(next);
          });
    }
    for (const auto cell : touched_) seen_[cell] = 0;
    return found;
  }

  // Was the plane hidden on most straight ways from one piece to the next of the other? A path can
  // go round by a thin thing that touches both, such as the board that two boxes stand on.
  [[nodiscard]] bool mostly_hidden(std::span<const std::uint32_t> from,
                                   std::span<const std::uint32_t> to, const PlaneLabels& labels,
                                   const Eigen::Vector3f& sensor) {
    constexpr std::size_t most_ways = 24, most_ends = 192;
    const std::size_t ways = std::min(from.size(), most_ways),
                      ends = std::min(to.size(), most_ends);
    const auto of_either = [&](std::uint32_t p) {
      return labels.of_point[p] == labels.of_point[from[0]] ||
             labels.of_point[p] == labels.of_point[to[0]];
    };
    std::size_t hidden = 0, open = 0;
    for (std::size_t i = 0; i < ways && 2 * std::max(hidden, open) <= ways; ++i) {
      const Eigen::Vector3f start = cloud_.point(from[(2 * i + 1) * from.size() / (2 * ways)]);
      Eigen::Vector3f way = Eigen::Vector3f::Constant(1e18F);
      for (std::size_t j = 0; j < ends; ++j) {
        const Eigen::Vector3f there =
            cloud_.point(to[(2 * j + 1) * to.size() / (2 * ends)]) - start;
        if (there.squaredNorm() < way.squaredNorm()) way = there;
      }
      ++(is_hidden(start - sensor, way, of_either) ? hidden : open);
    }
    return hidden >= open;
  }

  std::vector<std::int32_t> piece;  // by cell; `no_piece` between searches

 private:
  // Did no beam pass the plane on this way from a place of it, but for cells with points that count
  // as the plane's own?
  template <class Own>
  bool is_hidden(const Eigen::Vector3f& start, const Eigen::Vector3f& way, const Own& own) {
    constexpr int steps = 64;
    std::uint32_t last = 0;
    for (int k = 1; k < steps; ++k) {
      const auto cell = grid_.cell_towards(start + way * (static_cast<float>(k) / steps));
      if (cell == last) continue;
      last = cell;
      const auto points = grid_.points(cell);
      if (sight(cell) == Sight::passed && std::none_of(points.begin(), points.end(), own))
        return false;
    }
    return true;
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
    for (std::size_t k = 0; k < 25; ++k) {
      const auto next = cells[k];
      if (k == 12 || !wanted(next)) continue;
      // One of the cells half-way; where there are two, either would do.
      const std::size_t middle = half_way[k];
      if (middle != 12 && sight(cells[middle]) == Sight::passed) continue;
      f(next);
    }
  }
  // Of the cells in `around<2>`, the one between each and the middle; the middle itself where there
  // is none.
  static constexpr std::array<std::size_t, 25> half_way = [] {
    std::array<std::size_t, 25> middle{};
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx)
        middle[static_cast<std::size_t>(12 + 5 * dy + dx)] =
            static_cast<std::size_t>(12 + 5 * (dy / 2) + dx / 2);
    }
    return middle;
  }();

  const CanonicalCloud& cloud_;
  const BeamGrid& grid_;
  std::vector<std::uint32_t> queue_, touched_;
  std::vector<std::uint32_t> sight_;  // a Sight, and above it the number of the plane it is of
  std::vector<char> seen_;            // by the search for a path
  TileFill fill_;
  std::uint32_t asking_ = 0;
  PlaneReach reach_{GrownPlane{}};
  float side_ = 1.0F;
};

// Searches are large: each thread takes one that is free.
class Searches {
 public:
  Searches(const CanonicalCloud& cloud, const BeamGrid& grid) : cloud_(cloud), grid_(grid) {}
  std::unique_ptr<CellSearch> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<CellSearch>(cloud_, grid_);
    auto search = std::move(free_.back());
    free_.pop_back();
    return search;
  }
  void give_back(std::unique_ptr<CellSearch> search) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(search));
  }

 private:
  const CanonicalCloud& cloud_;
  const BeamGrid& grid_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<CellSearch>> free_;
};

std::vector<std::uint32_t> cells_of(const BeamGrid& grid, std::span<const std::uint32_t> members) {
  std::vector<std::uint32_t> cells;
  cells.reserve(members.size());
  for (const auto p : members) cells.push_back(grid.cell_of_point(p));
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

// Parts plane r: its largest piece keeps the number; the points of others of at least `fewest` get
// the labels -2, -3 and so on, and their planes are returned.
std::vector<GrownPlane> split_plane(const CanonicalCloud& cloud, const BeamGrid& grid,
                                    const BeamNoise& noise, std::size_t fewest, std::size_t r,
                                    std::span<const std::uint32_t> members, CellSearch& search,
                                    PlaneLabels& labels) {
  std::vector<GrownPlane> more;
  std::vector<std::uint32_t> cells;
  search.ask_about(labels.planes[r], noise);
  const auto pieces = static_cast<std::size_t>(search.find_pieces(members, cells));
  if (pieces > 1) {
    const auto piece_of = [&](std::uint32_t cell) {
      return static_cast<std::size_t>(search.piece[cell]);
    };
    std::vector<Moments> sums(pieces);
    for (const auto p : members)
      sums[piece_of(grid.cell_of_point(p))].add(cloud.x[p], cloud.y[p], cloud.z[p]);
    std::vector<std::vector<std::uint32_t>> cells_of_piece(pieces);
    std::size_t largest = 0;
    for (std::size_t k = 1; k < pieces; ++k) {
      if (sums[k].n > sums[largest].n) largest = k;
    }
    for (const auto cell : cells) {
      if (piece_of(cell) != largest) cells_of_piece[piece_of(cell)].push_back(cell);
    }
    std::vector<std::int32_t> id(pieces, no_piece);
    for (std::size_t k = 0; k < pieces; ++k) {
      if (k == largest) {
        id[k] = static_cast<std::int32_t>(r);
        labels.planes[r] = grown_plane(sums[k], noise);
      } else if (sums[k].n >= static_cast<double>(fewest)) {
        id[k] = -2 - static_cast<std::int32_t>(more.size());
        more.push_back(grown_plane(sums[k], noise));
      } else if (search.hidden_path(cells_of_piece[k], static_cast<std::int32_t>(largest))) {
        id[k] = static_cast<std::int32_t>(r);
      }
    }
    for (const auto p : members) labels.of_point[p] = id[piece_of(grid.cell_of_point(p))];
  }
  if (pieces > 1) {
    for (const auto cell : cells) search.piece[cell] = no_piece;
  }
  return more;
}

void split(const CanonicalCloud& cloud, const BeamGrid& grid, const BeamNoise& noise,
           std::size_t fewest, Searches& searches, PlaneLabels& labels) {
  const PlaneMembers members(labels);
  const std::size_t planes = labels.planes.size();
  std::vector<std::vector<GrownPlane>> more(planes);
  parallel_blocks(planes, 1, [&](std::size_t r, std::size_t) {
    if (members[r].empty()) return;
    auto search = searches.take();
    more[r] = split_plane(cloud, grid, noise, fewest, r, members[r], *search, labels);
    searches.give_back(std::move(search));
  });
  for (std::size_t r = 0; r < planes; ++r) {
    if (more[r].empty()) continue;
    const auto next = static_cast<std::int32_t>(labels.planes.size());
    labels.planes.insert(labels.planes.end(), more[r].begin(), more[r].end());
    for (const auto p : members[r]) {
      auto& label = labels.of_point[p];
      if (label <= -2) label = next + (-2 - label);
    }
  }
}

void join(const BeamGrid& grid, const BeamNoise& noise, CellSearch& search, PlaneLabels& labels) {
  auto& planes = labels.planes;
  const PlaneMembers members(labels);
  parallel_blocks(grid.cell_count(), 16384, [&](std::size_t begin, std::size_t end) {
    for (auto cell = static_cast<std::uint32_t>(begin); cell < end; ++cell) {
      for (const auto p : grid.points(cell)) {
        if (labels.of_point[p] >= 0) search.piece[cell] = labels.of_point[p];
      }
    }
  });
  std::vector<std::uint32_t> order;
  for (std::uint32_t r = 0; r < planes.size(); ++r) {
    if (!members[r].empty()) order.push_back(r);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return members[a].size() > members[b].size(); });
  std::vector<bool> gone(planes.size(), false);
  const Eigen::Vector3f sensor = noise.sensor.cast<float>();
  constexpr double no_accident = -8.5;  // one pair in 5000, which is as many as 100 planes have
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto a = order[i];
    if (gone[a]) continue;
    search.ask_about(planes[a], noise);
    // Twice: with what it won the plane is known farther out.
    for (int round = 0, won = 1; round < 2 && won > 0; ++round) {
      won = 0;
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const auto b = order[j];
        if (gone[b] || !lie_in_one_plane(planes[a], planes[b], noise)) continue;
        const bool hidden = search.mostly_hidden(members[b], members[a], labels, sensor);
        // What agrees so well that it is no accident may have a window in it.
        if (!hidden &&
            (log_chance_agreement(planes[a], planes[b]) > no_accident ||
             !search.hidden_path(cells_of(grid, members[b]), static_cast<std::int32_t>(a))))
          continue;
        Moments both = planes[a].moments;
        both.add(planes[b].moments);
        planes[a] = grown_plane(both, noise);
        for (const auto p : members[b]) {
          labels.of_point[p] = static_cast<std::int32_t>(a);
          search.piece[grid.cell_of_point(p)] = static_cast<std::int32_t>(a);
        }
        gone[b] = true;
        planes[b].moments = Moments{};
        ++won;
      }
      if (won > 0) search.ask_about(planes[a], noise);
    }
  }
}

}  // namespace

void connect_planes(const CanonicalCloud& cloud, const BeamGrid& grid, const BeamNoise& noise,
                    std::size_t fewest, PlaneLabels& labels) {
  Searches searches(cloud, grid);
  split(cloud, grid, noise, fewest, searches, labels);
  join(grid, noise, *searches.take(), labels);
}

}  // namespace scanchor
