#include "scenes/catalogue.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "scenes/catalogue/maker.hpp"
#include "scenes/materials.hpp"

namespace scanchor {
namespace {

double round_to(double value, double steps_per_unit) {
  return std::floor(value * steps_per_unit + 0.5) / steps_per_unit;
}

const std::vector<CatalogueEntry>& entries() {
  static const std::vector<CatalogueEntry> all = [] {
    std::vector<CatalogueEntry> list;
    for (const auto subject :
         {table_entries, seating_entries, storage_entries, screen_entries, kitchen_entries,
          building_entries, logistics_entries, organic_entries}) {
      for (auto& entry : subject()) list.push_back(std::move(entry));
    }
    return list;
  }();
  return all;
}

const CatalogueEntry& entry_of(const std::string& kind) {
  std::vector<std::string> names;
  for (const auto& entry : entries()) {
    if (entry.info.name == kind) return entry;
    names.push_back(entry.info.name);
  }
  fail_usage("unknown kind of furniture '" + kind + "'", suggestion(kind, names));
}

double mass_of(const Instance& instance, double density) {
  double volume = 0.0;
  for (const auto& part : instance.parts) {
    Eigen::AlignedBox3d bounds;
    for (const auto& vertex : part.vertices) bounds.extend(vertex);
    if (!bounds.isEmpty()) volume += bounds.volume();
  }
  return std::max(0.02, round_to(volume * density, 1000.0));
}

}  // namespace

Maker::Maker(Scene& scene, const FurnitureRequest& request, Instance& thing)
    : random(stream_seed(request.seed, request.kind)),
      instance(thing),
      scene_(scene),
      request_(request) {}

template <class Draw>
double Maker::take(const std::string& name, Draw draw) {
  const double drawn = draw();  // drawn in any case: fixing one value leaves the others as they are
  const auto fixed = request_.parameters.find(name);
  const double value = fixed != request_.parameters.end() ? fixed->second : drawn;
  instance.parameters[name] = value;
  return value;
}

double Maker::size(const std::string& name, double mean, double sigma, double low, double high) {
  return take(name, [&] {
    const double usual = random.truncated_normal(mean, sigma, low, high);
    const bool outside = random.chance(request_.unusual);
    const double beyond = (high - low + 0.1 * mean) * random.uniform(0.05, 1.0) / 3.0;
    const bool above = random.chance(0.5);
    if (!outside) return round_to(usual, 1000.0);
    return round_to(above ? high + beyond : std::max(0.6 * low, low - beyond), 1000.0);
  });
}

double Maker::series(const std::string& name, const std::vector<double>& values) {
  return take(name, [&] {
    const double usual = values[random.below(static_cast<std::uint32_t>(values.size()))];
    const bool outside = random.chance(request_.unusual);
    const double factor = random.chance(0.5) ? random.uniform(1.1, 1.4) : random.uniform(0.7, 0.9);
    return outside ? round_to(usual * factor, 1000.0) : usual;
  });
}

int Maker::count(const std::string& name, int low, int high) {
  return static_cast<int>(take(name, [&] {
    return static_cast<double>(low) + random.below(static_cast<std::uint32_t>(high - low + 1));
  }));
}

double Maker::number(const std::string& name, double low, double high) {
  return take(name, [&] { return round_to(random.uniform(low, high), 10.0); });
}

int Maker::material(const std::vector<std::string>& names) {
  return use_material(scene_, names[random.below(static_cast<std::uint32_t>(names.size()))]);
}

void Maker::box(const std::string& name, int material, const Eigen::Vector3d& low,
                const Eigen::Vector3d& high) {
  add(box_part(name, material, 0.5 * (low + high), high - low));
}

void Maker::leg(const std::string& name, int material, double x, double y,
                const Eigen::Vector3d& head, double radius) {
  const double slant = std::sqrt((head.x() - x) * (head.x() - x) + (head.y() - y) * (head.y() - y));
  const double sine = slant / std::sqrt(slant * slant + head.z() * head.z());
  add(cylinder_part(name, material, {x, y, glide + radius * sine}, head, radius, 8));
}

const std::vector<KindInfo>& furniture_kinds() {
  static const std::vector<KindInfo> kinds = [] {
    std::vector<KindInfo> list;
    for (const auto& entry : entries()) list.push_back(entry.info);
    return list;
  }();
  return kinds;
}

const KindInfo& furniture_kind(const std::string& name) { return entry_of(name).info; }

Instance make_furniture(Scene& scene, const FurnitureRequest& request) {
  const CatalogueEntry& entry = entry_of(request.kind);
  const auto& variants = entry.info.variants;
  Instance instance;
  instance.class_id = entry.info.class_id;
  instance.kind = entry.info.name;
  instance.variant = request.variant;
  const CounterRandom choice(stream_seed(request.seed, "variant"));
  if (instance.variant.empty()) {
    instance.variant = variants[choice.words(0)[0] % variants.size()];
  } else if (std::find(variants.begin(), variants.end(), instance.variant) == variants.end()) {
    fail_usage("a " + request.kind + " has no variant '" + request.variant + "'",
               suggestion(request.variant, variants));
  }
  for (const auto& [name, value] : request.parameters) {
    const bool angle = name.size() > 4 && name.compare(name.size() - 4, 4, "_deg") == 0;
    if (!std::isfinite(value) || value < 0 || value > (angle ? 180 : 100)) {
      fail_usage("parameter '" + name + "' of a " + request.kind + " must lie in 0 .. " +
                 (angle ? "180" : "100"));
    }
  }
  instance.loose = entry.info.loose;
  Maker maker(scene, request, instance);
  entry.make(maker);
  for (const auto& [name, value] : request.parameters) {
    if (instance.parameters.count(name) != 0) continue;
    std::vector<std::string> known;
    for (const auto& item : instance.parameters) known.push_back(item.first);
    fail_usage(
        "a " + request.kind + " ('" + instance.variant + "') has no parameter '" + name + "'",
        suggestion(name, known));
  }
  instance.mass = mass_of(instance, entry.info.density);
  return instance;
}

}  // namespace scanchor
