// The whole chain on offices nobody looked at while the descriptions were written: what is found
// has to stay found.

#include <gtest/gtest.h>

#include "eval/evaluate.hpp"
#include "eval/objects.hpp"
#include "eval/run.hpp"
#include "perception/perceive.hpp"
#include "scenes/classes.hpp"
#include "sensors/tilting_lidar.hpp"
#include "sim/world.hpp"

namespace scanchor {
namespace {

class Chain : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    Suite suite;
    suite.name = "chain";
    suite.seed = 700;
    suite.scenes = 10;
    suite.split = {0.0, 1.0, 0.0};
    suite.lidar.range_sigma = 0.01;
    RunOptions options;
    options.split = "valid";
    result = new RunResult(run_suite(
        suite, own_method({}, find_ontology(SCANCHOR_SOURCE_DIR "/ontologies/office.sdl"), {}),
        options));
  }
  static void TearDownTestSuite() {
    delete result;
    result = nullptr;
  }

  static ObjectCounts of(const std::string& name) {
    return result->pooled.objects.classes.at(static_cast<std::size_t>(find_class(name).value()));
  }

  static RunResult* result;
};

RunResult* Chain::result = nullptr;

TEST_F(Chain, FindsWhatBoundsTheRoom) {
  EXPECT_GE(of("floor").recall(), 0.95);
  EXPECT_GE(of("floor").precision(), 0.95);
  EXPECT_GE(of("ceiling").recall(), 0.9);
  EXPECT_GE(of("wall").recall(), 0.9);
}

// Rooms full of things that hide each other. Measured on 84 rooms of seeds 50, 60000, 71000 and
// 72000: desks 41 to 58 %, monitors 70 to 95 %, shelves 40 to 55 %, cabinets 61 to 83 %, chairs 80
// to 83 %, radiators 85 to 95 % found; the limits leave room for chance in a dozen others.
TEST_F(Chain, FindsFurnitureInFullRooms) {
  const auto found = [](const char* name) {
    return std::string(name) + ": " + std::to_string(of(name).found) + " of " +
           std::to_string(of(name).truths);
  };
  EXPECT_GE(of("desk").recall(), 0.3) << found("desk");
  EXPECT_GE(of("monitor").recall(), 0.5) << found("monitor");
  EXPECT_GE(of("monitor").precision(), 0.7);
  EXPECT_GE(of("shelf").recall(), 0.2) << found("shelf");
  EXPECT_GE(of("cabinet").recall(), 0.4) << found("cabinet");
  EXPECT_GE(of("cabinet").precision(), 0.5);
  EXPECT_GE(of("chair").recall(), 0.6) << found("chair");
  EXPECT_GE(of("radiator").recall(), 0.7) << found("radiator");
  EXPECT_GE(result->pooled.objects.total().precision(), 0.65);
}

// A room by hand in which nothing hides anything. Where two screens meet at 12 degrees the plane of
// one takes points of the other in one scan of ten, so one of eight may fail, and only there.
TEST(PlainOffice, FloorDeskBothMonitorsAndShelfAreFound) {
  const Scene scene = read_scene(SCANCHOR_SOURCE_DIR "/scenes/examples/plain_office.json");
  const World world(scene);
  const Ontology ontology = find_ontology(SCANCHOR_SOURCE_DIR "/ontologies/office.sdl");
  const Protocol protocol = find_protocol("scanchor-1");
  LidarOptions lidar;
  lidar.range_sigma = 0.01;
  int complete = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Scan scan = scan_room(world, scene.sensor_poses.front(), lidar, seed);
    const Surfaces surfaces = perceive(scan.cloud, {});
    const ObjectSummary summary =
        summarize_objects(scan, &scene, surfaces, reason(surfaces, ontology, {}), protocol,
                          classes_of_labels(ontology.class_names()));
    int monitors = 0;
    for (const auto& thing : summary.things) {
      const std::string_view name = class_info(static_cast<ClassId>(thing.class_id)).name;
      if (name == "monitor" && thing.status == ThingStatus::found) ++monitors;
      if (name == "floor" || name == "desk" || name == "shelf") {
        EXPECT_EQ(thing.status, ThingStatus::found) << thing.name << ", noise " << seed;
      }
    }
    EXPECT_GE(monitors, 1) << "noise " << seed;
    EXPECT_GE(summary.score.total().precision(), 0.8) << "noise " << seed;
    if (monitors == 2) ++complete;
  }
  EXPECT_GE(complete, 7) << "scans in which both monitors were found";
}

}  // namespace
}  // namespace scanchor
