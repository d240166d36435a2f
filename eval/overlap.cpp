#include "eval/overlap.hpp"

#include <algorithm>
#include <cassert>

namespace scanchor {

std::vector<Overlap> overlap_table(std::span<const std::int32_t> truth,
                                   std::span<const std::int32_t> predicted) {
  assert(truth.size() == predicted.size());
  std::vector<std::uint64_t> keys(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    // One more than the label, so that -1 becomes 0 and the order of the keys is the order of the
    // pairs.
    const auto t = static_cast<std::uint64_t>(std::max(truth[i], -1) + std::int64_t{1});
    const auto p = static_cast<std::uint64_t>(std::max(predicted[i], -1) + std::int64_t{1});
    keys[i] = t << 32U | p;
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Overlap> table;
  for (std::size_t i = 0; i < keys.size();) {
    std::size_t end = i;
    while (end < keys.size() && keys[end] == keys[i]) ++end;
    table.push_back(
        {static_cast<std::int32_t>(static_cast<std::int64_t>(keys[i] >> 32U) - 1),
         static_cast<std::int32_t>(static_cast<std::int64_t>(keys[i] & 0xffffffffU) - 1),
         static_cast<std::int64_t>(end - i)});
    i = end;
  }
  return table;
}

}  // namespace scanchor
