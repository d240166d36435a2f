#include "tests/perception/support/plane_score.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace scanchor::support {

PlaneScore score_planes(const std::vector<std::int32_t>& truth,
                        const std::vector<std::int32_t>& regions, double tolerance,
                        std::size_t least) {
  std::map<std::int32_t, std::size_t> true_size, region_size;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> overlap;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i] >= 0) ++true_size[truth[i]];
    if (regions[i] >= 0) ++region_size[regions[i]];
    if (truth[i] >= 0 && regions[i] >= 0) ++overlap[{truth[i], regions[i]}];
  }
  std::set<std::int32_t> counted;
  for (const auto& [id, size] : true_size) {
    if (size >= least) counted.insert(id);
  }
  PlaneScore score;
  score.planes = static_cast<int>(counted.size());
  for (const auto& [id, size] : region_size) score.regions += size >= least;
  std::set<std::int32_t> true_done, region_done;
  const auto covers = [&](std::size_t part, std::size_t whole) {
    return static_cast<double>(part) >= tolerance * static_cast<double>(whole);
  };
  for (const auto& [pair, both] : overlap) {
    if (!counted.count(pair.first)) continue;
    if (covers(both, true_size[pair.first]) && covers(both, region_size[pair.second])) {
      ++score.correct;
      true_done.insert(pair.first);
      region_done.insert(pair.second);
    }
  }
  for (const auto id : counted) {  // over-segmentation: several regions, each mostly of this plane,
                                   // together most of it
    if (true_done.count(id)) continue;
    std::size_t together = 0;
    std::vector<std::int32_t> parts;
    for (const auto& [pair, both] : overlap) {
      if (pair.first != id || !covers(both, region_size[pair.second])) continue;
      together += both;
      parts.push_back(pair.second);
    }
    if (parts.size() >= 2 && covers(together, true_size[id])) {
      ++score.over;
      true_done.insert(id);
      region_done.insert(parts.begin(), parts.end());
    }
  }
  for (const auto& [region, size] : region_size) {  // under-segmentation: the mirror image
    if (region_done.count(region)) continue;
    std::size_t together = 0;
    std::vector<std::int32_t> parts;
    for (const auto& [pair, both] : overlap) {
      if (pair.second != region || !covers(both, true_size[pair.first])) continue;
      together += both;
      if (counted.count(pair.first)) parts.push_back(pair.first);
    }
    if (parts.size() >= 2 && covers(together, size)) {
      ++score.under;
      region_done.insert(region);
      true_done.insert(parts.begin(), parts.end());
    }
  }
  for (const auto id : counted) score.missed += !true_done.count(id);
  for (const auto& [id, size] : region_size)
    score.spurious += size >= least && !region_done.count(id);

  std::size_t on_planes = 0, in_best = 0, best_points = 0;
  double small = 0.0;
  int smalls = 0;
  std::set<std::int32_t> taken;
  for (const auto id : counted) {
    std::size_t best = 0;
    std::int32_t best_region = -1;
    for (const auto& [pair, both] : overlap) {
      if (pair.first == id && both > best) best = both, best_region = pair.second;
    }
    on_planes += true_size[id];
    in_best += best;
    if (best_region >= 0 && taken.insert(best_region).second)
      best_points += region_size[best_region];
    if (100 * true_size[id] < truth.size()) {
      small += static_cast<double>(best) / static_cast<double>(true_size[id]);
      ++smalls;
    }
    bool is_correct = false;
    for (const auto& [pair, both] : overlap) {
      is_correct |=
          pair.first == id && covers(both, true_size[id]) && covers(both, region_size[pair.second]);
    }
    if (!is_correct) score.not_correct.push_back(id);
  }
  score.recall = on_planes ? static_cast<double>(in_best) / static_cast<double>(on_planes) : 0.0;
  score.precision =
      best_points ? static_cast<double>(in_best) / static_cast<double>(best_points) : 0.0;
  score.small_recall = smalls ? small / smalls : 0.0;
  return score;
}

}  // namespace scanchor::support
