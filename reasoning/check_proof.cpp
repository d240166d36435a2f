#include "reasoning/check_proof.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace scanchor {

namespace {

constexpr double gate = 0.05;
constexpr double to_degrees = 57.29577951308232;

/// The corners of an entity's outline in the cloud's frame: those of its surface, or of all members
/// of a group.
void outline(const Surfaces& surfaces, const Labelling& labelling, std::int32_t id,
             std::vector<Eigen::Vector3d>& points) {
  const Entity& entity = labelling.entities[static_cast<std::size_t>(id)];
  if (!entity.members.empty()) {
    for (const auto m : entity.members) outline(surfaces, labelling, m, points);
    return;
  }
  const auto& surface = surfaces.surfaces[static_cast<std::size_t>(id)];
  for (const auto& polygon : surface.polygons) {
    for (const auto& p : polygon.outer)
      points.push_back(surface.T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0));
  }
}

/// Points spread over the fitted rectangle, for distances.
std::vector<Eigen::Vector3d> grid(const Surface& surface) {
  std::vector<Eigen::Vector3d> points;
  const auto& r = surface.rectangle;
  const Eigen::Vector2d u(std::cos(r.angle), std::sin(r.angle));
  const Eigen::Vector2d v(-u.y(), u.x());
  const int n = std::clamp(static_cast<int>(r.length.value / 0.02), 2, 160);
  const int m = std::clamp(static_cast<int>(r.width.value / 0.02), 2, 160);
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j) {
      const Eigen::Vector2d p = r.center + u * (r.length.value * (i / double(n) - 0.5)) +
                                v * (r.width.value * (j / double(m) - 0.5));
      points.push_back(surface.T_cloud_surface * Eigen::Vector3d(p.x(), p.y(), 0.0));
    }
  }
  return points;
}

double distance_to(const Surface& surface, const Eigen::Vector3d& point) {
  const Eigen::Vector3d local = surface.T_cloud_surface.inverse() * point;
  const auto& r = surface.rectangle;
  const Eigen::Vector2d d = local.head<2>() - r.center;
  const double a = d.x() * std::cos(r.angle) + d.y() * std::sin(r.angle);
  const double b = -d.x() * std::sin(r.angle) + d.y() * std::cos(r.angle);
  const double da = std::max(0.0, std::abs(a) - 0.5 * r.length.value);
  const double db = std::max(0.0, std::abs(b) - 0.5 * r.width.value);
  return std::sqrt(da * da + db * db + local.z() * local.z());
}

struct Span {
  double low = INFINITY, high = -INFINITY, middle = 0.0;
};

class Checker {
 public:
  Checker(const Surfaces& surfaces, const Ontology& ontology, const Labelling& labelling)
      : surfaces_(surfaces), ontology_(ontology), labelling_(labelling) {}

  std::vector<ProofFault> faults;

  void check(std::int32_t id, const std::string& class_name) {
    if (!path_.insert(id).second) {
      fault(id, "", "its proof leads back to itself");
      return;
    }
    if (done_.insert(id).second) check_clauses(id, class_name);
    path_.erase(id);
  }

 private:
  void fault(std::int32_t id, const std::string& clause, const std::string& text) {
    faults.push_back({id, clause, text});
  }

  void check_clauses(std::int32_t id, const std::string& class_name) {
    const Entity& entity = labelling_.entities[static_cast<std::size_t>(id)];
    const int c = ontology_.find(class_name);
    if (c < 0) {
      fault(id, "", "the ontology has no class '" + class_name + "'");
      return;
    }
    const auto clauses = all_clauses(ontology_, c);
    if (clauses.size() != entity.proof.size()) {
      fault(id, "",
            "the proof has " + std::to_string(entity.proof.size()) + " clauses, the description " +
                std::to_string(clauses.size()));
      return;
    }
    for (std::size_t i = 0; i < clauses.size(); ++i)
      check_clause(id, class_name, clauses[i], entity.proof[i], clauses[i].usually);
  }

  void check_clause(std::int32_t id, const std::string& class_name, const Clause& clause,
                    const ProofClause& claim, bool usually) {
    if (claim.text != clause_text(clause)) {
      fault(id, claim.text, "is no clause of '" + class_name + "'");
      return;
    }
    if (!(claim.likelihood >= 0.0 && claim.likelihood <= 1.0))
      fault(id, claim.text, "likelihood outside [0, 1]");
    if (!usually && claim.likelihood < gate)
      fault(id, claim.text, "a required clause is below 0.05");
    check_measurement(id, clause, claim);
    for (const auto t : claim.targets) check_target(id, clause, claim, t);
    check_said_of_target(id, clause, claim, usually);
  }

