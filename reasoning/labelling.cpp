#include "reasoning/labelling.hpp"

#include <algorithm>

namespace scanchor {

std::vector<std::int32_t> things(const Labelling& labelling) {
  std::vector<std::int32_t> ids = labelling.entity_of_surface;
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}  // namespace scanchor
