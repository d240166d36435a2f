#include "reasoning/relation_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "core/error.hpp"
#include "core/math.hpp"
#include "core/parallel.hpp"
#include "reasoning/likelihood.hpp"
#include "reasoning/plane_error.hpp"

namespace scanchor {

namespace {

constexpr double least_probability = 1e-3;  // one false statement must not outweigh all others
constexpr double prior_strength = 3.0;      // samples that hold a constant where it was
constexpr std::size_t block = 256;          // samples that are summed together

struct Part {
  const char* name;
  std::vector<Relation> relations;  // none: planes
};
// In this order, since likelihoods of later ones use those before.
const std::vector<Part>& parts() {
  static const std::vector<Part> all = {
      {"planes", {}},
      {"angles", {Relation::parallel, Relation::orthogonal}},
      {"level", {}},
      {"ends", {Relation::near, Relation::above, Relation::on}},
      {"carried", {Relation::above, Relation::on}},
      {"near", {Relation::near}},
      {"coplanar", {Relation::coplanar}},
      {"sizes", {Relation::same_size}},
      {"middles", {Relation::aligned}},
      {"bearings", {Relation::left_of, Relation::in_front_of}},
  };
  return all;
}

double three_digits(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return std::atof(text);
}

double loss_of(double probability, bool holds) {
  const double p = std::clamp(probability, least_probability, 1.0 - least_probability);
  return -std::log(holds ? p : 1.0 - p);
}

/// Sum in blocks: the same for any number of threads.
double total(std::size_t count, const std::function<double(std::size_t)>& one) {
  std::vector<double> sums((count + block - 1) / block, 0.0);
  parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sums[i / block] += one(i);
  });
  double sum = 0.0;
  for (const double s : sums) sum += s;
  return sum;
}

struct Place {
  std::size_t scene, index;
};

class ConstantsFit {
 public:
  ConstantsFit(const std::vector<RelationScene>& scenes, const RelationModel& start,
               const RelationFitOptions& options)
      : options_(options), scenes_(scenes), start_(start), model_(start) {
    for (auto& scene : scenes_) use_model(scene, model_);
  }

  RelationFit run() {
    RelationFit fit;
    for (const auto& part : parts()) {
      choose_samples(part);
      if (places_.empty()) continue;
      RelationFitPart done{part.name, places_.size(), 0.0, 0.0};
      done.before = loss(part) / static_cast<double>(places_.size());
      done.after = descend(part) / static_cast<double>(places_.size());
      fit.parts.push_back(done);
      if (std::string(part.name) == "planes") {
        for (auto& scene : scenes_) use_model(scene, model_);
      }
    }
    fit.model = model_;
    return fit;
  }

 private:
  void choose_samples(const Part& part) {
    places_.clear();
    const std::string name = part.name;
    if (name == "planes" || name == "level") {
      for (std::size_t s = 0; s < scenes_.size(); ++s) {
        for (std::size_t i = 0; i < scenes_[s].normals.size(); ++i) places_.push_back({s, i});
      }
      return;
    }
    for (const Relation relation : part.relations) {
      std::vector<Place> own;
      for (std::size_t s = 0; s < scenes_.size(); ++s) {
        for (std::size_t i = 0; i < scenes_[s].samples.size(); ++i) {
          if (scenes_[s].samples[i].relation == relation) own.push_back({s, i});
        }
      }
      const std::size_t number = std::min(own.size(), options_.most_samples);
      for (std::size_t i = 0; i < number; ++i) places_.push_back(own[i * own.size() / number]);
    }
  }

  [[nodiscard]] double loss(const Part& part) const {
    const std::string name = part.name;
    if (name == "planes")
      return total(places_.size(), [&](std::size_t i) { return loss_of_normal(places_[i]); });
    if (name == "level")
      return total(places_.size(), [&](std::size_t i) { return loss_of_level(places_[i]); });
    return total(places_.size(), [&](std::size_t i) {
      const RelationScene& scene = scenes_[places_[i].scene];
      const RelationSample& sample = scene.samples[places_[i].index];
      RelationTerm term;
      term.relation = sample.relation;
      const double said = relate(term, scene.items[static_cast<std::size_t>(sample.a)],
                                 scene.items[static_cast<std::size_t>(sample.b)], scene.around)
                              .likelihood;
      return loss_of(said, sample.holds);
    });
  }

