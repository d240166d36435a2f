#include "sim/settle.hpp"

#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "sim/bullet_shapes.hpp"
#include "sim/inside.hpp"

namespace scanchor {
namespace {

// Bullet keeps shapes apart by a margin; hulls are shrunk by it, so that the outside stays where
// the part's outside is.
constexpr double margin = 0.0005;  // [m]
constexpr double allowed_penetration =
    0.001;                             // [m] of issue and docs: nothing interpenetrates by more
constexpr double support_gap = 0.001;  // [m] nearer than this something is in contact

btVector3 to_bullet(const Eigen::Vector3d& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btTransform to_bullet(const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond q(T.linear());
  return btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                  static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                     to_bullet(T.translation()));
}

Eigen::Isometry3d from_bullet(const btTransform& transform) {
  const btQuaternion q = transform.getRotation();
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
  const btVector3& p = transform.getOrigin();
  T.translation() = Eigen::Vector3d(p.x(), p.y(), p.z());
  return T;
}

/// Bullet lets what is slow sleep after two seconds, a constant of the whole program; in the time
/// that a room takes to settle nothing would. What lies still for a tenth of a second sleeps, and
/// is woken by what bumps into it.
void sleep_early() {
  static std::once_flag once;
  std::call_once(once, [] { gDeactivationTime = btScalar(0.1); });
}

/// Everything Bullet needs, in an order of destruction that suits it: the world first, shapes last.
class Settling {
 public:
  Settling(Scene& scene, const SettleOptions& options);
  ~Settling();
  Settling(const Settling&) = delete;
  Settling& operator=(const Settling&) = delete;
  SettleReport run();

 private:
  struct Loose {
    std::size_t instance;
    btRigidBody* body;
    Eigen::Isometry3d T_instance_body;  // the body's origin is its centre of mass
    double radius;                   // [m] of the farthest corner, to weigh turning against moving
    btTransform before{};            // where it was when it was last looked at
    double speed = 0.0;              // [m/s] mean since then
    int awake = 0, carried = -1000;  // the last steps when it was awake, when something carried it
  };
  btCollisionShape* own(std::unique_ptr<btCollisionShape> shape);
  btCollisionShape* convex_shape(const Part& part, Eigen::Isometry3d& T_part_shape);
  btCollisionShape* triangle_shape(const Part& part);
  void add_fixed(const Instance& instance, const Eigen::AlignedBox3d& reach);
  void add_loose(std::size_t index);
  [[nodiscard]] bool all_rest(double seconds);
  [[nodiscard]] std::string name(const Loose& thing) const;
  [[nodiscard]] double deepest_penetration();
  void note_support(int step);

