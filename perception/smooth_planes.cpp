#include "perception/smooth_planes.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace scanchor {
namespace {

constexpr int smoothing_rounds = 3;
constexpr float vote = 1.0F;  // of a neighbour: as much as a residual of sqrt(2) scatters
constexpr std::size_t task = 2048;

class Smoother {
 public:
  Smoother(const CanonicalCloud& cloud, const BeamGrid& grid, PlaneLabels& labels)
      : cloud_(cloud),
        grid_(grid),
        labels_(labels),
        reach_(labels.planes.begin(), labels.planes.end()),
        common_(grid.cell_count()),
        label_of_tile_(grid.tile_count()),
        waits_(grid.cell_count(), 0),
        won_(labels.planes.size()),
        lost_(labels.planes.size()) {
    for (const auto& reach : reach_) {
      log_height_.push_back(std::log(reach.height));
      log_least_.push_back(std::log(reach.least));
    }
    parallel_blocks(common_.size(), task, [&](std::size_t begin, std::size_t end) {
      constexpr std::uint32_t tile = BeamGrid::cells_per_tile;
      static_assert(task % tile == 0);
      for (auto cell = static_cast<std::uint32_t>(begin); cell < end; ++cell)
        common_[cell] = common_label(cell);
      for (auto first = static_cast<std::uint32_t>(begin); first < end; first += tile)
        label_of_tile_[first / tile] = label_of_cells(first, first + tile);
    });
  }

  void run() {
    std::vector<std::uint32_t> asked = at_borders();
    for (int round = 0; round < smoothing_rounds && !asked.empty(); ++round) {
      std::vector<std::vector<Change>> changes((asked.size() + task - 1) / task);
      parallel_blocks(asked.size(), task, [&](std::size_t begin, std::size_t end) {
        Ballot ballot;
        for (std::size_t k = begin; k < end; ++k) choose(asked[k], ballot, changes[begin / task]);
      });
      asked = carry_out(changes);
    }
  }

  // Planes follow what they won and lost.
  void follow(const BeamNoise& noise) {
    for (std::size_t r = 0; r < won_.size(); ++r) {
      if (won_[r].n == 0.0 && lost_[r].n == 0.0) continue;
      GrownPlane& grown = labels_.planes[r];
      grown.moments.add(won_[r]);
      grown.moments.remove(lost_[r]);
      if (grown.moments.n >= 6.0) grown = grown_plane(grown.moments, noise);
    }
  }

 private:
  static constexpr std::int32_t no_points = -3, several = -2;  // -1: all of them on none
  struct Change {
    std::uint32_t cell, point;
    std::int32_t label;
  };
  using Ballot = std::vector<std::pair<std::int32_t, float>>;

  [[nodiscard]] std::int32_t common_label(std::uint32_t cell) const {
    std::int32_t common = no_points;
    for (const auto p : grid_.points(cell)) {
      if (common == no_points) common = labels_.of_point[p];
      if (common != labels_.of_point[p]) return several;
    }
    return common;
  }

  // Cells beside one that holds points of another label. A tile of one label
  // among others of it has none.
  [[nodiscard]] std::vector<std::uint32_t> at_borders() const {
    constexpr std::uint32_t tile = BeamGrid::cells_per_tile;
    std::vector<std::vector<std::uint32_t>> found((common_.size() + task - 1) / task);
    parallel_blocks(common_.size(), task, [&](std::size_t begin, std::size_t end) {
      for (auto first = static_cast<std::uint32_t>(begin); first < end; first += tile) {
        const auto all_own = label_of_tile_[first / tile];
        if (all_own == no_points) continue;
        std::array<std::uint32_t, 9> tiles{};
        const bool inside = grid_.tiles_around(first / tile, tiles);
        if (inside && all_own != several && std::all_of(tiles.begin(), tiles.end(), [&](auto next) {
              return label_of_tile_[next] == all_own || label_of_tile_[next] == no_points;
            }))
          continue;
        if (inside) {
          look_through(tiles, found[begin / task]);
          continue;
        }
        for (auto cell = first; cell < first + tile; ++cell) {
          const auto own = common_[cell];
          if (own == no_points) continue;
          const auto around = grid_.around<1>(cell);
          if (own == several || std::any_of(around.begin(), around.end(), [&](auto next) {
                return common_[next] != own && common_[next] != no_points;
              }))
            found[begin / task].push_back(cell);
        }
      }
    });
    std::vector<std::uint32_t> all;
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
  }