  /// Minus logarithm of the density of the true normal, across the found one.
  [[nodiscard]] double loss_of_normal(const Place& place) const {
    const RelationScene& scene = scenes_[place.scene];
    const NormalSample& sample = scene.normals[place.index];
    const Surface& surface = scene.surfaces.surfaces[static_cast<std::size_t>(sample.surface)];
    Eigen::Vector3d off = sample.normal;
    if (off.dot(surface.plane.normal) < 0.0) off = -off;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
        plane_error(surface, scene.surfaces, model_));
    double density = 0.0;
    for (const double factor : {1.0, model_.gross_factor}) {
      const double share = factor > 1.0 ? model_.gross_share : 1.0 - model_.gross_share;
      double one = share;
      for (int k = 1; k < 3; ++k) {
        const double sigma = std::hypot(factor * std::sqrt(std::max(0.0, axes.eigenvalues()[k])),
                                        radians(model_.flatness));
        one *= normal_density(axes.eigenvectors().col(k).dot(off), sigma);
      }
      density += one;
    }
    return -std::log(std::max(density, 1e-12));
  }

  /// Whether a face is level and whether it is upright, by its true normal.
  [[nodiscard]] double loss_of_level(const Place& place) const {
    const RelationScene& scene = scenes_[place.scene];
    const NormalSample& sample = scene.normals[place.index];
    const double z = std::abs((scene.R_level_cloud * sample.normal).z());
    const double from_level = std::acos(std::min(1.0, z));
    const Item& item = scene.items[static_cast<std::size_t>(sample.surface)];
    return loss_of(horizontal(item, scene.around).likelihood, from_level <= radians(5.0)) +
           loss_of(vertical(item, scene.around).likelihood, from_level >= radians(85.0));
  }

  [[nodiscard]] bool possible() const {
    return model_.faces_parallel + model_.faces_nearly_parallel + model_.faces_orthogonal +
                   model_.faces_nearly_orthogonal <
               0.98 &&
           model_.level_parallel + model_.level_nearly_parallel + model_.level_orthogonal +
                   model_.level_nearly_orthogonal <
               0.98;
  }

  /// One constant after the other a step up or down its logarithm, where that makes the samples
  /// likelier; half the step where none does.
  double descend(const Part& part) {
    std::vector<const RelationConstant*> own;
    for (const auto& constant : relation_constants()) {
      if (std::string(constant.part) == part.name) own.push_back(&constant);
    }
    std::vector<double> step(own.size(), 0.4);
    const auto held = [&] {
      double sum = 0.0;
      for (const auto* constant : own)
        sum += prior_strength * sqr(std::log(model_.*constant->value / (start_.*constant->value)));
      return sum;
    };
    double best = loss(part) + held();
    for (int round = 0; round < options_.rounds; ++round) {
      bool busy = false;
      for (std::size_t k = 0; k < own.size(); ++k) {
        if (std::abs(step[k]) < options_.least_step) continue;
        busy = true;
        double& value = model_.*own[k]->value;
        const double old = value;
        bool better = false;
        for (const double sign : {1.0, -1.0}) {
          value =
              three_digits(std::clamp(old * std::exp(sign * step[k]), own[k]->low, own[k]->high));
          if (value == old || !possible()) continue;
          const double now = loss(part) + held();
          if (now < best - 1e-9 * best) {
            best = now;
            step[k] = std::clamp(1.3 * sign * step[k], -1.0, 1.0);  // first try the way that helped
            better = true;
            break;
          }
        }
        if (better) continue;
        value = old;
        step[k] *= 0.4;
      }
      if (!busy) break;
    }
    return loss(part);
  }

  const RelationFitOptions options_;
  std::vector<RelationScene> scenes_;
  const RelationModel start_;
  RelationModel model_;
  std::vector<Place> places_;
};

}  // namespace

void use_model(RelationScene& scene, const RelationModel& model) {
  scene.around.model = &model;
  const Eigen::Matrix3d& R = scene.R_level_cloud;
  for (std::size_t i = 0; i < scene.items.size(); ++i) {
    Item& item = scene.items[i];
    item.normal_covariance =
        R * plane_error(scene.surfaces.surfaces[i], scene.surfaces, model) * R.transpose();
    item.tilt_sigma = tilt_sigma_of(item.normal_covariance);
  }
}

RelationFit fit_relations(const std::vector<RelationScene>& scenes, const RelationModel& start,
                          const RelationFitOptions& options) {
  const bool any = std::any_of(scenes.begin(), scenes.end(), [](const RelationScene& scene) {
    return !scene.samples.empty() || !scene.normals.empty();
  });
  if (!any) fail_data("fit", "", "there is no pair of faces to learn relations from");
  return ConstantsFit(scenes, start, options).run();
}

}  // namespace scanchor
