// Rays against the mesh kinds of the catalogue, through CGAL's AABB tree: another author, another
// algorithm, double precision.

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <boost/variant/get.hpp>

#include "scenes/catalogue.hpp"
#include "sim/world.hpp"
#include "tests/sim/support/boxes.hpp"

namespace scanchor {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

TEST(WorldMeshes, AgreeWithCgalOnEveryKindThatIsNoBox) {
  Scene scene = testing::empty_scene();
  scene.instances.clear();
  int kinds = 0;
  for (const KindInfo& kind : furniture_kinds()) {
    FurnitureRequest request;
    request.kind = kind.name;
    Instance instance = make_furniture(scene, request);
    bool curved = false;
    for (const Part& part : instance.parts) {
      for (const Face& face : part.faces) curved = curved || !face.planar;
    }
    if (!curved) continue;
    // Far enough apart that none touches another.
    instance.T_world_instance = testing::at(5.0 * (kinds % 5), 5.0 * (kinds / 5), 0.0) *
                                Eigen::AngleAxisd(0.3 * kinds, Eigen::Vector3d::UnitZ());
    instance.id = ++kinds;
    scene.instances.push_back(instance);
  }
  ASSERT_GE(kinds, 5);
  const World world(scene);
  Triangles triangles;
  for (std::uint32_t t = 0; t < world.triangles().size(); ++t) {
    triangles.emplace_back(cgal(world.corner(t, 0)), cgal(world.corner(t, 1)),
                           cgal(world.corner(t, 2)));
  }
  const Tree tree(triangles.begin(), triangles.end());

  SequentialRandom random(61);
  std::vector<Ray> rays;
  for (int i = 0; i < 20000; ++i) {
    // From somewhere around a thing towards somewhere in it.
    const int which = static_cast<int>(random.below(static_cast<std::uint32_t>(kinds)));
    const Eigen::Vector3d foot(5.0 * (which % 5), 5.0 * (which / 5), 0.0);
    const Eigen::Vector3d from =
        foot + Eigen::Vector3d(0, 0, 0.8) + 2.3 * testing::random_direction(random);
    const Eigen::Vector3d to =
        foot + Eigen::Vector3d(random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4),
                               random.uniform(0.0, 1.2));
    rays.push_back({from, (to - from).normalized()});
  }
  std::vector<Hit> hits(rays.size());
  world.trace(rays, hits);
  int hit = 0, differ = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Kernel::Ray_3 ray(cgal(rays[i].origin), cgal(rays[i].origin + rays[i].direction));
    const auto found = tree.first_intersection(ray);
    const Kernel::Point_3* point = found ? boost::get<Kernel::Point_3>(&found->first) : nullptr;
    if ((point != nullptr) != (hits[i].triangle != no_hit)) {
      ++differ;
      continue;
    }
    if (point == nullptr) continue;
    ++hit;
    const double range = std::sqrt(CGAL::squared_distance(cgal(rays[i].origin), *point));
    // A ray that grazes an outline may be told either way; what is hit must be at the same range.
    if (std::fabs(range - hits[i].range) > 1e-6) ++differ;
  }
  EXPECT_GT(hit, 5000);
  EXPECT_LE(differ, 4);
}

}  // namespace
}  // namespace scanchor
