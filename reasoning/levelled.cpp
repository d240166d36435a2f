#include "reasoning/levelled.hpp"

#include "core/math.hpp"
#include "reasoning/item.hpp"

namespace scanchor {

Levelled level(const Surfaces& surfaces, const ReasonOptions& options) {
  Levelled levelled;
  levelled.up = find_up(surfaces, options.up, radians(options.up_sigma_deg));
  levelled.R_level_cloud = levelling(levelled.up.up);
  levelled.around.up_sigma = levelled.up.sigma;
  if (!surfaces.sensor_positions.empty())
    levelled.around.viewpoint = levelled.R_level_cloud * surfaces.sensor_positions.front();
  return levelled;
}

}  // namespace scanchor
