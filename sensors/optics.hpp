#pragma once
// What glass and mirrors do to a beam.

#include "scenes/scene.hpp"
#include "sensors/tilting_lidar.hpp"

namespace scanchor {

/// Fresnel reflectance by Schlick's approximation, F0 + (1 - F0)(1 - cos a)^5 (Schlick 1994;
/// sensors.md 1.2 formula 7).
double schlick(double f0, double cosine);

/// Where the light of a beam goes at a surface; shares of what arrived, there and back.
struct LightSplit {
  double own;       ///< scattered back from here: takes the place of rho, before the cosine
  double through;   ///< goes on behind: (1 - F)^2 of the share that is glass
  double mirrored;  ///< goes on in the mirror's direction, out and back
};

/// A surface scatters its reflectance back, whatever else it does. Of the share that is glass, F
/// comes back as if scattered and (1 - F)^2 is left of what goes through and returns (formula 7; a
/// pane has two faces and takes both). A mirror sends `specular` on and takes the same share again
/// on the way back. With an effect switched off its share scatters like paint.
LightSplit split_light(const LidarOptions& options, const Material& material, double cosine);

}  // namespace scanchor
