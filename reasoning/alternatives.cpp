#include "reasoning/alternatives.hpp"

#include <algorithm>
#include <cmath>

#include "reasoning/background.hpp"
#include "reasoning/join_surfaces.hpp"
#include "reasoning/levelled.hpp"
#include "reasoning/matcher.hpp"
#include "reasoning/recut.hpp"

namespace scanchor {

namespace {

constexpr int most_pieces = 6;
constexpr double shortest_piece = 0.2;  // [m]
constexpr double widest_shadow = 0.6;   // [m]
const double prior_of_seam = std::log(0.3);
// Where the outline falls apart by more than a shadow covers, training rooms hold seven times as
// many rows of things as things in pieces.
const double prior_of_gap = std::log(7.0);
const double prior_of_even_cut = std::log(0.02);
const double prior_of_join = std::log(0.3);
// Of two things beside each other about one in ten has both sides in line; of one thing all have.
const double in_line = std::log(10.0);
constexpr double line_tolerance = 0.06;  // [m]

enum class CutAt {
  wide_gaps,  ///< where the outline falls apart by more than a shadow covers
  outline,    ///< where it falls into pieces
  inside      ///< where points thin out, or evenly
};

/// Positions of cuts along the longer side; none: not cut.
struct Places {
  std::vector<double> at;
  double prior;
  bool seams;  ///< something shows where one ends
};

/// ln of each class's weight against unknown, of each surface; what only a group holds together
/// counts as the group.
struct Explained {
  std::vector<std::vector<double>> of_class;  ///< -infinity: ruled out
  /// All that a surface may be, unknown included: ln(1 + sum of the classes).
  [[nodiscard]] double all(std::int32_t surface) const {
    double sum = 1.0;
    for (const double s : of_class[surface]) sum += std::exp(std::min(s, 50.0));
    return std::log(sum);
  }
  [[nodiscard]] int best(std::int32_t surface) const {
    const auto& scores = of_class[surface];
    return static_cast<int>(std::max_element(scores.begin(), scores.end()) - scores.begin());
  }
};

/// Side by side lie equal things: no side is by more than a third longer than another's.
bool are_equal(const std::vector<Surface>& pieces) {
  Eigen::Array2d least(INFINITY, INFINITY);
  Eigen::Array2d most(0.0, 0.0);
  for (const auto& piece : pieces) {
    const Eigen::Array2d sides(piece.rectangle.length.value, piece.rectangle.width.value);
    least = least.min(sides);
    most = most.max(sides);
  }
  return least.x() >= shortest_piece && (most <= 1.34 * least).all();
}

class Reader {
 public:
  Reader(const Surfaces& surfaces, const PointCloud& cloud, const Ontology& ontology,
         const ReasonOptions& options)
      : surfaces_(surfaces), cloud_(cloud), ontology_(ontology) {
    const Levelled levelled = level(surfaces, options);
    R_ = levelled.R_level_cloud;
    around_ = levelled.around;
    for (const auto& description : ontology.classes) {
      const int whole = description.part_of.empty() ? -1 : ontology.find(description.part_of);
      bool member = false;
      if (whole >= 0) {
        for (const auto& clause : all_clauses(ontology, whole))
          member =
              member || (clause.kind == ClauseKind::group && clause.target == description.name());
      }
      only_member_.push_back(member);
    }
    for (std::size_t c = 0; c < ontology.classes.size(); ++c)
      clauses_.push_back(all_clauses(ontology, static_cast<int>(c)));
    as_it_is_ = explain(surfaces);
  }

  struct Choice {
    Alternative alternative;
    std::vector<std::int32_t> removed;
    std::vector<Surface> added;
  };

  std::vector<Choice> choose() {
    std::vector<Choice> choices;
    for (const CutAt where : {CutAt::wide_gaps, CutAt::outline, CutAt::inside})
      cut_all(where, choices);
    join_all(choices);
    // The best first; what it reads anew is taken.
    std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
      return a.alternative.log_ratio > b.alternative.log_ratio;
    });
    std::vector<char> taken(surfaces_.surfaces.size(), 0);
    std::vector<Choice> kept;
    for (auto& choice : choices) {
      const bool free = std::none_of(choice.removed.begin(), choice.removed.end(),
                                     [&](std::int32_t s) { return taken[s] != 0; });
      if (!free) continue;
      for (const auto s : choice.removed) taken[s] = 1;
      kept.push_back(std::move(choice));
    }
    return kept;
  }

