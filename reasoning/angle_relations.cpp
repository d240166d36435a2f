#include "reasoning/angle_relations.hpp"

#include <algorithm>
#include <cmath>

#include "core/math.hpp"
#include "reasoning/likelihood.hpp"
#include "reasoning/relation_model.hpp"

namespace scanchor {

namespace {

constexpr double most_lost = 0.5;  // of planes whose direction is hardly known

/// The tilt of one direction against another, in the axes of its covariance.
struct RelativeTilt {
  Eigen::Vector2d mean, sigma;  // [rad]
};

RelativeTilt relative_tilt(const Eigen::Vector3d& a, Eigen::Vector3d b,
                           const Eigen::Matrix3d& covariance) {
  if (a.dot(b) < 0.0) b = -b;
  // Across the direction in the middle, so that it does not matter which one is named first.
  const Eigen::Vector3d middle_way = (a + b).normalized();
  const Eigen::Vector3d u = middle_way.unitOrthogonal();
  const Eigen::Vector3d v = middle_way.cross(u);
  const Eigen::Vector3d step = b - a;
  const double length = std::hypot(step.dot(u), step.dot(v));
  const double scale = length > 1e-12 ? std::atan2(a.cross(b).norm(), a.dot(b)) / length : 1.0;
  const double uu = u.dot(covariance * u), vv = v.dot(covariance * v), uv = u.dot(covariance * v);
  const double turn = 0.5 * std::atan2(2.0 * uv, uu - vv);
  const double c = std::cos(turn), s = std::sin(turn);
  const double middle = 0.5 * (uu + vv), half = std::hypot(0.5 * (uu - vv), uv);
  const Eigen::Vector2d t = scale * Eigen::Vector2d(step.dot(u), step.dot(v));
  return {{c * t.x() + s * t.y(), c * t.y() - s * t.x()},
          {std::sqrt(std::max(0.0, middle + half)), std::sqrt(std::max(0.0, middle - half))}};
}

/// How often two directions of a room make which angle: exactly parallel or at right angles, nearly
/// so (things are put down a little askew), or anything.
struct AnglePrior {
  double parallel, nearly_parallel, orthogonal, nearly_orthogonal, any;
};
AnglePrior between_faces(const RelationModel& m) {
  return {m.faces_parallel, m.faces_nearly_parallel, m.faces_orthogonal, m.faces_nearly_orthogonal,
          1.0 - m.faces_parallel - m.faces_nearly_parallel - m.faces_orthogonal -
              m.faces_nearly_orthogonal};
}
AnglePrior to_gravity(const RelationModel& m) {
  return {m.level_parallel, m.level_nearly_parallel, m.level_orthogonal, m.level_nearly_orthogonal,
          1.0 - m.level_parallel - m.level_nearly_parallel - m.level_orthogonal -
              m.level_nearly_orthogonal};
}

struct AngleLikelihoods {
  double parallel, orthogonal;
};

/// That the true angle is within a tolerance of 0 or 90 degrees. Measured: the tilt from parallel,
/// with one deviation each way, and the deviation of the angle itself.
AngleLikelihoods angle_likelihoods(const RelativeTilt& tilt, double off, double off_sigma,
                                   double lost, double tolerance, const AnglePrior& prior,
                                   const RelationModel& model) {
  const double angle_softness = radians(model.flatness);
  const double askew = radians(model.askew);
  AngleLikelihoods sum{0.0, 0.0};
  double all = 0.0;
  const double theta = tilt.mean.norm();
  // Of two planes as found, one in ten pairs holds one that lies quite otherwise: two sides of a
  // leg seen as one, a strip along an edge. The measured part of a deviation is five times as large
  // there.
  for (const double factor : {1.0, model.gross_factor}) {
    const double share =
        (1.0 - lost) * (factor > 1.0 ? model.gross_share : 1.0 - model.gross_share);
    const Eigen::Vector2d s(std::hypot(factor * tilt.sigma.x(), angle_softness),
                            std::hypot(factor * tilt.sigma.y(), angle_softness));
    const double so = std::hypot(factor * off_sigma, angle_softness);
    // Densities over the plane of tilts; what says nothing of the direction is spread over a
    // circle.
    const double circle = 2.0 * pi * std::hypot(theta, 0.5 * s.sum());
    const double flat = normal_density(tilt.mean.x(), s.x()) * normal_density(tilt.mean.y(), s.y());
    const double right = 2.0 * normal_density(off, so) / circle;
    const double near_flat = 2.0 * normal_density(theta, std::hypot(0.5 * s.sum(), askew)) / circle;
    const double near_right = 2.0 * normal_density(off, std::hypot(so, askew)) / circle;
    const double any = 2.0 / pi / circle;
    const double near_parallel = prior.nearly_parallel * near_flat;
    const double near_orthogonal = prior.nearly_orthogonal * near_right;
    const double anyway = prior.any * any;
    all += share * (prior.parallel * flat + prior.orthogonal * right + near_parallel +
                    near_orthogonal + anyway);
    sum.parallel += share * prior.parallel * flat;
    sum.orthogonal += share * prior.orthogonal * right;
    const double in_cone = tilt_likelihood(tilt.mean, s, tolerance);
    const double in_band = between_likelihood(off, -tolerance, tolerance, so);
    // Of what is nearly so, the true tilt is between the measured one and none.
    const Eigen::Array2d poor = s.array().square() / (s.array().square() + sqr(askew));
    const double in_cone_near = tilt_likelihood(((1.0 - poor) * tilt.mean.array()).matrix(),
                                                (askew * poor.sqrt()).matrix(), tolerance);
    const double poor_off = sqr(so) / (sqr(so) + sqr(askew));
    const double in_band_near = between_likelihood((1.0 - poor_off) * off, -tolerance, tolerance,
                                                   askew * std::sqrt(poor_off));
    sum.parallel += share * (near_parallel * in_cone_near + (anyway + near_orthogonal) * in_cone);
    sum.orthogonal += share * (near_orthogonal * in_band_near + (anyway + near_parallel) * in_band);
  }
  // What was measured of a plane that lies any way says nothing: what rooms are
  // like remains.
  const double any = lost / (pi * pi * std::hypot(theta, tilt.sigma.mean(), angle_softness));
  const double by_chance = prior.any * tolerance / (0.5 * pi);
  const double near = tolerance / askew;
  all += any;
  sum.parallel +=
      any * (prior.parallel + prior.nearly_parallel * -std::expm1(-0.5 * sqr(near)) + by_chance);
  sum.orthogonal += any * (prior.orthogonal +
                           prior.nearly_orthogonal * std::erf(near / std::sqrt(2.0)) + by_chance);
  if (all <= 0.0) return {0.0, 0.0};
  return {std::clamp(sum.parallel / all, 0.0, 1.0), std::clamp(sum.orthogonal / all, 0.0, 1.0)};
}

/// How likely a plane lies any way: few points within the noise turn it, and
/// the more its fit says that it may be turned, the likelier that it was.
double lost_share(double tilt_sigma, const RelationModel& model) {
  return std::min(most_lost, model.lost_planes * tilt_sigma);
}

struct PairAngle {
  AngleLikelihoods likelihoods;
  double theta, off, off_sigma;
};

PairAngle pair_angle(const Item& a, const Item& b, const RelationModel& model) {
  const double theta = angle_between(a.normal, b.normal);
  // Only the tilts within the plane of both normals change a right angle.
  const double variance =
      b.normal.dot(a.normal_covariance * b.normal) + a.normal.dot(b.normal_covariance * a.normal);
  const double off_sigma = std::sqrt(std::max(0.0, variance));
  const auto tilt = relative_tilt(a.normal, b.normal, a.normal_covariance + b.normal_covariance);
  const double found =
      (1.0 - lost_share(a.tilt_sigma, model)) * (1.0 - lost_share(b.tilt_sigma, model));
  return {angle_likelihoods(tilt, 0.5 * pi - theta, off_sigma, 1.0 - found, angle_tolerance,
                            between_faces(model), model),
          theta, 0.5 * pi - theta, off_sigma};
}

/// Of a direction against gravity.
AngleLikelihoods level(const Item& a, const Surrounding& around, double tolerance, double* theta,
                       double* off_sigma) {
  *theta = angle_between(a.normal, Eigen::Vector3d::UnitZ());
  *off_sigma = std::sqrt(std::max(0.0, a.normal_covariance(2, 2)) + sqr(around.up_sigma));
  const Eigen::Matrix3d covariance =
      a.normal_covariance + sqr(around.up_sigma) * Eigen::Matrix3d::Identity();
  return angle_likelihoods(relative_tilt(Eigen::Vector3d::UnitZ(), a.normal, covariance),
                           0.5 * pi - *theta, *off_sigma, lost_share(a.tilt_sigma, *around.model),
                           tolerance, to_gravity(*around.model), *around.model);
}

}  // namespace

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

Evidence parallel_relation(const Item& a, const Item& b, const RelationModel& model) {
  const PairAngle pair = pair_angle(a, b, model);
  return {pair.likelihoods.parallel, degrees(pair.theta),
          degrees(std::hypot(a.tilt_sigma, b.tilt_sigma)), "deg"};
}

Evidence orthogonal_relation(const Item& a, const Item& b, const RelationModel& model) {
  const PairAngle pair = pair_angle(a, b, model);
  return {pair.likelihoods.orthogonal, degrees(pair.theta), degrees(pair.off_sigma), "deg"};
}

Evidence horizontal(const Item& a, const Surrounding& around, double tolerance_deg) {
  double theta = 0.0, off_sigma = 0.0;
  const auto likelihoods = level(a, around, radians(tolerance_deg), &theta, &off_sigma);
  return {likelihoods.parallel, degrees(theta), degrees(std::hypot(a.tilt_sigma, around.up_sigma)),
          "deg"};
}

Evidence vertical(const Item& a, const Surrounding& around, double tolerance_deg) {
  double theta = 0.0, off_sigma = 0.0;
  const auto likelihoods = level(a, around, radians(tolerance_deg), &theta, &off_sigma);
  return {likelihoods.orthogonal, degrees(theta), degrees(off_sigma), "deg"};
}

}  // namespace scanchor