  // The same for all cells of the tile in the middle, eight at a time.
  void look_through(const std::array<std::uint32_t, 9>& tiles,
                    std::vector<std::uint32_t>& found) const {
    constexpr std::size_t side = 8, wide = side + 2;
    std::array<std::int32_t, wide * wide> labels;  // with a rim
    for (std::size_t y = 0; y < wide; ++y) {
      const std::size_t above = (y + 7) / 8, in_y = (y + 7) % 8;
      const auto* const left = &common_[std::size_t{tiles[3 * above]} << 6 | in_y << 3];
      const auto* const here = &common_[std::size_t{tiles[3 * above + 1]} << 6 | in_y << 3];
      const auto* const right = &common_[std::size_t{tiles[3 * above + 2]} << 6 | in_y << 3];
      labels[wide * y] = left[7];
      std::copy(here, here + side, &labels[wide * y + 1]);
      labels[wide * y + 9] = right[0];
    }
    for (std::size_t y = 0; y < side; ++y) {
      std::array<std::int32_t, side> differs{};
      for (std::size_t dy = 0; dy < 3; ++dy) {
        for (std::size_t dx = 0; dx < 3; ++dx) {
          const auto* const own = &labels[wide * (y + 1) + 1];
          const auto* const next = &labels[wide * (y + dy) + dx];
          for (std::size_t x = 0; x < side; ++x)
            differs[x] |= static_cast<std::int32_t>(next[x] != own[x]) &
                          static_cast<std::int32_t>(next[x] != no_points);
        }
      }
      for (std::size_t x = 0; x < side; ++x) {
        const auto own = labels[wide * (y + 1) + x + 1];
        if (own == several || (differs[x] != 0 && own != no_points))
          found.push_back(tiles[4] << 6 | static_cast<std::uint32_t>(y << 3 | x));
      }
    }
  }

  // Of all cells that hold points.
  [[nodiscard]] std::int32_t label_of_cells(std::uint32_t from, std::uint32_t to) const {
    std::int32_t only = no_points;
    for (auto cell = from; cell < to; ++cell) {
      if (common_[cell] == no_points) continue;
      if (only == no_points) only = common_[cell];
      if (common_[cell] != only) return several;
    }
    return only;
  }

  void choose(std::uint32_t cell, Ballot& ballot, std::vector<Change>& changes) const {
    ballot.clear();
    const auto count = [&](std::int32_t label, float votes) {
      if (label < 0) return;
      for (auto& candidate : ballot) {
        if (candidate.first != label) continue;
        candidate.second += votes;
        return;
      }
      ballot.emplace_back(label, votes);
    };
    for (const auto next : grid_.around<1>(cell)) {
      if (common_[next] == several) {
        for (const auto p : grid_.points(next)) count(labels_.of_point[p], vote);
      } else if (common_[next] >= 0) {
        count(common_[next], vote * static_cast<float>(grid_.points(next).size()));
      }
    }
    for (const auto p : grid_.points(cell)) {
      const auto own = labels_.of_point[p];
      const bool choice = ballot.size() > 1;
      const float log_inverse = choice ? std::log(cloud_.inverse_range[p]) : 0.0F;
      std::int32_t chosen = -1;
      float least = 3e38F;
      for (const auto& [label, votes] : ballot) {
        const auto plane = static_cast<std::size_t>(label);
        const float r = reach_[plane].distance(cloud_.x[p], cloud_.y[p], cloud_.z[p]) /
                        reach_[plane].scatter(cloud_.inverse_range[p]);
        if (r > 3.0F) continue;
        const float log_scatter = std::max(log_height_[plane] + log_inverse, log_least_[plane]);
        const float others = votes - (label == own ? vote : 0.0F);
        const float cost = 0.5F * r * r + log_scatter - others;
        if (cost < least || (cost == least && label < chosen)) {
          least = cost;
          chosen = label;
        }
      }
      if (chosen != own) changes.push_back({cell, p, chosen});
    }
  }

  // Returns the cells beside a change, each once.
  std::vector<std::uint32_t> carry_out(const std::vector<std::vector<Change>>& changes) {
    std::vector<std::uint32_t> beside;
    for (const auto& some : changes) {
      for (const auto& change : some) {
        auto& label = labels_.of_point[change.point];
        const auto p = change.point;
        if (label >= 0)
          lost_[static_cast<std::size_t>(label)].add(cloud_.x[p], cloud_.y[p], cloud_.z[p]);
        label = change.label;
        if (label >= 0)
          won_[static_cast<std::size_t>(label)].add(cloud_.x[p], cloud_.y[p], cloud_.z[p]);
      }
    }
    for (const auto& some : changes) {
      for (const auto& change : some) {
        common_[change.cell] = common_label(change.cell);
        for (const auto next : grid_.around<1>(change.cell)) {
          if (waits_[next] != 0 || common_[next] == no_points) continue;
          waits_[next] = 1;
          beside.push_back(next);
        }
      }
    }
    for (const auto cell : beside) waits_[cell] = 0;
    return beside;
  }

  const CanonicalCloud& cloud_;
  const BeamGrid& grid_;
  PlaneLabels& labels_;
  const std::vector<PlaneReach> reach_;
  std::vector<float> log_height_, log_least_;  // of the reach of each plane
  std::vector<std::int32_t> common_;           // by cell: the label of all its points
  std::vector<std::int32_t> label_of_tile_;    // by tile: the same of all its cells, at first
  std::vector<char> waits_;                    // by cell
  std::vector<Moments> won_, lost_;            // by plane
};

}  // namespace

void smooth_planes(const CanonicalCloud& cloud, const BeamGrid& grid, PlaneLabels& labels,
                   const BeamNoise& noise) {
  Smoother smoother(cloud, grid, labels);
  smoother.run();
  smoother.follow(noise);
}

}  // namespace scanchor