  Scene& scene_;
  const SettleOptions& options_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btTriangleMesh>> meshes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::vector<Loose> loose_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
};

Eigen::AlignedBox3d instance_box(const Instance& instance) {
  Eigen::AlignedBox3d box;
  for (const Part& part : instance.parts) {
    const Eigen::Isometry3d T = instance.T_world_instance * part.T_instance_part;
    for (const auto& v : part.vertices) box.extend(T * v);
  }
  return box;
}

Settling::Settling(Scene& scene, const SettleOptions& options) : scene_(scene), options_(options) {
  sleep_early();
  world_.setForceUpdateAllAabbs(false);
  world_.setGravity(btVector3(0, 0, btScalar(-9.81)));
  // Bullet chooses a solver with fused multiply-add where the processor has it; the scalar one is
  // the same everywhere.
  solver_.setConstraintRowSolverGeneric(solver_.getScalarConstraintRowSolverGeneric());
  solver_.setConstraintRowSolverLowerLimit(solver_.getScalarConstraintRowSolverLowerLimit());
  btContactSolverInfo& info = world_.getSolverInfo();
  info.m_numIterations = 20;
  // Any overlap is taken out by moving apart and never by a push that lets things hop.
  info.m_splitImpulse = 1;
  info.m_splitImpulsePenetrationThreshold = btScalar(-1e-5);
  info.m_erp2 = btScalar(0.4);
  dispatcher_.setDispatcherFlags(
      dispatcher_.getDispatcherFlags() &
      ~btCollisionDispatcher::CD_USE_RELATIVE_CONTACT_BREAKING_THRESHOLD);

  Eigen::AlignedBox3d reach;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    if (!scene.instances[i].loose) continue;
    reach.extend(instance_box(scene.instances[i]));
    add_loose(i);
  }
  if (loose_.empty()) return;
  // What falls may roll a little aside, and falls as deep as the floor.
  reach.min() -= Eigen::Vector3d(1.0, 1.0, 100.0);
  reach.max() += Eigen::Vector3d(1.0, 1.0, 0.5);
  for (const Instance& instance : scene.instances) {
    if (!instance.loose) add_fixed(instance, reach);
  }
}

Settling::~Settling() {
  for (auto& object : objects_) {
    if (auto* body = btRigidBody::upcast(object.get())) {
      world_.removeRigidBody(body);
    } else {
      world_.removeCollisionObject(object.get());
    }
  }
}

btCollisionShape* Settling::own(std::unique_ptr<btCollisionShape> shape) {
  shapes_.push_back(std::move(shape));
  return shapes_.back().get();
}

btCollisionShape* Settling::convex_shape(const Part& part, Eigen::Isometry3d& T_part_shape) {
  Eigen::AlignedBox3d box;
  for (const auto& v : part.vertices) box.extend(v);
  T_part_shape = Eigen::Isometry3d::Identity();
  if (is_box(part, box)) {
    T_part_shape.translation() = box.center();
    auto shape = std::make_unique<Padded<btBoxShape>>(to_bullet(0.5 * box.sizes()));
    shape->setMargin(static_cast<btScalar>(std::min(margin, 0.2 * box.sizes().minCoeff())));
    return own(std::move(shape));
  }
  std::vector<float> points;
  for (const auto& v : part.vertices) {
    for (int axis = 0; axis < 3; ++axis) points.push_back(static_cast<float>(v[axis]));
  }
  btConvexHullComputer hull;
  // The clamp keeps a plate thinner than two margins from turning inside out.
  const btScalar shrunk =
      hull.compute(points.data(), 3 * sizeof(float), static_cast<int>(part.vertices.size()),
                   static_cast<btScalar>(margin), btScalar(0.4));
  auto shape = std::make_unique<Padded<btConvexHullShape>>();
  for (int i = 0; i < hull.vertices.size(); ++i) shape->addPoint(hull.vertices[i], false);
  shape->recalcLocalAabb();
  shape->setMargin(std::max(shrunk, btScalar(1e-5)));
  return own(std::move(shape));
}

btCollisionShape* Settling::triangle_shape(const Part& part) {
  auto mesh = std::make_unique<btTriangleMesh>();
  for (const auto& t : part.triangles) {
    mesh->addTriangle(to_bullet(part.vertices[static_cast<std::size_t>(t[0])]),
                      to_bullet(part.vertices[static_cast<std::size_t>(t[1])]),
                      to_bullet(part.vertices[static_cast<std::size_t>(t[2])]));
  }
  auto shape = std::make_unique<btBvhTriangleMeshShape>(mesh.get(), true);
  shape->setMargin(btScalar(1e-5));
  meshes_.push_back(std::move(mesh));
  return own(std::move(shape));
}

void Settling::add_fixed(const Instance& instance, const Eigen::AlignedBox3d& reach) {
  for (const Part& part : instance.parts) {
    if (part.triangles.empty()) continue;
    const Eigen::Isometry3d T_world_part = instance.T_world_instance * part.T_instance_part;
    Eigen::AlignedBox3d box;
    for (const auto& v : part.vertices) box.extend(T_world_part * v);
    if (!box.intersects(reach)) continue;
    Eigen::Isometry3d T_part_shape = Eigen::Isometry3d::Identity();
    btCollisionShape* shape = part.convex ? convex_shape(part, T_part_shape) : triangle_shape(part);
    auto object = std::make_unique<btCollisionObject>();
    object->setCollisionShape(shape);
    object->setWorldTransform(to_bullet(T_world_part * T_part_shape));
    object->setFriction(btScalar(std::sqrt(options_.friction)));  // Bullet multiplies the two
    object->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
    world_.addCollisionObject(object.get(), btBroadphaseProxy::StaticFilter,
                              btBroadphaseProxy::AllFilter ^ btBroadphaseProxy::StaticFilter);
    // What is fixed sleeps: its bounds are not worked out anew in every step.
    object->forceActivationState(ISLAND_SLEEPING);
    objects_.push_back(std::move(object));
  }
}

void Settling::add_loose(std::size_t index) {
  const Instance& instance = scene_.instances[index];
  Bulk total;
  for (const Part& part : instance.parts) {
    const Bulk one = bulk(part);
    total.volume += one.volume;
    total.moment +=
        part.T_instance_part * one.moment + (one.volume - 1.0) * part.T_instance_part.translation();
  }
  Loose thing{index, nullptr, Eigen::Isometry3d::Identity(), 0.0, {}};
  Eigen::AlignedBox3d box;
  for (const Part& part : instance.parts) {
    for (const auto& v : part.vertices) box.extend(part.T_instance_part * v);
  }
  if (box.isEmpty()) return;
  // An open mesh has no volume to speak of: the middle of its box has to do.
  const Eigen::Vector3d mean = total.volume > 0.0 ? Eigen::Vector3d(total.moment / total.volume)
                                                  : Eigen::Vector3d(box.center());
  thing.T_instance_body.translation() = box.contains(mean) ? mean : Eigen::Vector3d(box.center());
  const Eigen::Isometry3d T_body_instance = thing.T_instance_body.inverse();
  thing.radius = 0.5 * box.diagonal().norm();

  auto compound = std::make_unique<btCompoundShape>(true, static_cast<int>(instance.parts.size()));
  for (const Part& part : instance.parts) {
    if (part.vertices.empty()) continue;
    Eigen::Isometry3d T_part_shape;
    btCollisionShape* shape = convex_shape(part, T_part_shape);
    compound->addChildShape(to_bullet(T_body_instance * part.T_instance_part * T_part_shape),
                            shape);
  }
  compound->setMargin(btScalar(margin));
  btVector3 inertia(0, 0, 0);
  const auto mass = static_cast<btScalar>(std::max(instance.mass, 1e-3));
  compound->calculateLocalInertia(mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, own(std::move(compound)), inertia);
  info.m_startWorldTransform = to_bullet(instance.T_world_instance * thing.T_instance_body);
  info.m_friction = btScalar(std::sqrt(options_.friction));
  info.m_rollingFriction = btScalar(0.02);  // lets cylinders and balls stop
  info.m_spinningFriction = btScalar(0.02);
  info.m_linearDamping = btScalar(0.05);
  info.m_angularDamping = btScalar(0.2);
  auto body = std::make_unique<btRigidBody>(info);
  body->setSleepingThresholds(btScalar(0.5 * options_.rest_speed),
                              btScalar(0.5 * options_.rest_speed / std::max(thing.radius, 0.01)));
  thing.body = body.get();
  thing.before = info.m_startWorldTransform;
  body->setUserIndex(static_cast<int>(loose_.size()));
  world_.addRigidBody(body.get());
  objects_.push_back(std::move(body));
  loose_.push_back(thing);
}

/// Looks at all things, `seconds` after the last time. What trembles on the spot is at rest: its
/// mean speed counts, not the speed of one step.
bool Settling::all_rest(double seconds) {
  bool rest = true;
  for (Loose& thing : loose_) {
    const btTransform& now = thing.body->getWorldTransform();
    const double turned = now.getRotation().angleShortestPath(thing.before.getRotation());
    const double moved = (now.getOrigin() - thing.before.getOrigin()).length();
    thing.speed = (moved + thing.radius * turned) / seconds;
    thing.before = now;
    rest = rest && thing.speed < options_.rest_speed;
  }
  return rest;
}

std::string Settling::name(const Loose& thing) const {
  const Instance& instance = scene_.instances[thing.instance];
  return fmt::format("{} {}", instance.kind.empty() ? "instance" : instance.kind, instance.id);
}

/// Deepest overlap of any two things where they are now.
double Settling::deepest_penetration() {
  for (const Loose& thing : loose_) thing.body->forceActivationState(ACTIVE_TAG);
  world_.performDiscreteCollisionDetection();
  double deepest = 0.0;
  for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
    const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(m);
    for (int p = 0; p < manifold->getNumContacts(); ++p)
      deepest = std::max(deepest, -double(manifold->getContactPoint(p).getDistance()));
  }
  return deepest;
}

