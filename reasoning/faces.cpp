#include "reasoning/faces.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace scanchor {
namespace {

/// What a shadow, a cable or a monitor's foot may hide between pieces of one top.
constexpr double widest_gap = 0.4;  // [m]

constexpr double thickest = 0.3;    // [m] reveals of windows are about as deep
constexpr double least_turn = 0.8;  // cosine of the angle between layers

/// [m] half of what an item covers along an axis.
double half_along(const Item& item, const Eigen::Vector3d& axis) {
  return std::abs(axis.dot(item.along)) * item.half_length +
         std::abs(axis.dot(item.across)) * item.half_width;
}

/// The front and the back of one thing, a pane and its frame: one covers half of the other, or they
/// go on where the other ends.
bool are_layers(const Item& a, const Item& b) {
  const Eigen::Vector3d step = b.center - a.center;
  if (std::abs(a.normal.dot(b.normal)) < least_turn || std::abs(a.normal.dot(step)) > thickest)
    return false;
  if (a.box.exteriorDistance(b.box) < 0.05) return true;
  const auto covered = [&](const Eigen::Vector3d& axis, double half) {
    const double reach = half_along(b, axis);
    const double at = axis.dot(step);
    const double shared = std::min(half, at + reach) - std::max(-half, at - reach);
    return std::clamp(shared / (2.0 * std::min(half, reach) + 1e-9), 0.0, 1.0);
  };
  return covered(a.along, a.half_length) * covered(a.across, a.half_width) > 0.5;
}

/// Are these and one more, lying in one plane, together no larger than the class is at most and
/// usually is? The halves of a desk make a desk, two desks in a row do not. Of a class without a
/// size only what touches is one.
bool is_one(const std::vector<Clause>& clauses, const std::vector<Item>& items,
            const std::vector<std::size_t>& pieces, const Item& more, bool touch) {
  const Item& frame = items[pieces.front()];
  Eigen::Vector2d low(INFINITY, INFINITY), high = -low;
  const auto extend = [&](const Item& item) {
    for (const double u : {-item.half_length, item.half_length}) {
      for (const double v : {-item.half_width, item.half_width}) {
        const Eigen::Vector3d corner = item.center + u * item.along + v * item.across;
        const Eigen::Vector2d at(frame.along.dot(corner), frame.across.dot(corner));
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
      }
    }
  };
  for (const auto piece : pieces) extend(items[piece]);
  extend(more);
  const double length = (high - low).maxCoeff(), width = (high - low).minCoeff();
  bool told = false;
  for (const auto& clause : clauses) {
    if (clause.kind != ClauseKind::feature || !clause.range.has_high()) continue;
    if (clause.feature == Feature::extension) {
      if (length > clause.range.high) return false;
      told = true;
    }
    if (clause.feature == Feature::width && width > clause.range.high) return false;
  }
  return told || touch;
}

}  // namespace

bool part_fits(const Matcher& matcher, int whole_class, std::int32_t whole, std::int32_t part) {
  const auto& items = matcher.items();
  const Item& frame = items[whole];
  if (frame.group) return true;
  const Item& piece = items[part];
  const double reach = half_along(piece, frame.along);
  const double at = frame.along.dot(piece.center - frame.center);
  const double length =
      std::max(frame.half_length, at + reach) - std::min(-frame.half_length, at - reach);
  for (const auto& clause : matcher.clauses(whole_class)) {
    if (clause.kind == ClauseKind::feature && !clause.usually &&
        clause.feature == Feature::extension && length > 1.1 * clause.range.high)
      return false;
  }
  return true;
}

void gather_faces(const Matcher& matcher, const Ontology& ontology, Labelling& labelling) {
  const auto& items = matcher.items();
  auto& entities = labelling.entities;
  const auto class_of = [&](const std::string& label) { return ontology.find(label); };
  std::vector<std::size_t> faces;
  for (std::size_t i = 0; i < matcher.surface_count(); ++i) {
    const int c = class_of(entities[i].label);
    if (c >= 0 && ontology.classes[c].several_faces && entities[i].whole < 0) faces.push_back(i);
  }
  std::stable_sort(faces.begin(), faces.end(), [&](std::size_t a, std::size_t b) {
    return entities[a].area > entities[b].area;
  });
  std::vector<char> taken(matcher.surface_count(), 0);
  for (const auto first : faces) {
    if (taken[first] != 0) continue;
    std::vector<std::size_t> thing = {first};
    taken[first] = 1;
    const auto& clauses = matcher.clauses(class_of(entities[first].label));
    for (std::size_t k = 0; k < thing.size(); ++k) {
      for (const auto other : faces) {
        if (taken[other] != 0 || entities[other].label != entities[first].label) continue;
        const Item& a = items[thing[k]];
        const Item& b = items[other];
        if (a.box.exteriorDistance(b.box) > widest_gap) continue;
        const bool in_plane = relate({Relation::coplanar, {}}, a, b, {}).likelihood >= 0.5;
        const bool bent = relate({Relation::orthogonal, {}}, a, b, {}).likelihood >= 0.5;
        const bool touch = relate({Relation::touching, {}}, a, b, {}).likelihood >= 0.5;
        const bool layered = are_layers(a, b);
        if (!(touch && bent) && !((in_plane || layered) &&
                                  is_one(clauses, items, thing, items[other], touch || layered)))
          continue;
        taken[other] = 1;
        thing.push_back(other);
      }
    }
    for (std::size_t k = 1; k < thing.size(); ++k) {
      auto& face = entities[thing[k]];
      face.whole = static_cast<std::int32_t>(first);
      for (const auto s : face.surfaces) {
        entities[first].surfaces.push_back(s);
        labelling.entity_of_surface[s] = static_cast<std::int32_t>(first);
      }
    }
  }
}

}  // namespace scanchor
