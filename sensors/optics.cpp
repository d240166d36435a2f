#include "sensors/optics.hpp"

#include <algorithm>

namespace scanchor {

double schlick(double f0, double cosine) {
  const double x = 1.0 - std::clamp(cosine, 0.0, 1.0);
  const double x2 = x * x;
  return f0 + (1.0 - f0) * x2 * x2 * x;
}

LightSplit split_light(const LidarOptions& options, const Material& material, double cosine) {
  LightSplit split{material.reflectance, 0.0, 0.0};
  if (material.transmittance > 0.0) {
    const double fresnel = schlick(options.glass_f0, cosine);
    if (options.glass) {
      split.own += material.transmittance * fresnel;
      split.through = material.transmittance * (1.0 - fresnel) * (1.0 - fresnel);
    } else {
      split.own += material.transmittance;
    }
  }
  if (options.mirrors) {
    split.mirrored = material.specular * material.specular;
  } else {
    split.own += material.specular;
  }
  split.own = std::min(split.own, 1.0);
  return split;
}

}  // namespace scanchor