/// Notes who lies on something in this step. Contacts come and go (a box a micrometre above another
/// has none), so what counts is the last time that a thing had one while it was awake.
void Settling::note_support(int step) {
  for (Loose& thing : loose_) {
    if (thing.body->isActive()) thing.awake = step;
  }
  for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
    const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(m);
    for (int p = 0; p < manifold->getNumContacts(); ++p) {
      const btManifoldPoint& point = manifold->getContactPoint(p);
      if (point.getDistance() > support_gap) continue;
      // The normal points from body 1 to body 0: up for what lies on top.
      const double up = point.m_normalWorldOnB.z();
      if (std::fabs(up) < 0.1) continue;
      const int on_top = (up > 0 ? manifold->getBody0() : manifold->getBody1())->getUserIndex();
      if (on_top >= 0) loose_[static_cast<std::size_t>(on_top)].carried = step;
    }
  }
}

SettleReport Settling::run() {
  SettleReport report;
  report.loose = loose_.size();
  if (loose_.empty()) {
    report.settled = true;
    return report;
  }
  const int limit = static_cast<int>(std::ceil(options_.maximum_time / options_.time_step));
  const int look = std::max(1, static_cast<int>(options_.rest_time / options_.time_step));
  int steps = 0;
  bool rest = false;
  while (!rest && steps < limit) {
    world_.stepSimulation(static_cast<btScalar>(options_.time_step), 0,
                          static_cast<btScalar>(options_.time_step));
    note_support(++steps);
    if (steps % look == 0) rest = all_rest(look * options_.time_step);
  }
  report.simulated_time = steps * options_.time_step;
  report.deepest_penetration = deepest_penetration();

  const bool bounded = !scene_.bounds.isEmpty();
  for (const Loose& thing : loose_) {
    Instance& instance = scene_.instances[thing.instance];
    instance.T_world_instance =
        from_bullet(thing.body->getWorldTransform()) * thing.T_instance_body.inverse();
    const Eigen::Vector3d center = instance.T_world_instance * thing.T_instance_body.translation();
    if (bounded && !Eigen::AlignedBox3d(scene_.bounds.min() - Eigen::Vector3d::Constant(0.05),
                                        scene_.bounds.max() + Eigen::Vector3d::Constant(0.05))
                        .contains(center)) {
      report.problems.push_back(fmt::format("{} fell out of the room", name(thing)));
    } else if (!rest && thing.speed >= options_.rest_speed) {
      report.problems.push_back(
          fmt::format("{} still moves at {:.3f} m/s", name(thing), thing.speed));
    } else if (thing.carried < thing.awake - look) {
      report.problems.push_back(fmt::format("{} hangs in the air", name(thing)));
    }
  }
  for (const Loose& thing : loose_) {
    const Instance& instance = scene_.instances[thing.instance];
    for (const Instance& other : scene_.instances) {
      if (!other.loose && other.kind != "wall" && sunk_into(instance, other, allowed_penetration))
        report.problems.push_back(
            fmt::format("{} has sunk into {} {}", name(thing), other.kind, other.id));
    }
  }
  if (report.deepest_penetration > allowed_penetration) {
    report.problems.push_back(
        fmt::format("things interpenetrate by {:.2f} mm", 1e3 * report.deepest_penetration));
  }
  report.settled = report.problems.empty();
  return report;
}

}  // namespace

void SettleOptions::describe(OptionList& list) {
  list.add("time_step", time_step, "s", "fixed step of the simulation", 1e-4, 0.02);
  list.add("maximum_time", maximum_time, "s",
           "simulated time after which a room counts as unsettled", 0.1, 60.0);
  list.add("rest_speed", rest_speed, "m/s", "below it a thing counts as at rest", 1e-4, 0.1);
  list.add("rest_time", rest_time, "s", "that everything must stay below rest_speed", 0.0, 10.0);
  list.add("friction", friction, "1", "Coulomb coefficient of every pair", 0.0, 2.0);
}

SettleReport settle(Scene& scene, const SettleOptions& options) {
  return Settling(scene, options).run();
}

}  // namespace scanchor