 private:
  [[nodiscard]] Explained explain(const Surfaces& surfaces) const {
    Matcher matcher(ontology_, make_items(surfaces, R_), around_);
    matcher.run();
    const double unknown = std::log(unknown_prior_of(ontology_));
    Explained result;
    result.of_class.assign(surfaces.surfaces.size(),
                           std::vector<double>(ontology_.classes.size(), -INFINITY));
    for (std::size_t c = 0; c < ontology_.classes.size(); ++c) {
      if (only_member_[c]) continue;
      for (const auto& candidate : matcher.candidates(static_cast<int>(c))) {
        const double score = candidate.score - unknown;
        const Item& item = matcher.items()[candidate.item];
        if (!item.group) {
          result.of_class[candidate.item][c] = std::max(result.of_class[candidate.item][c], score);
          continue;
        }
        for (const auto m : item.members)
          result.of_class[m][c] = std::max(result.of_class[m][c], score);
      }
    }
    return result;
  }

  struct Cut {
    std::int32_t surface;
    double prior;
    bool at_seams;
    std::size_t first, count;  ///< of its pieces among those added
  };

  /// `pieces`: how many, of cuts inside.
  [[nodiscard]] Places places_of(const Surface& surface, CutAt where, int pieces) const {
    if (where == CutAt::wide_gaps)
      return {outline_cuts(surface, widest_shadow), prior_of_gap, true};
    if (where == CutAt::outline) return {outline_cuts(surface, 0.0), prior_of_seam, true};
    const double length = surface.rectangle.length.value;
    // An outline that falls into other pieces says itself where things end.
    if (length < shortest_piece * pieces || !outline_seams(surface).empty()) return {};
    if (auto seams = find_seams(surface, cloud_.points, pieces, surfaces_.point_spacing))
      return {*seams, prior_of_seam, true};
    std::vector<double> cuts;
    for (int k = 1; k < pieces; ++k) cuts.push_back(length * (k / double(pieces) - 0.5));
    return {cuts, prior_of_even_cut, false};
  }

  [[nodiscard]] static std::vector<double> outline_cuts(const Surface& surface, double gap) {
    auto seams = outline_seams(surface, gap);
    if (seams.size() >= most_pieces) seams.clear();
    return seams;
  }

  /// The most that a class can get from a piece, were all its relations satisfied; -infinity where
  /// its own features rule it out.
  [[nodiscard]] double most_of(std::size_t c, const Item& piece) const {
    double score =
        std::log(prior_of(ontology_, static_cast<int>(c))) - std::log(unknown_prior_of(ontology_));
    for (const auto& clause : clauses_[c]) {
      if (clause.kind == ClauseKind::group) {
        const auto member = static_cast<std::size_t>(ontology_.find(clause.target));
        return std::isinf(most_of(member, piece)) ? -INFINITY : INFINITY;
      }
      const double tolerance = clause.range.has_high() ? clause.range.high : 5.0;
      double most = 1.0;
      double least = clause.usually ? 0.0 : required_gate;
      if (clause.kind == ClauseKind::feature)
        most = least = feature(clause.feature, clause.range, piece).likelihood;
      if (clause.kind == ClauseKind::horizontal)
        most = least = horizontal(piece, around_, tolerance).likelihood;
      if (clause.kind == ClauseKind::vertical)
        most = least = vertical(piece, around_, tolerance).likelihood;
      if (clause.kind == ClauseKind::rectangular) most = least = rectangular(piece).likelihood;
      if (!clause.usually && most < required_gate) return -INFINITY;
      score += ontology_.temperature * weight_of(clause) *
               std::max(evidence_of(clause, most), evidence_of(clause, least));
    }
    return score;
  }

  /// The most that any class can get from the worst of these pieces: most cuts need no closer look.
  /// What only a group holds together has to show where it ends: without seams it gets nothing.
  [[nodiscard]] double most_of_all(const std::vector<Surface>& pieces, bool at_seams) const {
    Surfaces alone;
    alone.point_spacing = surfaces_.point_spacing;
    alone.surfaces = pieces;
    double best = -INFINITY;
    const auto items = make_items(alone, R_);
    for (std::size_t c = 0; c < ontology_.classes.size(); ++c) {
      if (!ontology_.classes[c].part_of.empty()) continue;
      double worst = INFINITY;
      for (const auto& item : items) worst = std::min(worst, most_of(c, item));
      if (at_seams || std::isfinite(worst)) best = std::max(best, worst);
    }
    return best;
  }

