// The whole chain on offices nobody looked at while the descriptions were written: what is found
// has to stay found.

#include <gtest/gtest.h>

#include "eval/run.hpp"
#include "scenes/classes.hpp"

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
  EXPECT_GE(of("floor").recall(), 0.9);
  EXPECT_GE(of("floor").precision(), 0.9);
  EXPECT_GE(of("ceiling").recall(), 0.9);
  EXPECT_GE(of("wall").recall(), 0.7);
}

// Measured on 12 rooms of suite seed 50: desks 36 %, monitors 41 %, radiators 60 % found; the
// limits leave room for chance in ten other rooms. Shelves are not held here: 1 of 21 was found in
// 24 rooms (docs/why/semantics.md).
TEST_F(Chain, FindsDesksAndWhatStandsOnThem) {
  EXPECT_GE(of("desk").recall(), 0.25) << of("desk").found << " of " << of("desk").truths;
  EXPECT_GE(of("monitor").recall(), 0.3) << of("monitor").found << " of " << of("monitor").truths;
  EXPECT_GE(of("monitor").precision(), 0.8);
  EXPECT_GE(of("radiator").recall(), 0.4)
      << of("radiator").found << " of " << of("radiator").truths;
}

}  // namespace
}  // namespace scanchor
