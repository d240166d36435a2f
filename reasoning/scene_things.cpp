#include "reasoning/scene_things.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/math.hpp"
#include "reasoning/corner.hpp"
#include "reasoning/likelihood.hpp"

namespace scanchor {

namespace {

constexpr double most_unseen_stand = 0.45;  // [m] stands of screens hold them up to 0.4 m high
constexpr double hangs_before = 0.12;       // [m] what hangs on a wall

/// Does a hang flat before or in the plane of b?
Evidence lies_before(const Item& a, const Item& b, const Surrounding& around) {
  RelationTerm flat{Relation::coplanar, {}};
  flat.range.high = hangs_before;
  return relate(flat, a, b, around);
}

/// The point of a footprint that is nearest to p.
Eigen::Vector2d nearest_point(const Footprint& foot, const Eigen::Vector2d& p) {
  const double uu = foot.u.squaredNorm();
  const double vv = foot.v.squaredNorm();
  const Eigen::Vector2d d = p - foot.center;
  // Sides are at right angles but for things that lean; then it is a good guess.
  const double s = std::clamp(d.dot(foot.u) / uu, -1.0, 1.0);
  const double t = std::clamp(d.dot(foot.v) / vv, -1.0, 1.0);
  return foot.center + s * foot.u + t * foot.v;
}

}  // namespace

SceneThings::SceneThings(const Surfaces& surfaces, const Ontology& ontology,
                         const Labelling& labelling)
    : ontology_(ontology), labelling_(labelling) {
  if (labelling.entity_of_surface.size() != surfaces.surfaces.size() ||
      labelling.entities.size() < surfaces.surfaces.size()) {
    fail_data("labels.json", "",
              "is of " + std::to_string(labelling.entity_of_surface.size()) +
                  " surfaces, surfaces.json has " + std::to_string(surfaces.surfaces.size()),
              "label the scan again");
  }
  const Eigen::Matrix3d R = levelling(labelling.up);
  around_.up_sigma = labelling.up_sigma;
  if (!surfaces.sensor_positions.empty()) around_.viewpoint = R * surfaces.sensor_positions.front();
  items_ = make_items(surfaces, R);
  for (std::size_t e = items_.size(); e < labelling.entities.size(); ++e) {
    const auto& members = labelling.entities[e].members;
    const auto id = static_cast<std::int32_t>(e);
    if (members.empty() ||
        std::any_of(members.begin(), members.end(), [&](std::int32_t m) { return m >= id; }))
      fail_data("labels.json", "object " + std::to_string(e),
                "is no surface and no group of what stands before it", "label the scan again");
    items_.push_back(make_group(items_, members, id));
  }

  std::vector<Evidence> level;
  for (std::size_t s = 0; s < surfaces.surfaces.size(); ++s)
    level.push_back(horizontal(items_[s], around_));
  extent_ = SceneExtent({items_.begin(), items_.begin() + static_cast<long>(level.size())}, level);

  thing_.assign(items_.size(), 0);
  for (const auto id : things(labelling)) thing_[id] = 1;
  whole_ = items_;
  for (std::int32_t id = 0; id < size(); ++id) {
    for (const auto face : faces(id)) {
      whole_[id].box.extend(items_[face].box);
      whole_[id].z_low = std::min(whole_[id].z_low, items_[face].z_low);
      whole_[id].z_high = std::max(whole_[id].z_high, items_[face].z_high);
    }
  }

  // What a labelling says of a class counts its parts as well: they are taken off.
  own_probability_.assign(items_.size(), std::vector<double>(ontology.classes.size(), 0.0));
  for (std::int32_t id = 0; id < size(); ++id) {
    auto& own = own_probability_[id];
    for (const auto& said : entity(id).classes) {
      const int c = ontology.find(said.name);
      if (c < 0) continue;
      own[c] += said.probability;
      const auto& description = ontology.classes[c];
      if (description.parent.empty() && !description.part_of.empty())
        own[ontology.find(description.part_of)] -= said.probability;
    }
    for (std::size_t c = 0; c < own.size(); ++c) {
      if (!is_thing(id) && ontology.classes[c].part_of.empty()) own[c] = 0.0;
      own[c] = std::clamp(own[c], 0.0, 1.0);
    }
    const std::int32_t whole = entity(id).whole;
    if (whole < 0) continue;
    const auto& members = entity(whole).members;
    const int group = ontology.find(entity(whole).label);
    if (group < 0 || std::find(members.begin(), members.end(), id) == members.end()) continue;
    for (const auto& clause : all_clauses(ontology, group)) {
      if (clause.kind == ClauseKind::group)
        own[ontology.find(clause.target)] = entity(whole).probability;
    }
  }
}

std::vector<std::int32_t> SceneThings::faces(std::int32_t id) const {
  const auto& surfaces = entity(id).surfaces;
  return surfaces.empty() ? std::vector<std::int32_t>{id} : surfaces;
}

double SceneThings::probability(std::int32_t id, const std::vector<int>& classes) const {
  if (classes.empty()) return is_thing(id) ? 1.0 : 0.0;
  double sum = 0.0;
  for (const int c : classes) sum += own_probability_[id][c];
  return std::min(1.0, sum);
}

Evidence SceneThings::own(const Clause& clause, std::int32_t id) const {
  const Item& a = items_[id];
  const double tolerance = clause.range.has_high() ? clause.range.high : 5.0;
  switch (clause.kind) {
    case ClauseKind::feature:
      return feature(clause.feature, clause.range, a);
    case ClauseKind::horizontal:
      return horizontal(a, around_, tolerance);
    case ClauseKind::vertical:
      return vertical(a, around_, tolerance);
    case ClauseKind::rectangular:
      return rectangular(a);
    case ClauseKind::extremum:
      return clause.extremum == Extremum::cornered ? cornered(items_, a, around_)
                                                   : extent_.extremum(clause.extremum, a, around_);
    default:
      return {};
  }
}

bool SceneThings::belongs(std::int32_t part, std::int32_t whole) const {
  if (part == whole) return false;
  const auto& members = entity(whole).members;
  return entity(part).whole == whole ||
         (is_thing(whole) && std::find(members.begin(), members.end(), part) != members.end());
}

double SceneThings::fixed_to_something(std::int32_t id) const {
  const Item& a = items_[id];
  double most = 0.0;
  for (const auto& b : items_) {
    if (b.group || b.id == id || b.area.value < 4.0 * a.area.value) continue;
    if (a.box.exteriorDistance(b.box) > 0.15) continue;
    most = std::max(most, lies_before(a, b, around_).likelihood);
  }
  return most;
}

Evidence SceneThings::hangs_on(std::int32_t a, std::int32_t b) const {
  Evidence best;
  const Item& hanging = items_[a];
  for (const auto face : faces(b)) {
    const Item& behind = items_[face];
    const Eigen::Vector3d d = hanging.center - behind.center;
    if (hanging.group || behind.group || behind.area.value <= hanging.area.value ||
        std::abs(behind.along.dot(d)) > behind.half_length ||
        std::abs(behind.across.dot(d)) > behind.half_width)
      continue;
    Evidence on = lies_before(hanging, behind, around_);
    on.likelihood *= vertical(behind, around_, 10.0).likelihood;
    if (on.likelihood > best.likelihood) best = on;
  }
  return best;
}

Evidence SceneThings::stands_on(std::int32_t a, std::int32_t b) const {
  Evidence best;
  const Item& standing = whole_[a];
  for (const auto face : faces(b)) {
    const Item& top = items_[face];
    Evidence on = scanchor::relate({Relation::on, {}}, standing, top, around_);
    if (on.likelihood < 0.9 && on.measured > 0.0 && on.measured < 1.0) {
      // A stand or legs between the two need not have been seen.
      const double s = std::hypot(on.sigma, 0.02);
      double held = between_likelihood(on.measured, -0.03, most_unseen_stand, s);
      const double overlap = footprint_overlap(standing.footprint, top.footprint);
      held *= overlap > 0.0 ? lower_likelihood(overlap, 0.3, 0.1) : 0.0;
      held *= horizontal(top, around_).likelihood;
      if (held > on.likelihood) held *= 1.0 - fixed_to_something(a);
      on.likelihood = std::max(on.likelihood, held);
    }
    if (on.likelihood > best.likelihood || best.unit[0] == '\0') best = on;
  }
  return best;
}

Evidence SceneThings::relate(const RelationTerm& term, std::int32_t a, std::int32_t b) const {
  if (a == b || entity(a).whole == b || entity(b).whole == a || belongs(a, b) || belongs(b, a))
    return {};
  switch (term.relation) {
    case Relation::on: {
      const Evidence stands = stands_on(a, b);
      const Evidence hangs = hangs_on(a, b);
      return hangs.likelihood > stands.likelihood ? hangs : stands;
    }
    case Relation::supports:
      return stands_on(b, a);
    case Relation::near:
    case Relation::touching: {
      Evidence best;
      for (const auto f : faces(a)) {
        for (const auto g : faces(b)) {
          const Evidence near = scanchor::relate(term, items_[f], items_[g], around_);
          if (best.unit[0] == '\0' || near.likelihood > best.likelihood ||
              (near.likelihood == best.likelihood && near.measured < best.measured))
            best = near;
        }
      }
      return best;
    }
    case Relation::above:
    case Relation::below:
      return scanchor::relate(term, whole_[a], items_[b], around_);
    default:
      return scanchor::relate(term, items_[a], items_[b], around_);
  }
}

Evidence SceneThings::held_by(std::int32_t what, std::int32_t holder) const {
  if (belongs(what, holder)) return {1.0, 0.0, 0.0, ""};
  const Evidence on = relate({Relation::on, {}}, what, holder);
  const Evidence inside =
      items_[holder].group ? relate({Relation::inside, {}}, what, holder) : Evidence{};
  return inside.likelihood > on.likelihood ? inside : on;
}

Evidence SceneThings::between(std::int32_t id, std::int32_t a, std::int32_t b) const {
  if (id == a || id == b || a == b) return {};
  const Item& item = items_[id];
  const Eigen::Vector2d here = item.center.head<2>();
  const Eigen::Vector2d to_a = nearest_point(items_[a].footprint, here) - here;
  const Eigen::Vector2d to_b = nearest_point(items_[b].footprint, here) - here;
  if (to_a.norm() < 1e-3 || to_b.norm() < 1e-3) return {0.0, 0.0, 0.0, "deg"};  // over one of them
  const double apart = std::acos(std::clamp(to_a.normalized().dot(to_b.normalized()), -1.0, 1.0));
  const double sigma = std::hypot(0.02, item.extension.sigma) / std::min(to_a.norm(), to_b.norm());
  return {lower_likelihood(apart, radians(120.0), std::hypot(sigma, radians(10.0))), degrees(apart),
          degrees(sigma), "deg"};
}

Evidence SceneThings::distance(std::int32_t a, std::int32_t b) const {
  Evidence best{1.0, INFINITY, 0.0, "m"};
  for (const auto f : faces(a)) {
    for (const auto g : faces(b)) {
      const double gap = gap_distance(items_[f], items_[g]);
      if (gap >= best.measured) continue;
      best.measured = gap;
      best.sigma = std::hypot(items_[f].extension.sigma, items_[g].extension.sigma);
    }
  }
  return best;
}

}  // namespace scanchor