  /// Every surface that may be cut is, in one scene: they are each other's neighbours, as the
  /// boards of a rack are. Of several numbers of pieces the one that may get most is tried.
  void cut_all(CutAt where, std::vector<Choice>& choices) const {
    const bool by_gaps = where == CutAt::wide_gaps;
    const int fewest = where == CutAt::inside ? 2 : 0,
              most_tried = where == CutAt::inside ? most_pieces : 0;
    std::vector<std::int32_t> removed;
    std::vector<Cut> cuts;
    std::vector<Surface> added;
    for (const auto& surface : surfaces_.surfaces) {
      if (surface.inliers.empty() || (!by_gaps && surface.rectangularness < 0.6)) continue;
      // What is likelier than not as it is does not compete: a wide desk is no two narrow ones.
      const auto& as_it_is = as_it_is_.of_class[surface.id];
      if (!by_gaps && as_it_is[as_it_is_.best(surface.id)] > 0.0) continue;
      std::vector<Surface> best;
      Places best_places{};
      double most = -INFINITY;
      for (int pieces = fewest; pieces <= most_tried; ++pieces) {
        auto places = places_of(surface, where, pieces);
        if (places.at.empty()) continue;
        auto parts = cut_surface(surface, cloud_.points, places.at);
        if (!parts || (!by_gaps && !are_equal(*parts))) continue;
        const double gain =
            most_of_all(*parts, places.seams) - as_it_is_.all(surface.id) + places.prior;
        if (gain <= 0.0 || gain <= most) continue;
        most = gain;
        best = std::move(*parts);
        best_places = std::move(places);
      }
      if (best.empty()) continue;
      removed.push_back(surface.id);
      cuts.push_back({surface.id, best_places.prior, best_places.seams, added.size(), best.size()});
      for (auto& part : best) added.push_back(std::move(part));
    }
    if (removed.empty()) return;
    std::vector<std::int32_t> place;
    const Explained now = explain(with_changed(surfaces_, removed, added, &place));
    for (const auto& cut : cuts) {
      const double prior = cut.prior;
      int best_class = -1;
      double best = -INFINITY;
      for (std::size_t c = 0; c < ontology_.classes.size(); ++c) {
        // Parts are what is left of things: to cut for them is no reading of its own.
        if (!ontology_.classes[c].part_of.empty()) continue;
        double worst = INFINITY;
        for (std::size_t k = 0; k < cut.count; ++k)
          worst = std::min(worst, now.of_class[place[cut.first + k]][c]);
        if (worst <= best) continue;
        best = worst;
        best_class = static_cast<int>(c);
      }
      const double gain = best - as_it_is_.all(cut.surface) + prior;
      if (best_class < 0 || best <= 0.0 || gain <= 0.0) continue;
      Choice choice;
      choice.removed = {cut.surface};
      choice.added.assign(added.begin() + static_cast<long>(cut.first),
                          added.begin() + static_cast<long>(cut.first + cut.count));
      choice.alternative.kind = cut.at_seams ? "cut at seams" : "cut evenly";
      choice.alternative.class_name = ontology_.classes[best_class].name();
      choice.alternative.log_ratio = gain;
      choice.alternative.log_prior = prior;
      choices.push_back(std::move(choice));
    }
  }

  [[nodiscard]] bool may_join(const Surface& a, const Surface& b) const {
    const double sine = a.plane.normal.cross(b.plane.normal).norm();
    if (sine > 0.1 || a.polygons.empty() || b.polygons.empty()) return false;
    const double reach = 0.5 * (std::hypot(a.rectangle.length.value, a.rectangle.width.value) +
                                std::hypot(b.rectangle.length.value, b.rectangle.width.value));
    if ((a.plane.centroid - b.plane.centroid).norm() > 1.5 * reach + widest_shadow) return false;
    const auto face = facing(a, b);
    if (!face || face->gap > widest_shadow || face->common < 0.7 || face->shadow < 0.5)
      return false;
    const double sigma = std::hypot(a.plane.centroid_sigma, b.plane.centroid_sigma);
    return std::abs(face->across) < 0.02 + 2.0 * sigma;
  }