  /// "that is ...": one proof a nested clause, of the target; the clause holds no better than they
  /// do together.
  void check_said_of_target(std::int32_t id, const Clause& clause, const ProofClause& claim,
                            bool usually) {
    if (claim.targets.empty() || clause.target_clauses.empty()) return;
    if (claim.that_is.size() != clause.target_clauses.size()) {
      fault(id, claim.text, "does not prove what it says of its target");
      return;
    }
    const std::int32_t t = claim.targets.front();
    if (t < 0 || static_cast<std::size_t>(t) >= labelling_.entities.size()) return;
    double together = 1.0;
    for (std::size_t i = 0; i < clause.target_clauses.size(); ++i) {
      // A target that fails is named where the whole clause need not hold.
      const bool may_fail = usually || clause.kind == ClauseKind::negation;
      check_clause(t, clause.target, clause.target_clauses[i], claim.that_is[i], may_fail);
      together *= claim.that_is[i].likelihood;
    }
    if (clause.kind == ClauseKind::relation && claim.likelihood > together + 1e-6)
      fault(id, claim.text, "is likelier than what it says of its target");
  }

  void check_target(std::int32_t id, const Clause& clause, const ProofClause& claim,
                    std::int32_t t) {
    if (t < 0 || static_cast<std::size_t>(t) >= labelling_.entities.size()) {
      fault(id, claim.text, "names entity " + std::to_string(t) + ", which is not there");
      return;
    }
    if (clause.kind == ClauseKind::negation || clause.kind == ClauseKind::group) return;
    // Context that does not hold may name anything.
    if (clause.usually && claim.likelihood < gate) return;
    const Entity& target = labelling_.entities[static_cast<std::size_t>(t)];
    const int wanted = ontology_.find(clause.target);
    bool among = false;
    for (const auto& p : target.classes) among = among || ontology_.find(p.name) == wanted;
    if (!among) {
      fault(id, claim.text, "target " + std::to_string(t) + " is no " + clause.target);
    } else if (!clause.usually && target.label == clause.target) {
      check(t, clause.target);  // context may go in circles
    }
  }

  void check_measurement(std::int32_t id, const Clause& clause, const ProofClause& claim) {
    double tolerance = 1e-6;
    const auto expected = measure(id, clause, claim, tolerance);
    if (!expected) return;
    if (std::abs(*expected - claim.measured) > tolerance + 1e-6 * std::abs(*expected)) {
      fault(id, claim.text,
            "says " + std::to_string(claim.measured) + ", the surfaces give " +
                std::to_string(*expected));
      return;
    }
    if (clause.kind != ClauseKind::feature) return;
    // Sides of a limit: far inside must be likely, far outside unlikely unless the rest may lie in
    // a shadow.
    const bool cut = !labelling_.entities[static_cast<std::size_t>(id)].members.empty() ||
                     surfaces_.surfaces[static_cast<std::size_t>(id)].occluded_outline > 0.0;
    const auto outside = [&](double limit, double sign) {
      const double soft =
          3.0 * std::hypot(claim.sigma, (clause.feature == Feature::area ? 0.15 : 0.10) * limit);
      return std::isfinite(limit) ? sign * (*expected - limit) / std::max(soft, 1e-9) : -2.0;
    };
    const double above = outside(clause.range.high, 1.0);
    const double below = outside(clause.range.low, -1.0);
    if (std::max(above, below) < -1.0 && claim.likelihood < 0.5)
      fault(id, claim.text, "holds clearly, the proof denies it");
    if (above > 1.0 && claim.likelihood > 0.5)
      fault(id, claim.text, "fails clearly, the proof affirms it");
    if (below > 1.0 && !cut && claim.likelihood > 0.5)
      fault(id, claim.text, "fails clearly, the proof affirms it");
  }

  Span span(std::int32_t id) const {
    std::vector<Eigen::Vector3d> points;
    outline(surfaces_, labelling_, id, points);
    Span s;
    for (const auto& p : points) {
      s.low = std::min(s.low, labelling_.up.dot(p));
      s.high = std::max(s.high, labelling_.up.dot(p));
    }
    s.middle = labelling_.up.dot(labelling_.entities[static_cast<std::size_t>(id)].center);
    return s;
  }

  /// Height of a level surface below (or above) the middle of another entity; nothing for what is
  /// not level.
  std::optional<double> top_at(std::int32_t lower, std::int32_t upper) const {
    if (!labelling_.entities[static_cast<std::size_t>(lower)].members.empty()) return std::nullopt;
    const Plane& plane = surfaces_.surfaces[static_cast<std::size_t>(lower)].plane;
    const Eigen::Vector3d& up = labelling_.up;
    const double along = plane.normal.dot(up);
    if (std::abs(along) <= 0.94) return std::nullopt;
    // Up from the middle of the upper one until the plane is met.
    const Eigen::Vector3d from = labelling_.entities[static_cast<std::size_t>(upper)].center;
    return up.dot(from) + (plane.offset - plane.normal.dot(from)) / along;
  }

