#include "eval/region_surfaces.hpp"

#include <gtest/gtest.h>

#include "core/json.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

TEST(RegionSurfaces, RegionsAsFindPlanesMadeThemGiveTheSameSurfaces) {
  const SmallScan made = small_scan();
  const Surfaces ours = find_planes(made.scan.cloud, PerceiveOptions{});
  ASSERT_GE(ours.surfaces.size(), 3U);
  const Surfaces again =
      surfaces_of_regions(made.scan.cloud, PerceiveOptions{},
                          [&](const PointCloud&, double) { return ours.plane_of_point; });
  EXPECT_EQ(surfaces_to_json(again, true), surfaces_to_json(ours, true));
}

TEST(RegionSurfaces, TheNoiseThatWasGivenIsPassedOn) {
  const SmallScan made = small_scan();
  PerceiveOptions options;
  options.noise_sigma = 0.02;
  double told = 0.0;
  surfaces_of_regions(made.scan.cloud, options, [&](const PointCloud& cloud, double sigma) {
    told = sigma;
    return std::vector<std::int32_t>(cloud.size(), -1);
  });
  EXPECT_DOUBLE_EQ(told, 0.02);
}

TEST(RegionSurfaces, APeersMethodAnswersLikeOurs) {
  const SmallScan made = small_scan();
  const ScanTruth truth = truth_of(made.scan, &made.scene, Protocol{});
  const Method method = peer_method(
      "peer", [&](const PointCloud&, double) { return truth.plane; }, PerceiveOptions{},
      find_ontology("office"), ReasonOptions{});
  EXPECT_EQ(method.name.substr(0, 5), "peer/");
  EXPECT_FALSE(method.described.empty());
  const MethodAnswer answer = method.answer(made.scan, "small");
  ASSERT_TRUE(answer.surfaces && answer.labelling);
  EXPECT_FALSE(answer.surfaces->surfaces.front().polygons.empty());
  // Every point of a plane of the truth is in the surface of that plane and in no other.
  std::vector<std::int32_t> surface_of(truth.planes.size(), -1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto plane = truth.plane[i], surface = answer.points.plane[i];
    if (plane < 0 || surface < 0) continue;
    auto& first = surface_of[static_cast<std::size_t>(plane)];
    if (first < 0) first = surface;
    EXPECT_EQ(first, surface);
  }
}

}  // namespace
}  // namespace scanchor
