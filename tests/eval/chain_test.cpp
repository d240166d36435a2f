// The whole chain on offices nobody looked at while the descriptions were written: what is found has to stay found.

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
    result = new RunResult(run_suite(suite, own_method({}, find_ontology(SCANCHOR_SOURCE_DIR "/ontologies/office.sdl"), {}), options));
  }
  static void TearDownTestSuite() {
    delete result;
    result = nullptr;
  }

  static ObjectCounts of(const std::string& name) {
    return result->pooled.objects.classes.at(static_cast<std::size_t>(find_class(name)));
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

TEST_F(Chain, PrintsRates) {
  for (const auto* name : {"floor", "wall", "ceiling", "desk", "monitor", "shelf", "radiator"}) {
    const auto counts = of(name);
    std::printf("%-10s found %ld of %ld, wrong %ld\n", name, static_cast<long>(counts.found), static_cast<long>(counts.truths),
                static_cast<long>(counts.wrong + counts.repeated));
  }
}

}  // namespace
}  // namespace scanchor
