#include "scenes/relations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/random.hpp"
#include "scenes/generator.hpp"
#include "scenes/pose.hpp"
#include "tests/scenes/support/scene_checks.hpp"

namespace scanchor {
namespace {

using testing::boards;

const Eigen::Vector3d origin = Eigen::Vector3d::Zero();

RelationMargin between(const Scene& scene, SpatialRelation relation, std::size_t a = 0,
                       std::size_t b = 1, const Eigen::Vector3d& from = origin) {
  return relate(instance_body(scene, a), instance_body(scene, b), relation, from);
}

TEST(Relations, NamesReadBack) {
  for (std::size_t i = 0; i < relation_count; ++i) {
    const auto relation = static_cast<SpatialRelation>(i);
    EXPECT_EQ(find_relation(relation_name(relation)), relation);
    EXPECT_EQ(inverse(inverse(relation)), relation);
  }
  EXPECT_FALSE(find_relation("beside").has_value());
}

TEST(Relations, AnglesAreMeasuredInDegrees) {
  const Eigen::Vector3d size(1.0, 0.6, 0.02);
  for (const double deg : {0.0, 1.0, 4.0, 4.999, 5.001, 30.0, 85.5, 90.0}) {
    const Scene scene = boards(
        {{size, pose_at({0, 0, 0})}, {size, pose_at({0, 0, 1}, rotation_about(0, radians(deg)))}});
    EXPECT_NEAR(between(scene, SpatialRelation::parallel).value, deg, 1e-6);
    EXPECT_EQ(between(scene, SpatialRelation::parallel).holds(), deg <= 5.0) << deg;
    EXPECT_NEAR(between(scene, SpatialRelation::orthogonal).value, 90 - deg, 1e-6);
    EXPECT_EQ(between(scene, SpatialRelation::orthogonal).holds(), deg >= 85.0) << deg;
  }
  const Scene half = boards(
      {{size, pose_at({0, 0, 0})}, {size, pose_at({0, 0, 1}, rotation_about(1, radians(2.5)))}});
  EXPECT_NEAR(between(half, SpatialRelation::parallel).margin, 0.5, 1e-9);
}

TEST(Relations, AboveNeedsHeightAndOverlap) {
  const Eigen::Vector3d table(1.6, 0.8, 0.02);
  const Eigen::Vector3d box(0.3, 0.2, 0.2);
  Scene scene = boards({{box, pose_at({0, 0, 1.2})}, {table, pose_at({0, 0, 0.7})}});
  EXPECT_TRUE(between(scene, SpatialRelation::above).holds());
  EXPECT_TRUE(between(scene, SpatialRelation::below, 1, 0).holds());
  EXPECT_FALSE(between(scene, SpatialRelation::above, 1, 0).holds());
  // Moved aside until less than 30 % is over the table (and 5 cm around it).
  scene.instances[0].T_world_instance = pose_at({0.8 + 0.05 + 0.15 - 0.3 * 0.3 + 0.01, 0, 1.2});
  EXPECT_FALSE(between(scene, SpatialRelation::above).holds());
  scene.instances[0].T_world_instance = pose_at({0.8 + 0.05 + 0.15 - 0.3 * 0.3 - 0.01, 0, 1.2});
  EXPECT_TRUE(between(scene, SpatialRelation::above).holds());
  EXPECT_LT(between(scene, SpatialRelation::above).margin, 0.1);
}

TEST(Relations, OnNeedsContactWithinTheGap) {
  const Eigen::Vector3d table(1.6, 0.8, 0.02);
  const Eigen::Vector3d box(0.3, 0.2, 0.2);
  for (const double gap : {-0.029, 0.0, 0.06, 0.149, 0.151, 0.5}) {
    const Scene scene =
        boards({{box, pose_at({0, 0, 0.71 + 0.1 + gap})}, {table, pose_at({0, 0, 0.7})}});
    EXPECT_EQ(between(scene, SpatialRelation::on).holds(), gap <= 0.15) << gap;
    EXPECT_EQ(between(scene, SpatialRelation::supports, 1, 0).holds(), gap <= 0.15) << gap;
    EXPECT_NEAR(between(scene, SpatialRelation::on).value, gap, 1e-9);
  }
}

TEST(Relations, InsideAShelfAndNotTheOtherWay) {
  Scene scene;
  Instance shelf =
      make_furniture(scene, {"shelf",
                             "with sides",
                             1,
                             {{"boards", 4}, {"width", 1.0}, {"depth", 0.4}, {"spacing", 0.4}},
                             0.0});
  shelf.id = 1;
  Instance box = make_furniture(
      scene, {"box", "closed", 1, {{"width", 0.3}, {"depth", 0.2}, {"height", 0.2}}, 0.0});
  box.id = 2;
  box.T_world_instance = pose_at({0, 0, 0.5});
  scene.instances = {box, shelf};
  EXPECT_TRUE(between(scene, SpatialRelation::inside).holds());
  EXPECT_FALSE(between(scene, SpatialRelation::inside, 1, 0).holds());
  scene.instances[0].T_world_instance = pose_at({0, -0.3, 0.5});
  EXPECT_FALSE(between(scene, SpatialRelation::inside).holds());
}

// Analytic gaps: faces, edges and corners against each other.
TEST(Relations, NearMeasuresTheGap) {
  const Eigen::Vector3d unit(1, 1, 1);
  const struct {
    Eigen::Isometry3d pose;
    double gap;
  } table[] = {{pose_at({1.4, 0.2, 0}), 0.4},
               {pose_at({1.3, 1.4, 0}), 0.5},
               {pose_at({1.2, 1.3, 1.6}), 0.7},
               {pose_at({1.0 + 0.5 * std::sqrt(2.0), 0, 0}, 0.25 * pi), 0.5},
               {pose_at({0.3, 0, 0}), 0.0}};
  for (const auto& row : table) {
    const Scene scene = boards({{unit, pose_at({0, 0, 0})}, {unit, row.pose}});
    EXPECT_NEAR(between(scene, SpatialRelation::near).value, row.gap, 1e-6);
    EXPECT_NEAR(between(scene, SpatialRelation::near).margin, 1.0 - row.gap / 0.5, 1e-6);
  }
}

TEST(Relations, SameSizeComparesLengthAndArea) {
  const auto of = [](double length, double width) {
    return boards(
        {{{1.0, 0.5, 0.02}, pose_at({0, 0, 0})}, {{length, width, 0.02}, pose_at({0, 0, 1})}});
  };
  EXPECT_NEAR(between(of(1.0, 0.5), SpatialRelation::same_size).margin, 1.0, 1e-9);
  EXPECT_TRUE(between(of(1.14, 0.5), SpatialRelation::same_size).holds());
  EXPECT_FALSE(between(of(1.16, 0.5), SpatialRelation::same_size).holds());
  EXPECT_FALSE(between(of(1.0, 0.63), SpatialRelation::same_size).holds());
}

TEST(Relations, AlignedBoardsHaveOneVerticalAxis) {
  const Eigen::Vector3d size(1.0, 0.4, 0.02);
  EXPECT_TRUE(between(boards({{size, pose_at({0, 0, 0})}, {size, pose_at({0.14, 0, 1})}}),
                      SpatialRelation::vertically_aligned)
                  .holds());
  EXPECT_FALSE(between(boards({{size, pose_at({0, 0, 0})}, {size, pose_at({0.16, 0, 1})}}),
                       SpatialRelation::vertically_aligned)
                   .holds());
  EXPECT_FALSE(between(boards({{size, pose_at({0, 0, 0})}, {size, pose_at({0, 0, 1}, 0.5 * pi)}}),
                       SpatialRelation::vertically_aligned)
                   .holds());
}

TEST(Relations, CoplanarNeedsAngleAndOffset) {
  const Eigen::Vector3d size(1.0, 0.02, 0.8);
  EXPECT_TRUE(between(boards({{size, pose_at({0, 0, 0})}, {size, pose_at({2, 0.029, 0})}}),
                      SpatialRelation::coplanar)
                  .holds());
  EXPECT_FALSE(between(boards({{size, pose_at({0, 0, 0})}, {size, pose_at({2, 0.031, 0})}}),
                       SpatialRelation::coplanar)
                   .holds());
  EXPECT_FALSE(between(boards({{size, pose_at({0, 0, 0})}, {size, pose_at({0.01, 0, 0}, 0.2)}}),
                       SpatialRelation::coplanar)
                   .holds());
}

TEST(Relations, SidesAreSeenFromTheViewpoint) {
  // The viewer at the origin looks along +x at the target.
  const Eigen::Vector3d size(0.2, 0.2, 0.2);
  const auto at = [&](double x, double y) {
    return boards({{size, pose_at({x, y, 0})}, {size, pose_at({3, 0, 0})}});
  };
  EXPECT_NEAR(between(at(3, 1), SpatialRelation::left_of).margin, 1.0, 1e-9);
  EXPECT_NEAR(between(at(3, -1), SpatialRelation::right_of).margin, 1.0, 1e-9);
  EXPECT_NEAR(between(at(2, 0), SpatialRelation::in_front_of).margin, 1.0, 1e-9);
  EXPECT_NEAR(between(at(4, 0), SpatialRelation::behind).margin, 1.0, 1e-9);
  EXPECT_FALSE(between(at(3, 1), SpatialRelation::right_of).holds());
  EXPECT_NEAR(between(at(4, 1), SpatialRelation::left_of).margin, 0.0, 1e-9)
      << "on the border of two cones";
}

// Over whole scenes: symmetric, antisymmetric and inverse relations are what they are called; above
// and on are acyclic.
TEST(Relations, KeepTheirLawsInRooms) {
  for (const auto& family :
       {std::string("office"), std::string("laboratory"), std::string("living room")}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      RoomOptions options;
      options.family = family;
      const Scene scene = generate_room(options, seed);
      std::vector<RelationBody> bodies;
      for (std::size_t i = 0; i < scene.instances.size() && i < 40; ++i)
        bodies.push_back(instance_body(scene, i));
      const Eigen::Vector3d from = scene.sensor_poses[0].translation();
      const auto holds = [&](std::size_t i, std::size_t j, SpatialRelation r) {
        return relate(bodies[i], bodies[j], r, from).holds();
      };
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = 0; j < bodies.size(); ++j) {
          if (i == j) continue;
          for (std::size_t k = 0; k < relation_count; ++k) {
            const auto r = static_cast<SpatialRelation>(k);
            if (inverse(r) == r && !is_symmetric(r)) continue;
            if (r == SpatialRelation::near && (i + j) % 5 != 0)
              continue;  // costly: a sample of the pairs
            EXPECT_NEAR(relate(bodies[i], bodies[j], r, from).margin,
                        relate(bodies[j], bodies[i], inverse(r), from).margin, 1e-6);
          }
          EXPECT_FALSE(holds(i, j, SpatialRelation::above) && holds(j, i, SpatialRelation::above));
          EXPECT_FALSE(holds(i, j, SpatialRelation::on) && holds(j, i, SpatialRelation::on));
          EXPECT_FALSE(holds(i, j, SpatialRelation::inside) &&
                       holds(j, i, SpatialRelation::inside));
          EXPECT_FALSE(holds(i, j, SpatialRelation::left_of) &&
                       holds(i, j, SpatialRelation::right_of));
          if (holds(i, j, SpatialRelation::above)) {
            EXPECT_GT(bodies[i].center.z(), bodies[j].center.z());
          }
          // Three in a chain: heights add up, and parallel within the sum of the angles.
          for (std::size_t k = 0; k < bodies.size(); k += 7) {
            if (k == i || k == j) continue;
            if (holds(i, j, SpatialRelation::above) && holds(j, k, SpatialRelation::above)) {
              EXPECT_FALSE(holds(k, i, SpatialRelation::above));
            }
            // Things without a plane (plants, cups) have no angle to anything.
            if (!bodies[i].has_face || !bodies[j].has_face || !bodies[k].has_face) continue;
            const double ij = relate(bodies[i], bodies[j], SpatialRelation::parallel, from).value;
            const double jk = relate(bodies[j], bodies[k], SpatialRelation::parallel, from).value;
            EXPECT_LE(relate(bodies[i], bodies[k], SpatialRelation::parallel, from).value,
                      ij + jk + 1e-5);
          }
        }
      }
    }
  }
}