  /// What plain geometry gives for the clause's number; nothing where the number is no plain
  /// measurement.
  std::optional<double> measure(std::int32_t id, const Clause& clause, const ProofClause& claim,
                                double& tolerance) const {
    const bool single = labelling_.entities[static_cast<std::size_t>(id)].members.empty();
    if (claim.unit.empty()) return std::nullopt;
    if (single) {
      const auto& surface = surfaces_.surfaces[static_cast<std::size_t>(id)];
      const Eigen::Vector3d& n = surface.plane.normal;
      if (clause.kind == ClauseKind::feature) {
        switch (clause.feature) {
          case Feature::area:
            return surface.area.value;
          case Feature::extension:
            return surface.rectangle.length.value;
          case Feature::width:
            return surface.rectangle.width.value;
          case Feature::rectangularness:
            return surface.rectangularness;
          case Feature::height: {
            const Span s = span(id);
            return s.high - s.low;
          }
          case Feature::elongation:
            return surface.rectangle.length.value / std::max(surface.rectangle.width.value, 1e-3);
          case Feature::members:
            return 1.0;
        }
      }
      if (clause.kind == ClauseKind::rectangular) return surface.rectangularness;
      const double angle = std::acos(std::min(1.0, std::abs(n.dot(labelling_.up)))) * to_degrees;
      tolerance = 1e-4;
      if (clause.kind == ClauseKind::horizontal || clause.kind == ClauseKind::vertical) {
        return angle;
      }
    } else if (clause.kind == ClauseKind::group ||
               (clause.kind == ClauseKind::feature && clause.feature == Feature::members)) {
      return static_cast<double>(labelling_.entities[static_cast<std::size_t>(id)].members.size());
    }
    if (clause.kind != ClauseKind::relation || claim.targets.size() != 1 ||
        clause.relations.size() != 1)
      return std::nullopt;
    const std::int32_t t = claim.targets.front();
    if (t < 0 || static_cast<std::size_t>(t) >= labelling_.entities.size()) return std::nullopt;
    const bool both = single && labelling_.entities[static_cast<std::size_t>(t)].members.empty();
    const Span a = span(id);
    const Span b = span(t);
    tolerance = 1e-4;
    switch (clause.relations.front().relation) {
      case Relation::elevation:
        return a.middle - b.middle;
      case Relation::bottom:
        return a.low - b.middle;
      case Relation::top:
        return a.high - b.middle;
      case Relation::above:
      case Relation::on:
        return a.low - top_at(t, id).value_or(b.high);
      case Relation::below:
        return b.low - top_at(id, t).value_or(a.high);
      case Relation::higher:
        return a.middle - b.middle;
      case Relation::lower:
        return b.middle - a.middle;
      default:
        break;
    }
    if (!both) return std::nullopt;
    const auto& sa = surfaces_.surfaces[static_cast<std::size_t>(id)];
    const auto& sb = surfaces_.surfaces[static_cast<std::size_t>(t)];
    const double angle =
        std::acos(std::min(1.0, std::abs(sa.plane.normal.dot(sb.plane.normal)))) * to_degrees;
    tolerance = 1e-3;
    switch (clause.relations.front().relation) {
      case Relation::parallel:
      case Relation::orthogonal:
        return angle;
      case Relation::near:
      case Relation::touching: {
        double best = INFINITY;
        for (const auto& p : grid(sa)) best = std::min(best, distance_to(sb, p));
        for (const auto& p : grid(sb)) best = std::min(best, distance_to(sa, p));
        tolerance = 0.02;
        return best;
      }
      case Relation::set_back: {
        if (surfaces_.sensor_positions.empty()) return std::nullopt;
        const auto height = [&](const Eigen::Vector3d& p) {
          return sb.plane.normal.dot(p - sb.plane.centroid);
        };
        const double sensor = height(surfaces_.sensor_positions.front());
        return sensor >= 0.0 ? -height(sa.plane.centroid) : height(sa.plane.centroid);
      }
      default:
        return std::nullopt;
    }
  }

  const Surfaces& surfaces_;
  const Ontology& ontology_;
  const Labelling& labelling_;
  std::set<std::int32_t> done_, path_;
};

}  // namespace

std::vector<ProofFault> check_proof(const Surfaces& surfaces, const Ontology& ontology,
                                    const Labelling& labelling, std::int32_t entity) {
  Checker checker(surfaces, ontology, labelling);
  if (entity < 0 || static_cast<std::size_t>(entity) >= labelling.entities.size()) {
    checker.faults.push_back({entity, "", "there is no such entity"});
    return checker.faults;
  }
  const auto& label = labelling.entities[static_cast<std::size_t>(entity)].label;
  if (label != "unknown" && label != "ambiguous") checker.check(entity, label);
  return checker.faults;
}

}  // namespace scanchor
