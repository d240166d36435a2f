#include "eval/segments.hpp"

#include <gtest/gtest.h>

namespace scanchor {
namespace {

ClassRules rules_of() {
  ClassRules rules;
  rules.names = {"unlabelled", "stuff", "thing"};
  rules.scored = {0, 1, 1};
  rules.thing = {0, 0, 1};
  rules.counted_as = {0, 1, 2};
  return rules;
}

struct Columns {
  std::vector<std::int32_t> tc, ti, sc, si;
  std::vector<float> confidence;
  void add(int n, int t, int i, int s, int j, float c = 1.0F) {
    for (int k = 0; k < n; ++k)
      tc.push_back(t), ti.push_back(i), sc.push_back(s), si.push_back(j), confidence.push_back(c);
  }
  [[nodiscard]] Segments make(const Protocol& protocol,
                              std::vector<std::int32_t> ignored = {}) const {
    return make_segments({tc, ti}, {sc, si}, confidence, ignored, rules_of(), protocol);
  }
};

TEST(Segments, StuffIsOneSegmentAndThingsAreMany) {
  Columns c;
  c.add(10, 1, 5, 1, 8);
  c.add(10, 1, 6, 1, 9);
  c.add(10, 2, 7, 2, 1, 0.5F);
  c.add(10, 2, 8, 2, 2, 0.7F);
  Protocol protocol = find_protocol("coco");
  const Segments s = c.make(protocol);
  ASSERT_EQ(s.truth.size(), 3U);
  ASSERT_EQ(s.predicted.size(), 3U);
  EXPECT_EQ(s.truth[0].points, 20);
  EXPECT_FLOAT_EQ(s.predicted[2].confidence, 0.7F);
  protocol.merge_stuff = false;
  EXPECT_EQ(c.make(protocol).predicted.size(), 4U);
}

TEST(Segments, PointsWithoutInstanceFollowTheProtocol) {
  Columns c;
  c.add(10, 2, 1, 2, -1);
  Protocol protocol = find_protocol("coco");
  EXPECT_TRUE(c.make(protocol).predicted.empty());
  protocol.no_instance = "segment";
  EXPECT_EQ(c.make(protocol).predicted.size(), 1U);
}

TEST(Segments, VoidIsCountedOrRemoved) {
  Columns c;
  c.add(30, 0, -1, 2, 1);
  c.add(10, 2, 3, 2, 1);
  Protocol protocol = find_protocol("coco");
  Segments s = c.make(protocol);
  EXPECT_EQ(s.predicted[0].points, 40);
  EXPECT_EQ(s.predicted[0].void_points, 30);
  EXPECT_DOUBLE_EQ(segment_iou(s, s.overlaps[0], protocol), 1.0);
  protocol.void_points = "remove";
  s = c.make(protocol);
  EXPECT_EQ(s.predicted[0].points, 10);
  EXPECT_DOUBLE_EQ(segment_iou(s, s.overlaps[0], protocol), 1.0);
}

TEST(Segments, IgnoredTruthIsVoidForClaimsOfOthersAndKeepsItsOwnOverlap) {
  Columns c;
  c.add(100, 2, 1, 2, 1);
  c.add(20, 2, 2, 2, 1);
  const Protocol protocol = find_protocol("coco");
  const Segments s = c.make(protocol, {2});
  EXPECT_FALSE(s.truth[0].ignored);
  EXPECT_TRUE(s.truth[1].ignored);
  EXPECT_EQ(s.predicted[0].void_points, 20);
  EXPECT_DOUBLE_EQ(segment_iou(s, s.overlaps[0], protocol), 1.0);
  EXPECT_DOUBLE_EQ(segment_iou(s, s.overlaps[1], protocol), 20.0 / 120.0);
}

}  // namespace
}  // namespace scanchor