  void join_all(std::vector<Choice>& choices) const {
    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
    std::vector<char> used(surfaces_.surfaces.size(), 0);
    for (std::size_t i = 0; i < used.size(); ++i) {
      for (std::size_t j = i + 1; j < used.size() && used[i] == 0; ++j) {
        const Surface& a = surfaces_.surfaces[i];
        const Surface& b = surfaces_.surfaces[j];
        if (used[j] != 0 || !may_join(a, b)) continue;
        pairs.emplace_back(a.id, b.id);
        used[i] = used[j] = 1;
      }
    }
    if (pairs.empty()) return;
    std::vector<std::int32_t> removed;
    std::vector<Surface> added;
    for (const auto& [a, b] : pairs) {
      removed.push_back(a);
      removed.push_back(b);
      added.push_back(join_surfaces(surfaces_.surfaces[a], surfaces_.surfaces[b]));
    }
    std::vector<std::int32_t> place;
    const Explained joined = explain(with_changed(surfaces_, removed, added, &place));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto [a, b] = pairs[i];
      const int c = joined.best(place[i]);
      const double best = joined.of_class[place[i]][c];
      if (!ontology_.classes[c].part_of.empty()) continue;
      const int of_a = as_it_is_.best(a);
      const int of_b = as_it_is_.best(b);
      const double score_a = as_it_is_.of_class[a][of_a];
      const double score_b = as_it_is_.of_class[b][of_b];
      // A piece that is known for one already belongs to its whole without this.
      const bool piece_a = score_a > 0.0 && !ontology_.classes[of_a].part_of.empty();
      const bool piece_b = score_b > 0.0 && !ontology_.classes[of_b].part_of.empty();
      if (piece_a || piece_b) continue;
      const auto face = facing(surfaces_.surfaces[a], surfaces_.surfaces[b]);
      const double coincidence = face && face->step < line_tolerance ? in_line : 0.0;
      const double gain =
          best - std::max(as_it_is_.all(a), as_it_is_.all(b)) + prior_of_join + coincidence;
      if (best <= 0.0 || gain <= 0.0) continue;
      Choice choice;
      choice.removed = {a, b};
      choice.added = {added[i]};
      choice.alternative.kind = "joined over a shadow";
      choice.alternative.class_name = ontology_.classes[c].name();
      choice.alternative.log_ratio = gain;
      choice.alternative.log_prior = prior_of_join;
      choices.push_back(std::move(choice));
    }
  }

  const Surfaces& surfaces_;
  const PointCloud& cloud_;
  const Ontology& ontology_;
  Eigen::Matrix3d R_ = Eigen::Matrix3d::Identity();
  Surrounding around_;
  std::vector<bool> only_member_;
  std::vector<std::vector<Clause>> clauses_;  ///< of each class, its parents' included
  Explained as_it_is_;
};

}  // namespace

std::vector<Alternative> read_anew(Surfaces& surfaces, const PointCloud& cloud,
                                   const Ontology& ontology, const ReasonOptions& options) {
  if (!options.alternatives || options.mode != "default" || surfaces.surfaces.empty()) return {};
  auto choices = Reader(surfaces, cloud, ontology, options).choose();
  if (choices.empty()) return {};
  std::vector<std::int32_t> removed;
  std::vector<Surface> added;
  for (auto& choice : choices) {
    removed.insert(removed.end(), choice.removed.begin(), choice.removed.end());
    for (auto& s : choice.added) added.push_back(std::move(s));
  }
  std::vector<std::int32_t> place;
  surfaces = with_changed(surfaces, removed, std::move(added), &place);
  std::vector<Alternative> alternatives;
  std::size_t next = 0;
  for (auto& choice : choices) {
    choice.alternative.of = static_cast<int>(choice.removed.size());
    for (std::size_t k = 0; k < choice.added.size(); ++k)
      choice.alternative.surfaces.push_back(place[next++]);
    alternatives.push_back(std::move(choice.alternative));
  }
  return alternatives;
}

Labelling interpret(Surfaces& surfaces, const PointCloud& cloud, const Ontology& ontology,
                    const ReasonOptions& options) {
  auto alternatives = read_anew(surfaces, cloud, ontology, options);
  Labelling labelling = reason(surfaces, ontology, options);
  labelling.alternatives = std::move(alternatives);
  return labelling;
}

}  // namespace scanchor
