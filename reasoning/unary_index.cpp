#include "reasoning/unary_index.hpp"

#include <algorithm>

#include "reasoning/matcher.hpp"

namespace scanchor {

namespace {

constexpr double largest_relative_sigma = 0.2;
// Phi(-1.645) = 0.05: a limit that is missed by more than 1.645 standard deviations is below the
// gate. The deviation is at most sigma + 0.15 limit (triangle inequality), so x (1 + 1.645 * 0.2)
// >= limit (1 - 1.645 * 0.15) is necessary, and likewise above.
constexpr double lower_factor =
    (1.0 - 1.645 * 0.15) / (1.0 + 1.645 * largest_relative_sigma) * 0.999;
constexpr double upper_factor =
    (1.0 + 1.645 * 0.15) / (1.0 - 1.645 * largest_relative_sigma) * 1.001;

}  // namespace

UnaryIndex::UnaryIndex(const std::vector<Item>& items, const std::vector<Evidence>& horizontal,
                       const std::vector<Evidence>& vertical) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    const auto put = [&](Bin& bin) {
      const Entry entry{item.area.value, item.id};
      if (item.area.hidden > 0.0 && item.area.sigma <= largest_relative_sigma * item.area.value) {
        bin.cut.push_back(entry);
      } else if (item.area.sigma <= largest_relative_sigma * item.area.value) {
        bin.whole.push_back(entry);
      } else {
        bin.odd.push_back(item.id);
      }
    };
    put(bins_[0]);
    if (horizontal[i].likelihood >= required_gate) put(bins_[1]);
    if (vertical[i].likelihood >= required_gate) put(bins_[2]);
  }
  const auto by_area = [](const Entry& a, const Entry& b) {
    return a.area != b.area ? a.area < b.area : a.id < b.id;
  };
  for (auto& bin : bins_) {
    std::sort(bin.whole.begin(), bin.whole.end(), by_area);
    std::sort(bin.cut.begin(), bin.cut.end(), by_area);
  }
}

std::vector<std::int32_t> UnaryIndex::candidates(const std::vector<Clause>& clauses) const {
  const Bin* bin = bins_.data();
  double low = 0.0;
  double high = INFINITY;
  for (const auto& clause : clauses) {
    if (clause.usually) continue;
    if (clause.kind == ClauseKind::horizontal && !clause.range.has_high()) bin = &bins_[1];
    if (clause.kind == ClauseKind::vertical && !clause.range.has_high()) bin = &bins_[2];
    if (clause.kind != ClauseKind::feature || clause.feature != Feature::area) continue;
    low = std::max(low, clause.range.low * lower_factor);
    high = std::min(high, clause.range.high * upper_factor);
  }
  std::vector<std::int32_t> ids = bin->odd;
  const auto from = [](const std::vector<Entry>& list, double area) {
    return std::lower_bound(list.begin(), list.end(), area,
                            [](const Entry& e, double a) { return e.area < a; });
  };
  for (auto e = from(bin->whole, low); e != bin->whole.end() && e->area <= high; ++e)
    ids.push_back(e->id);
  for (auto e = bin->cut.begin(); e != bin->cut.end() && e->area <= high; ++e) ids.push_back(e->id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace scanchor