TEST(Relations, TurningTheWholeSceneChangesNothing) {
  const Scene scene = generate_room({}, 4);
  Scene turned = scene;
  const Eigen::Isometry3d T = pose_at({10, -3, 0}, 0.7);
  for (auto& instance : turned.instances) instance.T_world_instance = T * instance.T_world_instance;
  for (auto& pose : turned.sensor_poses) pose = T * pose;
  const auto a = instance_relations(scene);
  const auto b = instance_relations(turned);
  std::set<std::tuple<int, int, int>> first;
  std::set<std::tuple<int, int, int>> second;
  for (const auto& f : a) {
    if (f.value.margin > 0.05) first.insert({f.a, f.b, static_cast<int>(f.relation)});
  }
  for (const auto& f : b) second.insert({f.a, f.b, static_cast<int>(f.relation)});
  // `inside` and the bounding box's middle depend on the axes; the geometric relations do not.
  int missing = 0;
  for (const auto& f : first) {
    const auto r = static_cast<SpatialRelation>(std::get<2>(f));
    if (r == SpatialRelation::parallel || r == SpatialRelation::orthogonal ||
        r == SpatialRelation::near || r == SpatialRelation::same_size ||
        r == SpatialRelation::coplanar || r == SpatialRelation::on)
      missing += second.count(f) == 0 ? 1 : 0;
  }
  EXPECT_EQ(missing, 0);
  EXPECT_GT(first.size(), 100U);
}

}  // namespace
}  // namespace scanchor
