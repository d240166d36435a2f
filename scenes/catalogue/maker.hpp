#pragma once
// What the makers of furniture share: drawing sizes, adding parts, and the two distances that keep
// faces apart.

#include <string>
#include <vector>

#include "core/random.hpp"
#include "scenes/catalogue.hpp"
#include "scenes/mesh.hpp"
#include "scenes/pose.hpp"

namespace scanchor {

/// Parts that are joined reach this far into each other, so that no two parallel faces lie in one
/// plane. Where three parts meet, the second joint goes twice as deep. [m]
inline constexpr double joint = 0.002;
/// What stands fixed stands on glides of this height: more than 1 mm, so that its underside and the
/// floor do not tie. [m]
inline constexpr double glide = 0.0015;

/// One thing in the making.
class Maker {
 public:
  Maker(Scene& scene, const FurnitureRequest& request, Instance& instance);

  /// A length [m]: normal, cut to [low, high], rounded to the millimetre; with the request's
  /// probability of the unusual it falls up to a third of the range outside instead (never below
  /// 0.6 of `low`).
  double size(const std::string& name, double mean, double sigma, double low, double high);
  /// One of a series of standard sizes.
  double series(const std::string& name, const std::vector<double>& values);
  /// A whole number in [low, high].
  int count(const std::string& name, int low, int high);
  /// An angle in degrees or another plain number, uniform in [low, high], rounded to a tenth.
  double number(const std::string& name, double low, double high);
  /// One of several materials, by name.
  int material(const std::vector<std::string>& names);

  [[nodiscard]] bool is(const std::string& variant) const { return instance.variant == variant; }

  /// Box by its corners.
  void box(const std::string& name, int material, const Eigen::Vector3d& low,
           const Eigen::Vector3d& high);
  void add(Part part) { instance.parts.push_back(std::move(part)); }
  /// A round leg that slants from the floor at (x, y) to `head`; its lowest point stands on the
  /// glide.
  void leg(const std::string& name, int material, double x, double y, const Eigen::Vector3d& head,
           double radius);

  SequentialRandom random;
  Instance& instance;

 private:
  /// Takes the fixed value if there is one, else `draw`; records it.
  template <class Draw>
  double take(const std::string& name, Draw draw);

  Scene& scene_;
  const FurnitureRequest& request_;
};

/// A kind and how it is made.
struct CatalogueEntry {
  KindInfo info;
  void (*make)(Maker& maker);
};

// One function a subject; catalogue.cpp puts them together.
std::vector<CatalogueEntry> table_entries();
std::vector<CatalogueEntry> seating_entries();
std::vector<CatalogueEntry> storage_entries();
std::vector<CatalogueEntry> screen_entries();
std::vector<CatalogueEntry> kitchen_entries();
std::vector<CatalogueEntry> building_entries();
std::vector<CatalogueEntry> logistics_entries();
std::vector<CatalogueEntry> organic_entries();

}  // namespace scanchor
