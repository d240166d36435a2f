#pragma once
// Which entities can be of a class at all, by their orientation and area, without looking at each.

#include <array>
#include <cstdint>
#include <vector>

#include "reasoning/item.hpp"
#include "reasoning/ontology.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {

class UnaryIndex {
 public:
  UnaryIndex() = default;
  /// Of surfaces only; `horizontal` and `vertical`: their evidence at the default tolerance, one an
  /// item.
  UnaryIndex(const std::vector<Item>& items, const std::vector<Evidence>& horizontal,
             const std::vector<Evidence>& vertical);

  /// Ids, rising, of all items for which every required clause on orientation and area can reach
  /// the gate of the matcher; a few more may be among them, none is missing.
  [[nodiscard]] std::vector<std::int32_t> candidates(const std::vector<Clause>& clauses) const;

 private:
  struct Entry {
    double area;
    std::int32_t id;
  };
  struct Bin {
    std::vector<Entry> whole;       ///< seen whole, area known within 20 %; rising area
    std::vector<Entry> cut;         ///< area is "at least"; rising area
    std::vector<std::int32_t> odd;  ///< everything else
  };
  std::array<Bin, 3> bins_;  ///< all, possibly horizontal, possibly vertical
};

}  // namespace scanchor
