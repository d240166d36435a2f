#pragma once
// The furniture catalogue: parametric kinds, each with several ways of being built. A kind, a
// variant and a seed give a thing whose sizes come from the distributions in
// docs/reference/furniture.md.
//
// Frame of a thing: origin on the floor (or at the wall, or on the support) below the middle of its
// footprint; x to the right and y to the back as its user sees it, who stands at -y and looks along
// +y; z up. So a desk is used from -y and its back edge goes to the wall; a monitor's screen faces
// -y.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace scanchor {

/// Where people put a kind of thing.
enum class Place { floor, wall, surface, ceiling };

struct KindInfo {
  std::string name;  ///< "desk"
  ClassId class_id;
  std::vector<std::string> variants;  ///< "four legs", "panel legs", ...
  Place place;
  bool loose;      ///< moves when pushed: settled by physics
  double density;  ///< [kg/m3] over the volume of its parts' bounding boxes; gives the mass of
                   ///< loose things
};

/// All kinds in a fixed order.
const std::vector<KindInfo>& furniture_kinds();
/// One kind by name; throws Error(wrong_usage) with a suggestion.
const KindInfo& furniture_kind(const std::string& name);

/// What may be fixed instead of drawn, by the names that Instance::parameters reports:
/// {"width", 1.6}, {"boards", 5}.
using Parameters = std::map<std::string, double>;

/// How a thing is drawn.
struct FurnitureRequest {
  std::string kind;
  std::string variant;  ///< empty: drawn
  std::uint64_t seed = 0;
  Parameters parameters;  ///< fixed values, used as they are
  double unusual = 0.0;   ///< [0, 1] probability that a size falls outside the usual range
};

/// Builds the thing with id 0 at the origin; its materials are added to the scene where they are
/// missing. `parameters` of the result holds every value that was drawn or fixed. Deterministic in
/// the request. Throws Error(wrong_usage): unknown kind, variant or parameter (with suggestions), a
/// value that is not positive or not finite.
Instance make_furniture(Scene& scene, const FurnitureRequest& request);

}  // namespace scanchor
