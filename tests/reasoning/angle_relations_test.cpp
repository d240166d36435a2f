#include "reasoning/angle_relations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/math.hpp"
#include "core/random.hpp"
#include "reasoning/relation_model.hpp"

namespace scanchor {
namespace {

const RelationModel usual_angles;  // whatever was fitted

Item item_facing(const Eigen::Vector3d& normal, const Eigen::Matrix3d& covariance) {
  Item made;
  made.normal = normal;
  made.normal_covariance = covariance;
  made.tilt_sigma = std::sqrt(0.5 * covariance.trace());
  return made;
}

Eigen::Matrix3d about_z(double sigma_deg) {
  // Tilts of a face that looks along x: about the vertical its normal moves along y.
  return std::pow(radians(sigma_deg), 2) * Eigen::Vector3d::UnitY() *
         Eigen::Vector3d::UnitY().transpose();
}

Eigen::Vector3d turned(double deg) { return {std::cos(radians(deg)), std::sin(radians(deg)), 0.0}; }

TEST(AngleRelations, ANarrowStripMayTurnAboutItsLongAxisOnly) {
  const Item wall = item_facing(Eigen::Vector3d::UnitX(), Eigen::Matrix3d::Zero());
  const Eigen::Vector3d leaning(std::cos(radians(15)), 0.0, std::sin(radians(15)));
  EXPECT_GT(parallel_relation(wall, item_facing(turned(15), about_z(10)), usual_angles).likelihood,
            0.2);
  EXPECT_LT(parallel_relation(wall, item_facing(leaning, about_z(10)), usual_angles).likelihood,
            0.1);
  EXPECT_LT(parallel_relation(wall, item_facing(turned(15), about_z(1)), usual_angles).likelihood,
            0.1);
}

TEST(AngleRelations, ARightAngleNeedsTheTiltInThePlaneOfBoth) {
  const Item wall = item_facing(turned(0), about_z(8));
  const Item floor = item_facing(Eigen::Vector3d::UnitZ(), Eigen::Matrix3d::Zero());
  EXPECT_GT(orthogonal_relation(wall, floor, usual_angles).likelihood, 0.99)
      << "turned, it stays upright";
  EXPECT_LT(orthogonal_relation(wall, item_facing(turned(80), about_z(0)), usual_angles).likelihood,
            0.9);
}

TEST(AngleRelations, OfAPlaneThatIsHardlyKnownNothingIsSure) {
  // Measured at a right angle to the dot, but by a strip that may lie any way.
  const Eigen::Matrix3d vague = std::pow(radians(15.0), 2) * Eigen::Matrix3d::Identity();
  const Item wall = item_facing(turned(0), about_z(0.1));
  const Item strip = item_facing(turned(90), vague);
  RelationModel none = usual_angles, many = usual_angles;
  none.lost_planes = 0.0;
  many.lost_planes = 2.0;
  EXPECT_LT(orthogonal_relation(wall, strip, many).likelihood,
            orthogonal_relation(wall, strip, none).likelihood);
  const Item sure = item_facing(turned(90), about_z(0.1));
  EXPECT_GT(orthogonal_relation(wall, sure, many).likelihood, 0.99);
}

TEST(AngleRelations, SumToAtMostOne) {
  SequentialRandom random(5);
  for (int i = 0; i < 500; ++i) {
    const Item a = item_facing(turned(0), about_z(random.uniform(0, 30)));
    const Item b = item_facing(turned(random.uniform(0, 90)), about_z(random.uniform(0, 30)));
    const double sum = parallel_relation(a, b, usual_angles).likelihood +
                       orthogonal_relation(a, b, usual_angles).likelihood;
    EXPECT_LE(sum, 1.002);  // each is rounded up a little where hardly anything is known
    EXPECT_GE(sum, 0.0);
  }
}

// Directions drawn as in rooms, measured with known deviations: what is said has to hold as often.
TEST(AngleRelations, AreCalibratedOnDirectionsOfRooms) {
  SequentialRandom random(6);
  std::array<double, 10> said{}, held{};
  int all = 0;
  for (int i = 0; i < 20000; ++i) {
    const double draw = random.uniform(0.0, 1.0);
    const double angle = draw < 0.07   ? 0.0
                         : draw < 0.16 ? std::abs(3.0 * random.normal())
                         : draw < 0.53 ? 90.0
                         : draw < 0.63 ? 90.0 - std::abs(3.0 * random.normal())
                                       : random.uniform(0.0, 90.0);
    const double sigma = random.uniform(0.2, 8.0);
    const double wide = random.chance(0.05) ? 5.0 : 1.0;
    // Turned in any direction, then measured off in any direction.
    const auto turn = [&](const Eigen::Vector3d& n, const Eigen::Vector2d& by) {
      const Eigen::Vector3d u = n.unitOrthogonal(), v = n.cross(u);
      const double angle_by = by.norm();
      if (angle_by < 1e-12) return n;
      const Eigen::Vector3d way = (u * by.x() + v * by.y()) / angle_by;
      return Eigen::Vector3d(std::cos(angle_by) * n + std::sin(angle_by) * way);
    };
    const double way = random.uniform(0.0, 2.0 * pi);
    const Eigen::Vector3d exact = turn(
        Eigen::Vector3d::UnitX(), radians(angle) * Eigen::Vector2d(std::cos(way), std::sin(way)));
    const Eigen::Vector3d found =
        turn(exact, wide * radians(sigma) * Eigen::Vector2d(random.normal(), random.normal()));
    const Item wall = item_facing(turned(0), Eigen::Matrix3d::Zero());
    const Item other =
        item_facing(found, std::pow(radians(sigma), 2) *
                               (Eigen::Matrix3d::Identity() - found * found.transpose()));
    const double p = parallel_relation(wall, other, usual_angles).likelihood;
    if (p < 0.05) continue;
    const auto bin = static_cast<std::size_t>(std::min(9.0, 10.0 * p));
    said[bin] += p;
    held[bin] += angle <= 5.0 ? 1.0 : 0.0;
    ++all;
  }
  double off = 0.0;
  for (std::size_t k = 0; k < 10; ++k) off += std::abs(said[k] - held[k]);
  EXPECT_GT(all, 1000);
  EXPECT_LT(off / all, 0.08);
}

}  // namespace
}  // namespace scanchor
